#pragma once

#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

/// Swept values and quantities as they stand in the canonical text of an experiment.
namespace rocking {

[[nodiscard]] SweptValue swept_value(const Json& value);
[[nodiscard]] Json json_of(const SweptValue& value);
/// The same as text: `4.5`, `"jy25"`.
[[nodiscard]] std::string json_text_of(const SweptValue& value);

/// Every place of an experiment that may have a law, whether it has one or not.
[[nodiscard]] const std::vector<NamedPlace>& places_of_quantities();

}  // namespace rocking

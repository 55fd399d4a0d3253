#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

/// Swept values, quantities and kinds of excitation as they stand in the canonical text of an experiment.
namespace rocking {

[[nodiscard]] SweptValue swept_value(const Json& value);
[[nodiscard]] Json json_of(const SweptValue& value);
/// The same as text: `4.5`, `"jy25"`.
[[nodiscard]] std::string json_text_of(const SweptValue& value);

/// Whether it is an object that gives a law.
[[nodiscard]] bool has_law(const Json& value);

/// A number or a law. Throws base::InputError where it is neither.
[[nodiscard]] Quantity quantity_in(const Json& value);

/// Every place of an experiment that may have a law, whether it has one or not.
[[nodiscard]] const std::vector<NamedPlace>& places_of_quantities();

/// What a base does under a kind of excitation, after "a base that"; empty for a name of no kind.
[[nodiscard]] std::string_view excitation_in_words(std::string_view kind);

}  // namespace rocking

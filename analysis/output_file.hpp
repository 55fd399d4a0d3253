#pragma once

#include <string>
#include <string_view>

#include "rocking/text/json.hpp"

/// Reading the output of other commands.
namespace rocking::analysis {

/// Parses JSON text with a format name. Throws base::InputError if it is not JSON or names no format.
[[nodiscard]] Json parsed_output(std::string_view text);

/// The format name of an output, such as `rocking.trajectory/1`.
[[nodiscard]] std::string format_of(const Json& output);

}  // namespace rocking::analysis

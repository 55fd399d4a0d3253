#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "rocking/report/json.hpp"

/// Reading what other commands print.
namespace rocking::analysis {

/// Parses JSON text that names its format. Throws base::InputError where it is none, or names none.
[[nodiscard]] report::Json parsed_output(std::string_view text);

/// Its format, as `rocking.trajectory/1`.
[[nodiscard]] std::string format_of(const report::Json& output);

/// Calls `read` and turns a key that is missing or of the wrong kind into base::InputError.
void read_or_refuse(const report::Json& output, const std::function<void()>& read);

}  // namespace rocking::analysis

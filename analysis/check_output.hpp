#pragma once

#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// Checks what a command printed before it is drawn: against the schema of its format, and for what its parts demand of
/// each other, such as lists of equal length. Throws base::InputError. A format that has no figure is left to the caller.
void check_output(const report::Json& output);

}  // namespace rocking::analysis

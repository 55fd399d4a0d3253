#pragma once

#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// Checks the output of a command before it is drawn: the schema of its format, and conditions between its parts, such
/// as lists of equal length. Throws base::InputError. A format without a figure is not an error here.
void check_output(const Json& output);

}  // namespace rocking::analysis

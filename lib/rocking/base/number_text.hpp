#pragma once

#include <string>

namespace rocking::base {

/// `number` in `digits` significant digits, in the shorter of the two notations.
[[nodiscard]] std::string significant(double number, int digits);

/// `number` in as few digits as read back to the same double; `nan` and `inf` where it is none.
[[nodiscard]] std::string shortest(double number);

}  // namespace rocking::base

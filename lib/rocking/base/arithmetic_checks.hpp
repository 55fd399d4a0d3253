#pragma once

#include <string_view>
#include <vector>

namespace rocking::base {

/// A property of this machine's arithmetic on which the bits of results depend.
struct ArithmeticCheck {
  std::string_view name;  ///< as `rocking doctor --json` names it
  bool passed = false;
};

/// Examines the arithmetic of this machine and of this build. If all checks pass, results have the same bits as on other
/// machines.
[[nodiscard]] std::vector<ArithmeticCheck> arithmetic_checks();

}  // namespace rocking::base

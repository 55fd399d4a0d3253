#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rocking::base {

/// One thing that is wrong with what a user wrote.
struct Problem {
  std::string place;   ///< JSON pointer, command-line flag or file and line
  std::string value;   ///< what stands there, as written; empty where nothing does
  std::string reason;  ///< why it will not do
  std::string remedy;  ///< what would do; empty where the reason says it
};

/// `/block/width_m = -0.1: must be positive; give a number of metres`
[[nodiscard]] std::string to_string(const Problem& problem);

/// Bad input. Carries every problem found, so that a user mends a file in one go.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Problem problem);
  explicit InputError(std::vector<Problem> problems);

  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// A condition that only a fault of ours can break did not hold.
class ContractViolation : public std::logic_error {
 public:
  ContractViolation(const char* condition, const char* file, int line);
};

}  // namespace rocking::base

/// Checks `condition` in builds with contracts on (preset `dev`); names it in a ContractViolation where it fails.
#if defined(ROCKING_CONTRACTS)
#define ROCKING_EXPECT(condition) \
  ((condition) ? void(0) : throw ::rocking::base::ContractViolation(#condition, __FILE__, __LINE__))
#else
#define ROCKING_EXPECT(condition) void(0)
#endif

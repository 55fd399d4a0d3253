#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rocking::base {

/// One thing that is wrong with what a user wrote.
struct Problem {
  std::string place;   ///< JSON pointer, command-line flag or file and line
  std::string value;   ///< what stands there, as written; empty where nothing does
  std::string reason;  ///< why it will not do
  std::string remedy;  ///< what would do; empty where the reason says it
  std::string where = {};  ///< file and line of the place; empty where the place says it
};

/// `a.json, line 3: /block/width_m = -0.1: must be positive; give a number of metres`. A long place or value is cut, and a
/// control character in any part is shown as `\x1b`: the text goes to terminals.
[[nodiscard]] std::string to_string(const Problem& problem);

/// Text for a terminal or a message: a control character (and DEL, and those of Unicode up to U+009F) becomes `\x1b`, a
/// byte that is not UTF-8 `\xff`. A new line stays.
[[nodiscard]] std::string printable(std::string_view text);

/// At most `most` bytes of a text in UTF-8; where it is longer its end becomes `...`, and no letter is cut in two.
[[nodiscard]] std::string cut_to(std::string_view text, std::size_t most);

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

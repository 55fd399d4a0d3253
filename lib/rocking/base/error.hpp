#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rocking::base {

/// One fault in the user's input.
struct Problem {
  std::string place;       ///< JSON pointer, command-line flag or file and line
  std::string value;       ///< the value found there, as written; empty if there is none
  std::string reason;      ///< why it is not accepted
  std::string remedy;      ///< what would be accepted; empty if the reason says it
  std::string where = {};  ///< file and line of the place; empty if `place` says it
};

/// Text of a problem, such as `a.json, line 3: /block/width_m = -0.1: must be positive; give a number of metres`. A
/// long place or value is cut. A control character is shown as `\x1b`, since the text is written to terminals.
[[nodiscard]] std::string to_string(const Problem& problem);

/// Text that is safe for a terminal or a message. Control characters (also DEL and those of Unicode up to U+009F) are
/// shown as `\x1b`, those of writing direction as `\u202e`, other bytes than UTF-8 as `\xff`. A new line is kept.
[[nodiscard]] std::string printable(std::string_view text);

/// At most `most` bytes of a UTF-8 text. The end of a longer text is replaced by `...`; no character is cut in two.
[[nodiscard]] std::string cut_to(std::string_view text, std::size_t most);

/// Bad input. Contains all problems that were found, so that a user can correct a file at once.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Problem problem);
  explicit InputError(std::vector<Problem> problems);

  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Thrown for a file of a run that is damaged or is not a store.
class UnusableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A folder, or a file of its run, cannot be used as asked.
class FolderError : public std::system_error {
 public:
  enum class Kind : std::uint8_t {
    missing,        ///< there is no run, or a file that its experiment names cannot be read
    contradiction,  ///< what is asked does not fit the run that is there
    in_the_way,     ///< something there prevents it, such as another run
    at_work,        ///< a process is working in it
    different,      ///< realisations that should agree differ
  };

  /// what() is `PLACE: REASON; REMEDY`. `place`: path of a folder or file; `place` and `remedy` may be empty.
  FolderError(Kind kind, const std::string& place, const std::string& reason, const std::string& remedy = "");
  /// A file that cannot be read is missing.
  explicit FolderError(const std::system_error& cause);

  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Problem& problem() const { return problem_; }

 private:
  Kind kind_;
  Problem problem_;
  std::string text_;
};

/// Thrown if a contract does not hold, which only a fault of the library can cause.
class ContractViolation : public std::logic_error {
 public:
  ContractViolation(const char* condition, const char* file, int line);
};

}  // namespace rocking::base

namespace rocking {

/// Why a value will not do, and what would.
struct Refusal {
  std::string reason;
  std::string remedy;
};

using Problems = std::vector<base::Problem>;

}  // namespace rocking

/// Checks `condition` in builds with contracts (preset `dev`). If it is false, throws ContractViolation with its text.
#if defined(ROCKING_CONTRACTS)
#define ROCKING_EXPECT(condition) \
  ((condition) ? void(0) : throw ::rocking::base::ContractViolation(#condition, __FILE__, __LINE__))
#else
#define ROCKING_EXPECT(condition) void(0)
#endif

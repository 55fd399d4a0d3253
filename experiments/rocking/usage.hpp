#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rocking::program {

/// What was probably meant by the first word of the command line that nothing knows: `"rnu" is no command; did you mean
/// "run"?`. Absent where every word is known.
[[nodiscard]] std::optional<std::string> explain_unknown_word(const CLI::App& app, int argc, const char* const* argv);

/// Help that says of an option what it takes its default and its choices, and nothing of how that is checked.
class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
};

/// Lets only these words pass; of another it says which was probably meant.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

/// The words between which an option lets its user choose; empty where it takes any.
[[nodiscard]] std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace rocking::program

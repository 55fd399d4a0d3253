#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rocking::program {

/// A suggestion for the first unknown word of the command line: `"rnu" is no command; did you mean
/// "run"?`. Absent where every word is known.
[[nodiscard]] std::optional<std::string> explain_unknown_word(const CLI::App& app,
                                                              const std::vector<std::string>& words);

/// What to do in place of a flag that is gone, if the words name one.
[[nodiscard]] std::optional<std::string> explain_gone_flag(const std::vector<std::string>& words);

/// `rocking run` where the words name that command, otherwise `rocking`.
[[nodiscard]] std::string called_command(const CLI::App& app, const std::vector<std::string>& words);

/// Help that shows of an option its type, default and choices, and not how these are checked, and
/// wraps the text below.
class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_footer(const CLI::App* app) const override;
};

/// Accepts only these words; for another it suggests the most similar one.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

/// The words that an option accepts; empty if it accepts any.
[[nodiscard]] std::vector<std::string> choices_of(const CLI::Option& option);

/// A script for bash, zsh or fish that completes the commands, flags, choices and files of the program.
[[nodiscard]] std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace rocking::program

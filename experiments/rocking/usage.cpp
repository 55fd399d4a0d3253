#include "usage.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "rocking/text/spelling.hpp"

namespace rocking::program {
namespace {

std::string suggestion(std::string_view written, const std::vector<std::string>& known) {
  const auto nearest = nearest_word(written, known);
  return nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : "";
}

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// What a word that other programs have as a command is called here; otherwise the most similar command.
std::string meant_by(const CLI::App& app, std::string_view word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> elsewhere{
      {{"help", "--help"}, {"version", "--version"}, {"plot", "report"}, {"draw", "report"}, {"simulate", "run"}}};
  const auto* const found = std::ranges::find(elsewhere, word, &std::pair<std::string_view, std::string_view>::first);
  return found == elsewhere.end() ? suggestion(word, command_names(app))
                                  : fmt::format("; that is `rocking {}`", found->second);
}

std::vector<std::string> flag_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string called(const CLI::App& app, const CLI::App& command) {
  return &command == &app ? app.get_name() : app.get_name() + ' ' + command.get_name();
}

constexpr std::size_t footer_width = 120;
constexpr std::size_t description_width = 92;  // beside the names

/// Broken at blanks into lines of at most `width` letters.
std::string in_lines(const std::string& text, std::size_t width) {
  std::string lines;
  std::size_t begin = 0;
  while (text.size() - begin > width) {
    const std::size_t blank = text.rfind(' ', begin + width);
    if (blank == std::string::npos || blank <= begin) break;
    lines += text.substr(begin, blank - begin) + '\n';
    begin = blank + 1;
  }
  return lines + text.substr(begin);
}

}  // namespace

std::string called_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = words.empty() ? nullptr : command_named(app, words.front());
  return called(app, command == nullptr ? app : *command);
}

std::optional<std::string> explain_unknown_word(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    if (word.starts_with("--")) {
      const std::string flag = word.substr(0, word.find('='));
      if (flag == "--" || command->get_option_no_throw(flag) != nullptr) continue;
      return fmt::format("\"{}\" is not a flag of `{}`{}", flag, called(app, *command),
                         suggestion(flag, flag_names(*command)));
    }
    if (command == &app && !word.starts_with('-')) {
      command = command_named(app, word);
      if (command == nullptr) return fmt::format("\"{}\" is not a command{}", word, meant_by(app, word));
    }
  }
  return std::nullopt;
}

std::optional<std::string> explain_gone_flag(const std::vector<std::string>& words) {
  constexpr std::string_view grid = "sweep the second number, too: a grid has a diagram for each of its values";
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> gone{
      {{"--peak-tilt", "it is --event 'tilt > A psi', of fragility beside overturning 'overturning,tilt > A psi'"},
       {"--metadata", "measures of intensity are compared by their dispersion and AIC, without it"},
       {"--second-parameter", grid},
       {"--second-from", grid},
       {"--second-to", grid},
       {"--curve-points", grid}}};
  for (const std::string& word : words) {
    for (const auto& [flag, instead] : gone) {
      if (word.substr(0, word.find('=')) == flag) return fmt::format("{} is gone: {}", flag, instead);
    }
  }
  return std::nullopt;
}

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string list = fmt::format("{}", fmt::join(words, ","));
  const auto check = [words = std::move(words)](const std::string& written) -> std::string {
    if (std::ranges::find(words, written) != words.end()) return "";
    return fmt::format("\"{}\" is not one of {}{}", written, fmt::join(words, ", "), suggestion(written, words));
  };
  return CLI::Validator(check, '{' + list + '}');
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string type = option->get_type_name();
  std::string text;
  if (!option->get_positional() && option->get_items_expected_max() > 0) text += ' ' + type.substr(0, type.find(':'));
  if (!option->get_default_str().empty()) text += " (" + option->get_default_str() + ')';
  if (!option->get_positional() && option->get_required()) text += " (required)";
  if (option->get_positional() && option->get_items_expected_max() > 1) text += " ...";
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  const auto choices = choices_of(*option);
  return in_lines(option->get_description() + (choices.empty() ? "" : fmt::format(": {}", fmt::join(choices, ", "))),
                  description_width);
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  std::string text;
  for (const std::string& paragraph : CLI::detail::split(app->get_footer(), '\n')) {
    text += in_lines(paragraph, footer_width) + '\n';
  }
  return text;
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

}  // namespace rocking::program

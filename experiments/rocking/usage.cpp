#include "usage.hpp"

#include <algorithm>
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

/// The fixed part: finds the cursor in the line, and completes files and folders with the shell.
constexpr std::string_view head =
    R"bash(# Completion of `rocking` for bash. For this shell: eval "$(rocking completion bash)". For every one: the same
# line in ~/.bashrc.
_rocking_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_rocking_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
_rocking_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.json' -- "$word")
}
_rocking() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
  if [[ $word == = ]]; then word=''; elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} != -* ]]; then
      command=${COMP_WORDS[i]}
      break
    fi
  done
  COMPREPLY=()
)bash";

constexpr std::string_view tail = R"bash(}
complete -F _rocking rocking
)bash";

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// The completions of a value, as a line of the script; empty if there are none.
std::string offer_of(const CLI::Option& option) {
  if (const auto choices = choices_of(option); !choices.empty()) {
    return fmt::format("_rocking_words '{}'", fmt::join(choices, " "));
  }
  const std::string kind = option.get_positional() ? option.get_name() : option.get_type_name();
  if (kind.starts_with("DIR") || kind == "SHARD") return "_rocking_folders";
  if (kind == "EXPERIMENT" || kind.starts_with("FILE")) return "_rocking_files";
  return "";
}

std::string flags_of(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    for (std::string& name : spellings(*option)) flags.push_back(std::move(name));
  }
  return fmt::format("{}", fmt::join(flags, " "));
}

/// The branch of a command: completes values after a flag, otherwise flags or the first argument.
std::string branch_of(const CLI::App& command) {
  std::string values;
  std::string arguments;
  for (const CLI::Option* option : command.get_options()) {
    const std::string offer = offer_of(*option);
    if (option->get_positional()) {
      if (arguments.empty()) arguments = offer;
    } else if (takes_value(*option)) {
      values += fmt::format("        {}) {}return ;;\n", fmt::join(spellings(*option), " | "),
                            offer.empty() ? "" : offer + "; ");
    }
  }
  std::string text = fmt::format("    {})\n", command.get_name());
  if (!values.empty()) text += "      case $before in\n" + values + "      esac\n";
  text += fmt::format("      if [[ $word == -* ]]; then _rocking_words '{}'; ", flags_of(command));
  if (!arguments.empty()) text += fmt::format("else {}; ", arguments);
  return text + "fi ;;\n";
}

}  // namespace

std::optional<std::string> explain_unknown_word(const CLI::App& app, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
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
      if (command == nullptr)
        return fmt::format("\"{}\" is not a command{}", word, suggestion(word, command_names(app)));
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

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string branches;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
    branches += branch_of(*command);
  }
  return fmt::format("{}  case $command in\n    '') _rocking_words '{} {}' ;;\n{}  esac\n{}", head,
                     fmt::join(names, " "), flags_of(app), branches, tail);
}

}  // namespace rocking::program

#include "completion.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "usage.hpp"

namespace rocking::program {
namespace {

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

// Scripts that complete the words of a command line.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "usage.hpp"

namespace rocking::program {
namespace {

std::vector<const CLI::App*> all_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// What a value or an argument names.
enum class Named : std::uint8_t { other, folder, file };

Named named_by(const CLI::Option& option) {
  const std::string kind = option.get_positional() ? option.get_name() : option.get_type_name();
  if (kind.starts_with("DIR") || kind == "SHARD") return Named::folder;
  return kind == "EXPERIMENT" || kind == "PATH" || kind.starts_with("FILE") ? Named::file : Named::other;
}

/// The fixed part: finds the cursor in the line, and completes files and folders with the shell.
constexpr std::string_view bash_head =
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

constexpr std::string_view bash_tail = R"bash(}
complete -F _rocking rocking
)bash";

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
  if (named_by(option) == Named::folder) return "_rocking_folders";
  if (named_by(option) == Named::file) return "_rocking_files";
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

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string branches;
  for (const CLI::App* command : all_commands(app)) {
    names.push_back(command->get_name());
    branches += branch_of(*command);
  }
  return fmt::format("{}  case $command in\n    '') _rocking_words '{} {}' ;;\n{}  esac\n{}", bash_head,
                     fmt::join(names, " "), flags_of(app), branches, bash_tail);
}

/// In single quotes, for zsh and fish.
std::string quoted(std::string text) {
  for (std::size_t i = 0; (i = text.find('\'', i)) != std::string::npos; i += 4) text.replace(i, 1, "'\\''");
  return '\'' + text + '\'';
}

/// The first part of a description.
std::string short_text(const std::string& description) { return description.substr(0, description.find("; ")); }

/// For the brackets and colons of _arguments and _describe.
std::string for_zsh(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string zsh_offer(const CLI::Option& option) {
  if (const auto choices = choices_of(option); !choices.empty()) return fmt::format("({})", fmt::join(choices, " "));
  constexpr std::array<const char*, 3> offers{"", "_files -/", "_files"};
  return offers[static_cast<std::size_t>(named_by(option))];
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, branches;
  for (const CLI::App* command : all_commands(app)) {
    commands += "    " + quoted(command->get_name() + ':' + for_zsh(command->get_description())) + '\n';
    branches += fmt::format("    {}) _arguments", command->get_name());
    for (const CLI::Option* option : command->get_options()) {
      const std::string value =
          ":" + for_zsh(option->get_positional() ? option->get_name() : "value") + ':' + zsh_offer(*option);
      if (option->get_positional()) {
        branches += ' ' + quoted((option->get_items_expected_max() > 1 ? "*" : "") + value);
        continue;
      }
      for (const std::string& name : spellings(*option)) {
        branches += " \\\n      " + quoted(name + '[' + for_zsh(short_text(option->get_description())) + ']' +
                                           (takes_value(*option) ? value : ""));
      }
    }
    branches += " ;;\n";
  }
  return fmt::format(
      "#compdef rocking\n# Completion of `rocking` for zsh. In ~/.zshrc, after compinit: source <(rocking completion "
      "zsh)\n"
      "_rocking() {{\n  if (( CURRENT == 2 )); then\n    local -a commands=(\n{}    )\n"
      "    _describe command commands\n    return\n  fi\n  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
      "  case $command in\n{}  esac\n}}\ncompdef _rocking rocking\n",
      commands, branches);
}

std::string fish_completion(const CLI::App& app) {
  std::string text =
      "# Completion of `rocking` for fish. In ~/.config/fish/config.fish: rocking completion fish | source\n"
      "complete -c rocking -f\n";
  const auto offer = [](const CLI::Option& option) -> std::string {
    if (const auto choices = choices_of(option); !choices.empty()) {
      return " -xa " + quoted(fmt::format("{}", fmt::join(choices, " ")));
    }
    constexpr std::array<const char*, 3> offers{" -x", " -xa '(__fish_complete_directories)'", " -rF"};
    return offers[static_cast<std::size_t>(named_by(option))];
  };
  for (const CLI::App* command : all_commands(app)) {
    text += fmt::format("complete -c rocking -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                        quoted(command->get_description()));
    const std::string here =
        fmt::format("complete -c rocking -n '__fish_seen_subcommand_from {}'", command->get_name());
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) {
        const bool is_named = !choices_of(*option).empty() || named_by(*option) != Named::other;
        if (is_named) text += here + (named_by(*option) == Named::file ? " -F" : offer(*option)) + '\n';
        continue;
      }
      text += here;
      for (const std::string& name : option->get_snames()) text += " -s " + name;
      for (const std::string& name : option->get_lnames()) text += " -l " + name;
      text +=
          (takes_value(*option) ? offer(*option) : "") + " -d " + quoted(short_text(option->get_description())) + '\n';
    }
  }
  return text;
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  return shell == "bash" ? bash_completion(app) : shell == "zsh" ? zsh_completion(app) : fish_completion(app);
}

}  // namespace rocking::program

#include "usage.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "rocking/report/spelling.hpp"

namespace rocking::program {
namespace {

std::string suggestion(std::string_view written, const std::vector<std::string>& known) {
  const auto nearest = report::nearest_word(written, known);
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

}  // namespace

std::optional<std::string> explain_unknown_word(const CLI::App& app, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const CLI::App* command = nullptr;
  for (const std::string& word : words) {
    const bool is_flag = word.starts_with('-');
    if (command == nullptr && !is_flag) {
      command = command_named(app, word);
      if (command == nullptr) return fmt::format("\"{}\" is no command{}", word, suggestion(word, command_names(app)));
    } else if (command != nullptr && word.starts_with("--")) {
      const std::string flag = word.substr(0, word.find('='));
      const auto known = flag_names(*command);
      if (command->get_option_no_throw(flag) == nullptr) {
        return fmt::format("\"{}\" is no flag of `rocking {}`{}", flag, command->get_name(), suggestion(flag, known));
      }
    }
  }
  return std::nullopt;
}

}  // namespace rocking::program

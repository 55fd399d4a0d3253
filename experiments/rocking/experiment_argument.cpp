#include "experiment_argument.hpp"

#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "exit_code.hpp"

namespace rocking::program {
namespace {

/// Name of the argument that means standard input.
constexpr std::string_view standard_input = "-";

// To its end, but not much more than an experiment may have.
std::string text_on_standard_input() {
  std::string text;
  char buffer[65536];
  while (text.size() <= most_experiment_bytes) {
    const std::size_t count = std::fread(buffer, 1, sizeof buffer, stdin);
    text.append(buffer, count);
    if (count == sizeof buffer) continue;
    if (std::ferror(stdin) != 0) {
      throw std::system_error(errno, std::generic_category(), "standard input: cannot be read");
    }
    break;
  }
  return text;
}

}  // namespace

void add_experiment(CLI::App& command, std::string& file) {
  command.add_option("EXPERIMENT", file, "Experiment file (JSON); -: standard input")->required();
}

void add_skip_unreadable(CLI::App& command, Overrides& overrides) {
  command.add_flag("--skip-unreadable", overrides.skips_unreadable,
                   "Leave out records of a suite that cannot be read; the report names them");
}

void add_seed(CLI::App& command, Overrides& overrides) {
  command.add_option("--seed", overrides.seed, "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
}

ExperimentText load_experiment_text(const std::string& path) {
  return input_of([&]() -> ExperimentText {
    if (path == standard_input) return {.text = text_on_standard_input(), .name = "standard input", .folder = "."};
    return experiment_text_of(path);
  });
}

Experiment load_experiment(const ExperimentText& source, const Overrides& overrides) {
  return input_of([&] { return experiment_in(source, overrides); });
}

Experiment load_experiment(const std::string& path, const Overrides& overrides) {
  return load_experiment(load_experiment_text(path), overrides);
}

}  // namespace rocking::program

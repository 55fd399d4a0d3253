#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "machine.hpp"
#include "output.hpp"
#include "program.hpp"

namespace rocking::program {
namespace {

// tests/support/setup.sh has the same list, and README.md.
constexpr std::string_view supported_systems = "Debian 12, Debian 13, Ubuntu 24.04";

std::vector<Fact> build_facts() {
  const base::BuildInfo build = build_info();
  return {{"version", std::string(build.version)},
          {"revision", std::string(build.revision)},
          {"compiler", std::string(build.compiler)},
          {"flags", std::string(build.flags)},
          {"build_type", std::string(build.build_type)},
          {"machine", machine_description()},
          {"system", system_name()},
          {"supported_systems", std::string(supported_systems)},
          {"lanes", lanes_in_use()}};
}

ExitCode examine(const Loudness& loudness) {
  std::vector<Fact> facts = build_facts();
  const std::vector<base::ArithmeticCheck> checks = check_arithmetic();
  bool sound = true;
  std::string text;
  for (const Fact& fact : facts) text += fact.name + ": " + std::get<std::string>(fact.value) + '\n';
  for (const base::ArithmeticCheck& check : checks) {
    sound = sound && check.passed;
    text += std::string(check.name) + (check.passed ? ": yes\n" : ": NO\n");
    facts.push_back({std::string(check.name), check.passed});
  }
  facts.push_back({"sound", sound});
  text += sound ? "all checks passed: results have the same bits on this machine as on others\n"
                : "results will differ from those of other machines; please report this output\n";
  print_result(loudness.json ? facts_text(facts) : text);
  return sound ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_doctor(CLI::App& app, Action& action) {
  const auto loudness = std::make_shared<Loudness>();
  CLI::App* command = app.add_subcommand("doctor", "Print build and machine, and check the arithmetic of this machine");
  command->footer(
      "Example: rocking doctor\n"
      "Include its output when you report a problem.");
  add_loudness(*command, *loudness);
  command->final_callback([&action, loudness] { action = [loudness] { return examine(*loudness); }; });
}

}  // namespace rocking::program

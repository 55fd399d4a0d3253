#include <cfenv>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/base/elementary.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/output/write_facts.hpp"

namespace rocking::program {
namespace {

#if defined(__x86_64__)
bool fuses_in_hardware() { return __builtin_cpu_supports("fma") != 0; }
#else
bool fuses_in_hardware() { return true; }  // part of every AArch64
#endif

// Whether a b + c is rounded once: (1 + eps)^2 - (1 + 2 eps) = eps^2, which two roundings lose.
bool fuses_exactly() {
  const volatile double eps = std::numeric_limits<double>::epsilon();
  return base::fused(1.0 + eps, 1.0 + eps, -(1.0 + 2.0 * eps)) == eps * eps;
}

bool keeps_small_numbers() {
  const volatile double smallest = std::numeric_limits<double>::min();
  return 0.25 * smallest > 0.0;
}

// SHA-256 of sin, cos, atan and ln at ten thousand points.
std::string elementary_digest() {
  base::Sha256Builder digest;
  for (int i = -5000; i < 5000; ++i) {
    const double x = 0.12345 * i;
    const auto [sine, cosine] = base::sin_cos(x);
    digest.add(sine);
    digest.add(cosine);
    digest.add(base::arc_tangent(x));
    digest.add(base::natural_logarithm(std::abs(x) + 0.001));
  }
  return base::to_hex(digest.finish());
}

constexpr std::string_view expected_elementary_digest =
    "2a846a212407852e70922205ec897b9328975dfad54ef39934e185e96718351c";

// tests/support/setup.sh has the same list, and README.md.
constexpr std::string_view supported_systems = "Debian 12, Debian 13, Ubuntu 24.04";

// How many realisations a thread advances side by side, and with which instructions.
std::string lanes_description() {
  const lanes::Kernels best = lanes::available_kernels().back();
  return std::to_string(best.lanes) + ", " + std::string(best.name);
}

std::vector<Fact> build_facts() {
  const base::BuildInfo build = base::build_info();
  return {{"version", std::string(build.version)},
          {"revision", std::string(build.revision)},
          {"compiler", std::string(build.compiler)},
          {"flags", std::string(build.flags)},
          {"build_type", std::string(build.build_type)},
          {"machine", machine_description()},
          {"system", system_name()},
          {"supported_systems", std::string(supported_systems)},
          {"lanes", lanes_description()}};
}

std::vector<Fact> check_facts() {
  return {{"fused_multiply_add_in_hardware", fuses_in_hardware()},
          {"fused_multiply_add_rounds_once", fuses_exactly()},
          {"rounds_to_nearest", std::fegetround() == FE_TONEAREST},
          {"keeps_subnormal_numbers", keeps_small_numbers()},
          {"elementary_functions_give_the_known_bits", elementary_digest() == expected_elementary_digest}};
}

ExitCode examine(const Loudness& loudness) {
  std::vector<Fact> facts = build_facts();
  const std::vector<Fact> checks = check_facts();
  bool sound = true;
  std::string text;
  for (const Fact& fact : facts) text += fact.name + ": " + std::get<std::string>(fact.value) + '\n';
  for (const Fact& check : checks) {
    const bool passed = std::get<bool>(check.value);
    sound = sound && passed;
    text += check.name + (passed ? ": yes\n" : ": NO\n");
  }
  facts.insert(facts.end(), checks.begin(), checks.end());
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
  command->footer("Example: rocking doctor\nInclude its output when you report a problem.");
  add_loudness(*command, *loudness);
  command->final_callback([&action, loudness] { action = [loudness] { return examine(*loudness); }; });
}

}  // namespace rocking::program

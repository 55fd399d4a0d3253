// Unusual command lines.

#include <string>
#include <vector>

#include "fuzz/attack/attack.hpp"

namespace rocking::fuzz {
namespace {

constexpr const char* commands[] = {
    "run",    "resume", "status",    "merge",  "verify",     "compare",      "bifurcation", "cost",   "fragility",
    "figure", "report", "replay",    "schema", "trajectory", "check-normal", "validate",    "doctor", "completion",
    "orbits", "rare",   "threshold", "infer",  "--help",     "--version",    "nothing",     ""};
constexpr const char* flags[] = {"-o",
                                 "-j",
                                 "--seed",
                                 "--realisations",
                                 "--shard",
                                 "--dry-run",
                                 "--overwrite",
                                 "--json",
                                 "-q",
                                 "-v",
                                 "--no-progress",
                                 "--sample",
                                 "--format",
                                 "--units",
                                 "--no-page",
                                 "--condition",
                                 "--realisation",
                                 "--periods",
                                 "--samples",
                                 "--tolerances",
                                 "--n",
                                 "--mean",
                                 "--sigma",
                                 "--sampler",
                                 "--from",
                                 "--to",
                                 "--help",
                                 "--",
                                 "-",
                                 "--sede"};
constexpr const char* values[] = {"",
                                  "0",
                                  "-1",
                                  "3",
                                  "1/2",
                                  "0/0",
                                  "5/3",
                                  "1/1000000000000",
                                  "1e308",
                                  "nan",
                                  "-inf",
                                  "0x",
                                  "0x2012",
                                  "18446744073709551616",
                                  "0.5",
                                  "x",
                                  "\xff\xfe",
                                  "a\x1b[31mb",
                                  "out",
                                  "nowhere",
                                  "quick.json",
                                  "1,2",
                                  "1e-400",
                                  "٣",
                                  "1s",
                                  "3 parsecs",
                                  "1e300h",
                                  "/dev/full",
                                  "out/report.json",
                                  "box-muller",
                                  "html,text",
                                  "'",
                                  "pulse.txt",
                                  "%s%n",
                                  "new",
                                  "report",
                                  "bash"};

/// Counted tests of which some fields are unusual.
std::string unusual_tests(Attack& attack) {
  const auto field = [&attack](const char* usual) {
    return std::string(attack.random.below(8) == 0 ? attack.one_of(values) : usual);
  };
  std::string text = field("amplitude") + ",\"(1,1)\"," + field("other") + '\n';
  for (const char* amplitude : {"4.2", "6.0"}) text += field(amplitude) + ',' + field("3") + ',' + field("2") + '\n';
  return text;
}

}  // namespace

void attack_flags(Attack& attack) {
  attack.copy_sound_run("out");
  for (const char* name : {"quick.json", "pulse.txt"}) attack.write(name, attack.read(attack.sound().folder / name));
  const std::string command = attack.one_of(commands);
  const bool is_infer = command == "infer";
  if (is_infer) {
    Json experiment = Json::parse(attack.read("quick.json"));
    experiment["unknown"] = Json::parse(R"([{"parameter": "/friction/static", "from": 0.3, "to": 0.4}])");
    attack.write("quick.json", experiment.dump());
    attack.write("tests.csv", unusual_tests(attack));
  }
  std::vector<std::string> arguments{command};
  if (attack.random.below(3) > 0) {
    arguments.emplace_back(command == "run" || command == "validate" || command == "cost" || command == "trajectory" ||
                                   command == "bifurcation" || command == "orbits" || command == "rare" || is_infer
                               ? "quick.json"
                               : "out");
  }
  const int count = attack.random.below(5);
  for (int i = 0; i < count; ++i) {
    if (attack.random.below(5) > 0) arguments.emplace_back(attack.one_of(flags));
    if (attack.random.below(4) > 0) {
      arguments.emplace_back(attack.random.below(50) == 0 ? std::string(5000, 'A') : attack.one_of(values));
    }
  }
  if (command == "cost") arguments.insert(arguments.end(), {"--time", "1s"});
  if (is_infer) arguments.insert(arguments.end(), {"--tests", "tests.csv"});
  if (command == "run" || command == "resume" || is_infer) arguments.insert(arguments.end(), {"--max-time", "2s"});
  attack.run(arguments, {0, 1, 64, 65, 66, 74, 75});
}

}  // namespace rocking::fuzz

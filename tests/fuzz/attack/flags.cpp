// Unusual command lines.

#include <string>
#include <vector>

#include "fuzz/attack/attack.hpp"

namespace rocking::fuzz {
namespace {

constexpr const char* commands[] = {"run",         "resume",     "status",       "merge",     "verify",  "compare",
                                    "bifurcation", "cost",       "fragility",    "figure",    "report",  "replay",
                                    "schema",      "trajectory", "check-normal", "validate",  "doctor",  "completion",
                                    "orbits",      "rare",       "--help",       "--version", "nothing", ""};
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

}  // namespace

void attack_flags(Attack& attack) {
  attack.copy_sound_run("out");
  for (const char* name : {"quick.json", "pulse.txt"}) attack.write(name, attack.read(attack.sound().folder / name));
  const std::string command = attack.one_of(commands);
  std::vector<std::string> arguments{command};
  if (attack.random.below(3) > 0) {
    arguments.emplace_back(command == "run" || command == "validate" || command == "cost" || command == "trajectory" ||
                                   command == "bifurcation" || command == "orbits" || command == "rare"
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
  if (command == "run" || command == "resume") arguments.insert(arguments.end(), {"--max-time", "2s"});
  attack.run(arguments, {0, 1, 64, 65, 66, 74, 75});
}

}  // namespace rocking::fuzz

// attack ROCKING [SEED [COUNT [FIRST [GENERATOR]]]]: runs the program on damaged and unusual input and checks its
// behaviour. Usage: reports/evidence/fuzzing.md. The same numbers give the same cases on every machine.

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "fuzz/attack/attack.hpp"

namespace {

namespace fs = std::filesystem;
using rocking::fuzz::Attack;

struct Generator {
  std::string_view name;
  void (*fill)(Attack&);
};

constexpr std::array<Generator, 6> generators{{{"experiments", rocking::fuzz::attack_experiments},
                                               {"records", rocking::fuzz::attack_records},
                                               {"flags", rocking::fuzz::attack_flags},
                                               {"reports", rocking::fuzz::attack_reports},
                                               {"stores", rocking::fuzz::attack_stores},
                                               {"texts", rocking::fuzz::attack_texts}}};

struct Request {
  fs::path program;
  std::uint64_t seed = 1;
  std::uint64_t count = 60;
  std::uint64_t first = 0;
  std::string_view generator;  ///< empty: all in turn
};

/// Runs the case with this number. Prints the findings and returns whether there are any.
bool play(const Request& request, const rocking::fuzz::Sound& sound, const Generator& generator, std::uint64_t number) {
  const fs::path folder = sound.folder.parent_path() / "case";
  fs::remove_all(folder);
  fs::create_directory(folder);
  Attack attack(sound, folder, rocking::support::SplitMix(request.seed * 1'000'003 + number).bits());
  generator.fill(attack);
  if (attack.findings().empty()) return false;
  for (const std::string& finding : attack.findings()) {
    std::printf("%s, case %llu: %s\n", std::string(generator.name).c_str(), static_cast<unsigned long long>(number),
                finding.c_str());
  }
  std::printf("    again: attack %s %llu 1 %llu %s\n", request.program.c_str(),
              static_cast<unsigned long long>(request.seed), static_cast<unsigned long long>(number),
              std::string(generator.name).c_str());
  std::fflush(stdout);
  return true;
}

int attack(const Request& request) {
  std::string name = (fs::temp_directory_path() / "rocking-attack-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) return 74;
  const fs::path work = name;
  const auto sound = rocking::fuzz::make_sound(request.program, work / "sound");
  std::map<std::string_view, std::array<std::uint64_t, 2>> tally;
  std::uint64_t found = 0;
  for (std::uint64_t number = request.first; number < request.first + request.count; ++number) {
    const Generator* chosen = &generators.at(number % generators.size());
    for (const Generator& generator : generators) {
      if (generator.name == request.generator) chosen = &generator;
    }
    const bool bad = play(request, sound, *chosen, number);
    ++tally[chosen->name][0];
    tally[chosen->name][1] += bad ? 1 : 0;
    found += bad ? 1 : 0;
  }
  for (const auto& [generator, counts] : tally) {
    std::printf("%-12s %8llu cases, %llu with a finding\n", std::string(generator).c_str(),
                static_cast<unsigned long long>(counts[0]), static_cast<unsigned long long>(counts[1]));
  }
  // If a single case was requested, its folder is kept for inspection.
  if (request.count == 1) {
    std::printf("its files: %s\n", (work / "case").c_str());
  } else {
    fs::remove_all(work);
  }
  return found == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 6) {
    std::fputs("usage: attack ROCKING [SEED [COUNT [FIRST [GENERATOR]]]]\n", stderr);
    return 64;
  }
  Request request;
  const auto number = [&](int index, std::uint64_t otherwise) {
    return argc > index ? std::strtoull(argv[index], nullptr, 0) : otherwise;
  };
  try {
    request.program = fs::absolute(argv[1]);
    request.seed = number(2, request.seed);
    request.count = number(3, request.count);
    request.first = number(4, request.first);
    if (argc > 5) request.generator = argv[5];
    return attack(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "attack: %s\n", error.what());
    return 74;
  }
}

// Prints every number of the golden experiment's records, to the bit, as text. Needs nothing but the C++ library, so that it
// can be built for any processor that a compiler knows: tests/golden/everywhere.

#include <algorithm>
#include <array>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include "golden/experiment.hpp"
#include "rocking/experiment/realisation_crew.hpp"
#include "rocking/experiment/record.hpp"

namespace {

using namespace rocking::experiment;

void print(const Record& record) {
  std::printf("%s %s %" PRIu64 "\n", std::string(to_string(record.termination)).c_str(),
              to_string(record.verdict.mode).c_str(), std::bit_cast<std::uint64_t>(record.verdict.margin));
  for (const auto& point : record.strobe) {
    for (const double number : {point.tilt, point.tilt_rate, point.slip_rate}) {
      std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(number));
    }
    std::printf("\n");
  }
  std::printf("%" PRIu64 " steps, %" PRIu64 " isolations, events", record.effort.steps, record.effort.root_isolations);
  for (const std::uint64_t count : record.effort.events) std::printf(" %" PRIu64, count);
  std::printf("\n");
}

std::uint64_t count_of(const Condition& condition) { return is_random(condition.scene) ? condition.realisations : 1; }

bool have_same_bits(const Record& a, const Record& b) {
  const auto bits = [](const rocking::section::StrobePoint& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.tilt), std::bit_cast<std::uint64_t>(p.tilt_rate),
                      std::bit_cast<std::uint64_t>(p.slip_rate)};
  };
  return a.termination == b.termination && a.effort.steps == b.effort.steps && a.effort.events == b.effort.events &&
         std::ranges::equal(a.strobe, b.strobe, {}, bits, bits);
}

/// Whether realisations side by side in lanes have other bits than alone.
bool differ_in_lanes(const rocking::lanes::Kernels& kernels, const Experiment& experiment,
                     const std::vector<Record>& alone) {
  RealisationCrew crew(experiment.seed, kernels);
  std::size_t tickets = 0;
  for (const Condition& condition : experiment.conditions) {
    for (std::uint64_t number = 0; number < count_of(condition); ++number) {
      crew.start({&condition, number}, tickets++);
    }
  }
  bool differ = false;
  while (!crew.is_idle()) {
    for (const auto& [ticket, record] : crew.work()) differ |= !have_same_bits(record, alone[ticket]);
  }
  return differ;
}

}  // namespace

int main() {
  const Experiment experiment = rocking::golden::golden_experiment();
  std::vector<Record> alone;
  for (const Condition& condition : experiment.conditions) {
    for (std::uint64_t number = 0; number < count_of(condition); ++number) {
      alone.push_back(realise(condition, experiment.seed, number));
      print(alone.back());
    }
  }
  for (const auto& kernels : rocking::lanes::available_kernels()) {
    if (!differ_in_lanes(kernels, experiment, alone)) continue;
    std::printf("other bits in lanes: %s\n", std::string(kernels.name).c_str());
  }
}

// Prints every number of the results of the golden experiment as text, to the bit. Needs only the C++ library, so that
// it can be built for any processor with a compiler: tests/golden/everywhere.

#include <algorithm>
#include <array>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include "golden/experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"

namespace {

using namespace rocking;

std::array<std::uint64_t, 4> bits_of_peaks(const RealisationResult& result) {
  const PeakValues& peaks = result.peaks;
  return {std::bit_cast<std::uint64_t>(peaks.tilt), std::bit_cast<std::uint64_t>(peaks.tilt_rate),
          std::bit_cast<std::uint64_t>(peaks.slip), std::bit_cast<std::uint64_t>(peaks.final_slip)};
}

void print(const RealisationResult& result) {
  std::printf("%s %s %" PRIu64 "\n", std::string(to_string(result.termination)).c_str(),
              to_string(result.classification.mode).c_str(),
              std::bit_cast<std::uint64_t>(result.classification.margin));
  for (const auto& point : result.strobe) {
    for (const double number : {point.tilt, point.tilt_rate, point.slip_rate}) {
      std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(number));
    }
    std::printf("\n");
  }
  for (const std::uint64_t bits : bits_of_peaks(result)) std::printf(" %016" PRIx64, bits);
  std::printf("\n%" PRIu64 " steps, %" PRIu64 " isolations, events", result.operations.steps,
              result.operations.root_isolations);
  for (const std::uint64_t count : result.operations.events) std::printf(" %" PRIu64, count);
  std::printf("\n");
}

std::uint64_t count_of(const Condition& condition) { return is_random(condition.scene) ? condition.realisations : 1; }

bool have_same_bits(const RealisationResult& a, const RealisationResult& b) {
  const auto bits = [](const rocking::section::StrobePoint& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.tilt), std::bit_cast<std::uint64_t>(p.tilt_rate),
                      std::bit_cast<std::uint64_t>(p.slip_rate)};
  };
  return a.termination == b.termination && a.operations.steps == b.operations.steps &&
         a.operations.events == b.operations.events && bits_of_peaks(a) == bits_of_peaks(b) &&
         std::ranges::equal(a.strobe, b.strobe, {}, bits, bits);
}

/// Whether realisations advanced together in lanes differ in a bit from those advanced alone.
bool differ_in_lanes(const rocking::lanes::Kernels& kernels, const Experiment& experiment,
                     const std::vector<RealisationResult>& alone) {
  RealisationScheduler scheduler(experiment.seed, kernels);
  std::size_t tickets = 0;
  for (const Condition& condition : experiment.conditions) {
    for (std::uint64_t number = 0; number < count_of(condition); ++number) {
      scheduler.start({&condition, number}, tickets++);
    }
  }
  bool differ = false;
  while (!scheduler.is_idle()) {
    for (const auto& [id, result] : scheduler.work()) differ |= !have_same_bits(result, alone[id]);
  }
  return differ;
}

}  // namespace

int main() {
  const Experiment experiment = rocking::golden::golden_experiment();
  std::vector<RealisationResult> alone;
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

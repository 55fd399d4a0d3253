// Prints every number of the golden experiment's records, to the bit, as text. Needs nothing but the C++ library, so that it
// can be built for any processor that a compiler knows: tests/golden/everywhere.

#include <bit>
#include <cinttypes>
#include <cstdio>

#include "golden/experiment.hpp"
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

}  // namespace

int main() {
  const Experiment experiment = rocking::golden::golden_experiment();
  for (const Condition& condition : experiment.conditions) {
    const std::uint64_t count = is_random(condition.scene) ? condition.realisations : 1;
    for (std::uint64_t number = 0; number < count; ++number) print(realise(condition, experiment.seed, number));
  }
}

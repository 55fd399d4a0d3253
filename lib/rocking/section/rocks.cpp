#include "rocking/section/rocks.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

struct Cycle {
  int impacts = 0;
  bool moved = false;
};

std::vector<Cycle> cycles_of(std::span<const Period> periods, int length) {
  const auto step = static_cast<std::size_t>(length);
  std::vector<Cycle> cycles(periods.size() / step);
  const auto used = periods.last(cycles.size() * step);
  for (std::size_t k = 0; k < used.size(); ++k) {
    Cycle& cycle = cycles[k / step];
    cycle.impacts += used[k].impacts;
    cycle.moved = cycle.moved || used[k].moved;
  }
  return cycles;
}

int median_impacts(std::vector<Cycle> cycles) {
  const auto middle = cycles.begin() + static_cast<std::ptrdiff_t>(cycles.size() / 2);
  std::nth_element(cycles.begin(), middle, cycles.end(),
                   [](const Cycle& a, const Cycle& b) { return a.impacts < b.impacts; });
  return middle->impacts;
}

}  // namespace

Rocks count_rocks(std::span<const Period> periods, int length) {
  const std::vector<Cycle> cycles = cycles_of(periods, length);
  ROCKING_EXPECT(!cycles.empty());
  const int typical = median_impacts(cycles);

  std::size_t irregular = 0;
  int ahead = 0;  // running total minus the typical number, since the last irregular cycle
  int lowest = 0;
  int highest = 0;
  for (const Cycle& cycle : cycles) {
    ahead += cycle.impacts - typical;
    lowest = std::min(lowest, ahead);
    highest = std::max(highest, ahead);
    const bool off_pace = highest - lowest > 1;
    const bool stood_still = typical == 0 && !cycle.moved;
    if (off_pace || stood_still) ++irregular;
    if (off_pace) ahead = lowest = highest = 0;
  }
  const double share = 1.0 - static_cast<double>(irregular) / static_cast<double>(cycles.size());
  return {(typical + 1) / 2, share};
}

}  // namespace rocking::section

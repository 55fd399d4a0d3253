#include "rocking/dynamics/clock.hpp"

#include <cmath>
#include <limits>

namespace rocking::dynamics {
namespace {
constexpr double full_turn = 0x1.921fb54442d18p+2;
}

Clock::Clock(double frequency, double phase)
    : frequency_(frequency),
      length_(full_turn / frequency),
      start_(phase / frequency),
      now_(wrapped({.period = 0, .time = start_})) {}

void Clock::advance(double duration) {
  const double later = now_.time + duration;
  const bool is_lost = duration > 0.0 && later == now_.time;
  now_.time = is_lost ? std::nextafter(later, std::numeric_limits<double>::infinity()) : later;
  now_ = wrapped(now_);
}

}  // namespace rocking::dynamics

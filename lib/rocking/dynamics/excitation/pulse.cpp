#include "rocking/dynamics/excitation/pulse.hpp"

namespace rocking::dynamics {
namespace {

constexpr double pi = 0x1.921fb54442d18p+1;

/// z_n, the n-th positive root of tan(z) = z, from phi = arctan(1/z), whose map contracts by 1/(1 + z^2) < 0.05.
double half_length_of_type_c(double n) {
  const double middle = (n + 0.5) * pi;
  double phi = 0.0;
  for (int i = 0; i < 16; ++i) phi = base::arc_tangent(1.0 / (middle - phi));
  return middle - phi;
}

/// Where x = 0 and how long the pulse is, in periods; the shares and g of a piece.
struct Parts {
  double origin = 0.0;
  double length = 1.0;
  double sine = 0.0;
  double cosine = 0.0;
  double ricker = 0.0;
  double side_bands = 0.0;
};

Parts parts_of(const PulseForm& form) {
  const auto [sine, cosine] = base::sin_cos(form.phase);
  switch (form.shape) {
    case PulseShape::sine: return {.sine = cosine, .cosine = sine};
    case PulseShape::cosine: return {.sine = 0.0 - sine, .cosine = cosine};
    case PulseShape::ricker: return {.origin = ricker_half_length, .length = 2.0 * ricker_half_length, .ricker = 1.0};
    case PulseShape::half_sine: return {.length = 0.5, .sine = 1.0};
    case PulseShape::rectangle:
    case PulseShape::triangle: return {.length = 0.5};
    case PulseShape::type_c: {
      const double half = half_length_of_type_c(form.cycles);
      return {.origin = half / (2.0 * pi),
              .length = half / pi,
              .sine = 2.0 * std::floor(0.5 * form.cycles) == form.cycles ? -1.0 : 1.0};
    }
    case PulseShape::mavroeidis_papageorgiou:
      return {.origin = 0.5 * form.cycles,
              .length = form.cycles,
              .sine = -0.5 * cosine,
              .cosine = -0.5 * sine,
              .side_bands = 1.0 / form.cycles};
  }
  return {};
}

/// `periods` after tau = 0.
Instant instant_after(const Clock& clock, double periods) {
  const double whole = std::floor(periods);
  return {.period = static_cast<std::int64_t>(whole),
          .time = (periods - whole) * clock.period_length() + clock.start()};
}

}  // namespace

double pulse_length(const PulseForm& form) { return parts_of(form).length; }

PulseExcitation::PulseExcitation(const PulseForm& form, const Clock& clock) {
  const Parts parts = parts_of(form);
  end_ = instant_after(clock, parts.length);
  const Instant origin = instant_after(clock, parts.origin);
  during_ = {
      static_cast<double>(origin.period), origin.time, 1.0, parts.sine, parts.cosine, parts.ricker, parts.side_bands};
}

}  // namespace rocking::dynamics

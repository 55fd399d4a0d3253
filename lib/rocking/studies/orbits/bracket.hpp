#pragma once

#include <algorithm>
#include <optional>

namespace rocking {

/// An interval in which a function changes sign.
struct Bracket {
  double low = 0.0;
  double high = 1.0;
  double at_low = 0.0;   ///< the function there
  double at_high = 0.0;  ///< of the other sign
};

/// Shortens a bracket until is_short(bracket), by inverse quadratic interpolation where it is safe and by bisection
/// elsewhere (Chandrupatla 1997, Adv. Eng. Softw. 28(3) 145-149). function(x) may be absent: the search then ends with
/// the bracket so far. At most 100 evaluations.
template <class Function, class IsShort>
[[nodiscard]] Bracket shorten(Bracket start, Function&& function, IsShort&& is_short) {
  double a = start.high, fa = start.at_high;  // the newest point
  double b = start.low, fb = start.at_low;    // the other end of the bracket
  double c = a, fc = fa;                      // the point before
  double share = 0.5;
  const auto bracket = [&] {
    return a < b ? Bracket{.low = a, .high = b, .at_low = fa, .at_high = fb}
                 : Bracket{.low = b, .high = a, .at_low = fb, .at_high = fa};
  };
  for (int i = 0; i < 100 && !is_short(bracket()); ++i) {
    const double x = a + share * (b - a);
    const std::optional<double> f = function(x);
    if (!f) break;
    if ((*f > 0.0) == (fa > 0.0)) {
      c = a, fc = fa;
    } else {
      c = b, b = a;
      fc = fb, fb = fa;
    }
    a = x, fa = *f;
    if (fa == 0.0) {
      b = a, fb = fa;
      break;
    }
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    const bool is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
    share = is_safe ? fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb) : 0.5;
    share = std::clamp(share, 1e-3, 1.0 - 1e-3);
  }
  return bracket();
}

}  // namespace rocking

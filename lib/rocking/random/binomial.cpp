#include "rocking/random/binomial.hpp"

#include <array>
#include <cmath>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

/// With fewer expected successes the squeeze of BTRS does not hold.
constexpr double least_mean = 10.0;

/// ln k! - (ln(2 pi)/2 + (k + 1/2) ln(k + 1) - (k + 1)), the error of Stirling's formula; that of the series is below
/// 4e-11 from k = 10 on.
double stirling_error(double k) {
  constexpr std::array small{0.08106146679532726,  0.04134069595540929, 0.02767792568499834, 0.02079067210376509,
                             0.01664469118982119,  0.01387612882307075, 0.01189670994589177, 0.01041126526197209,
                             0.009255462182712733, 0.008330563433362871};
  if (k < static_cast<double>(small.size())) return small[static_cast<std::size_t>(k)];
  const double square = (k + 1.0) * (k + 1.0);
  return (1.0 / 12.0 - (1.0 / 360.0 - 1.0 / 1260.0 / square) / square) / (k + 1.0);
}

/// The outcome at which the sum of the probabilities exceeds a uniform number; `probability` <= 1/2.
std::uint64_t by_inversion(PhiloxEngine& bits, std::uint64_t trials, double probability) {
  const double failure = 1.0 - probability;
  const auto n = static_cast<double>(trials);
  double left = uniform_from_zero(bits());
  double share = base::exponential(n * base::natural_logarithm(failure));
  std::uint64_t k = 0;
  while (left >= share && k < trials) {
    left -= share;
    ++k;
    share *= (n - static_cast<double>(k) + 1.0) / static_cast<double>(k) * (probability / failure);
  }
  return k;
}

/// BTRS, with the names of Hormann; `p` <= 1/2.
std::uint64_t by_rejection(PhiloxEngine& bits, std::uint64_t trials, double p) {
  const auto n = static_cast<double>(trials);
  const double odds = p / (1.0 - p);
  const double deviation = std::sqrt(n * p * (1.0 - p));
  const double b = 1.15 + 2.53 * deviation;
  const double a = -0.0873 + 0.0248 * b + 0.01 * p;
  const double alpha = (2.83 + 5.1 / b) * deviation;
  const double m = std::floor((n + 1.0) * p);  // the most likely outcome
  const auto ln = [](double x) { return base::natural_logarithm(x); };
  const double at_m = (m + 0.5) * ln((m + 1.0) / (odds * (n - m + 1.0))) + stirling_error(m) + stirling_error(n - m);
  for (;;) {
    const double u = uniform_inside(bits()) - 0.5;
    const double v = uniform_to_one(bits());
    const double us = 0.5 - std::abs(u);
    const double k = std::floor((2.0 * a / us + b) * u + n * p + 0.5);
    if (us >= 0.07 && v <= 0.92 - 4.2 / b) return static_cast<std::uint64_t>(k);
    if (k < 0.0 || k > n) continue;
    const double log_ratio = at_m + (n + 1.0) * ln((n - m + 1.0) / (n - k + 1.0)) +
                             (k + 0.5) * ln(odds * (n - k + 1.0) / (k + 1.0)) - stirling_error(k) -
                             stirling_error(n - k);
    if (ln(v * alpha / (a / (us * us) + b)) <= log_ratio) return static_cast<std::uint64_t>(k);
  }
}

}  // namespace

std::uint64_t binomial(PhiloxEngine& bits, std::uint64_t trials, double probability) {
  ROCKING_EXPECT(probability >= 0.0 && probability <= 1.0);
  if (probability > 0.5) return trials - binomial(bits, trials, 1.0 - probability);
  const bool is_rare = static_cast<double>(trials) * probability < least_mean;
  return is_rare ? by_inversion(bits, trials, probability) : by_rejection(bits, trials, probability);
}

}  // namespace rocking::random

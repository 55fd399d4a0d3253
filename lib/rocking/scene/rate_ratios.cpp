#include "rocking/scene/rate_ratios.hpp"

#include <algorithm>

#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/impact.hpp"

namespace rocking {
namespace {

/// Least share of Housner's ratio without a second sentence. Measured ratios lie above it for most blocks.
constexpr double usual_share = 0.85;

}  // namespace

void NumberRange::add(double number) {
  least = std::min(least, number);
  largest = std::max(largest, number);
}

std::string NumberRange::text() const {
  const std::string first = base::significant(least, 3);
  const std::string last = base::significant(largest, 3);
  return first == last ? first : first + " to " + last;
}

void RateRatios::add(const dynamics::Geometry& block, double restitution) {
  const double ratio = dynamics::inelastic_rate_ratio(block, restitution);
  const double housner = dynamics::inelastic_rate_ratio(block);
  restitution_.add(restitution);
  ratio_.add(ratio);
  housner_.add(housner);
  if (housner > 0.0) share_.add(ratio / housner);
}

std::string RateRatios::text() const {
  std::string text = "e = " + restitution_.text() + ": " + ratio_.text() +
                     " of the tilt rate survives an impact without slip (Housner's ratio: " + housner_.text() + ")";
  if (!(share_.least < usual_share)) return text;
  return text +
         ". This is less than 0.85 of Housner's ratio. If your number is the measured ratio of the rates, write "
         "\"restitution\": {\"rate_ratio\": 0.93}";
}

}  // namespace rocking

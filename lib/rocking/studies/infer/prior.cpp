#include "rocking/studies/infer/prior.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

namespace rocking::infer {
namespace {

constexpr double impossible = -std::numeric_limits<double>::infinity();

struct LogDensity {
  double value;

  double operator()(double) const { throw std::invalid_argument("a number has no density"); }
  double operator()(const Values&) const { throw std::invalid_argument("single values have no density"); }
  double operator()(const Uniform& law) const { return law.low <= value && value <= law.high ? 0.0 : impossible; }
  double operator()(const Normal& law) const {
    if (law.between && (value < law.between->least || value > law.between->largest)) return impossible;
    return -0.5 * std::pow((value - law.mean) / law.sigma, 2);
  }
  double operator()(const Lognormal& law) const {
    if (value <= 0.0) return impossible;
    const double variance = std::log1p(std::pow(law.sigma / law.mean, 2));
    const double logarithm = std::log(value);
    return -0.5 * std::pow(logarithm - std::log(law.mean) + 0.5 * variance, 2) / variance - logarithm;
  }
  double operator()(const Triangular& law) const {
    if (value < law.low || value > law.high) return impossible;
    if (value < law.mode) return std::log((value - law.low) / (law.mode - law.low));
    return value > law.mode ? std::log((law.high - value) / (law.high - law.mode)) : 0.0;
  }
};

}  // namespace

double log_density(const Quantity& law, double value) {
  return std::visit(LogDensity{value}, static_cast<const NumberOrLaw&>(law));
}

}  // namespace rocking::infer

#include "rocking/studies/curves/hazard_integral.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking {
namespace {

using stats::mills_ratio;
using stats::normal_cdf;
using stats::normal_density;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// ln(high/low) for 0 < low < high. Neighbouring numbers have a quotient that may round to 1, distant ones a quotient
/// that overflows.
double log_ratio(double low, double high) {
  const double increase = (high - low) / low;
  return increase < 1.0 ? std::log1p(increase) : std::log(high) - std::log(low);
}

HazardPiece piece_from(const HazardPoint& low, const HazardPoint& high) {
  return {.low = std::log(low.intensity),
          .high = std::log(high.intensity),
          .rate_low = low.rate,
          .rate_high = high.rate,
          .exponent = log_ratio(high.rate, low.rate) / log_ratio(low.intensity, high.intensity)};
}

void cut(HazardPiece& piece, double from, double to) {
  const HazardPiece whole = piece;
  if (from > whole.low) piece = {from, whole.high, whole.rate_at(from), whole.rate_high, whole.exponent};
  if (to < whole.high) piece = {piece.low, to, piece.rate_low, whole.rate_at(to), whole.exponent};
}

/// Integral of H dP over a piece.
double rise_on(const HazardPiece& piece, const LognormalCapacity& capacity) {
  if (!(piece.low < piece.high)) return 0.0;
  const double first = (piece.low - capacity.centre) / capacity.dispersion;
  const double last = (piece.high - capacity.centre) / capacity.dispersion;
  const double shift = piece.exponent * capacity.dispersion;
  const double u_first = first + shift;
  const double u_last = last + shift;
  if (u_first >= 0.0) {
    const double beyond = std::isinf(last) ? 0.0 : piece.rate_high * normal_density(last) * mills_ratio(u_last);
    return piece.rate_low * normal_density(first) * mills_ratio(u_first) - beyond;
  }
  if (u_last <= 0.0) {
    return piece.rate_high * normal_density(last) * mills_ratio(-u_last) -
           piece.rate_low * normal_density(first) * mills_ratio(-u_first);
  }
  // exp((u^2 - z^2)/2) with u + z < 0 < u - z: at most 1.
  return piece.rate_low * std::exp(0.5 * shift * (first + u_first)) *
         ((std::isinf(last) ? 1.0 : normal_cdf(u_last)) - normal_cdf(u_first));
}

/// Integral of P |dH| over a part of a piece with P = p + slope (y - low).
double rate_on_line(const HazardPiece& part, double p, double slope) {
  const double fall = part.rate_low - part.rate_high;
  if (slope == 0.0 || !(fall > 0.0)) return p * fall;
  const double length = part.high - part.low;
  // Between 0 and fall times length; where the rate hardly falls, only rounding would exceed that.
  const double moment = std::clamp(fall / part.exponent - part.rate_high * length, 0.0, fall * length);
  return p * fall + slope * moment;
}

/// Whether a piece has a part between two intensities. Points whose logarithms are equal make a piece without length, on
/// which the rate falls all the same; it belongs to what begins there.
bool has_part(const HazardPiece& piece, double low, double high) {
  return piece.low < high && (low <= piece.low || low < piece.high);
}

/// What follows a point with this rate: the same fall as before, and, if the curve ends at an intensity, the rest there.
std::vector<HazardPiece> continuation(const HazardPoint& last, double exponent, std::optional<double> end) {
  const double low = std::log(last.intensity);
  if (!end) return {{low, infinity, last.rate, 0.0, exponent}};
  const double high = std::log(*end);
  const double rest = low < high ? last.rate * std::exp(-exponent * (high - low)) : last.rate;
  return {{low, high, last.rate, rest, exponent}, {high, high, rest, 0.0, infinity}};
}

}  // namespace

double HazardPiece::rate_at(double y) const {
  if (y <= low) return rate_low;
  if (y >= high) return rate_high;
  return std::max(rate_high, rate_low * std::exp(-exponent * (y - low)));
}

std::vector<HazardPiece> pieces_between(const HazardCurve& hazard, double from, std::optional<double> to) {
  ROCKING_EXPECT(hazard.points.size() > 1);
  const double low = std::log(from);
  const double high = to ? std::log(*to) : infinity;
  std::vector<HazardPiece> pieces;
  const auto add = [&](HazardPiece piece) {
    if (!has_part(piece, low, high)) return;
    cut(piece, low, high);
    pieces.push_back(piece);
  };
  const auto& points = hazard.points;
  const auto end = std::ranges::find(points, 0.0, &HazardPoint::rate);
  ROCKING_EXPECT(end != points.begin());
  double exponent = 0.0;  // of the last piece on which the rate falls
  for (auto point = points.begin(); point + 1 < end; ++point) {
    const HazardPiece piece = piece_from(*point, *(point + 1));
    if (piece.exponent > 0.0) exponent = piece.exponent;
    add(piece);
  }
  const auto ends_at = end == points.end() ? std::nullopt : std::optional(end->intensity);
  for (const HazardPiece& piece : continuation(*(end - 1), exponent, ends_at)) add(piece);
  return pieces;
}

std::optional<double> intensity_at(const HazardCurve& hazard, double rate) {
  for (const HazardPiece& piece :
       pieces_between(hazard, hazard.points.front().intensity, hazard.points.back().intensity)) {
    if (!(rate <= piece.rate_low && rate >= piece.rate_high && piece.exponent > 0.0)) continue;
    return std::exp(std::min(piece.high, piece.low + std::log(piece.rate_low / rate) / piece.exponent));
  }
  return std::nullopt;
}

std::vector<HazardPiece> pieces_within(const std::vector<HazardPiece>& pieces, double low, double high) {
  std::vector<HazardPiece> within;
  for (HazardPiece piece : pieces) {
    if (!has_part(piece, low, high)) continue;
    cut(piece, low, high);
    within.push_back(piece);
  }
  return within;
}

double LognormalCapacity::probability(double y) const { return normal_cdf((y - centre) / dispersion); }

double rate_of(const LognormalCapacity& capacity, const std::vector<HazardPiece>& pieces) {
  if (pieces.empty()) return 0.0;
  const HazardPiece& last = pieces.back();
  double rate = capacity.probability(pieces.front().low) * pieces.front().rate_low;
  if (!std::isinf(last.high)) rate -= capacity.probability(last.high) * last.rate_high;
  for (const HazardPiece& piece : pieces) rate += rise_on(piece, capacity);
  return std::max(0.0, rate);
}

double KnownProbabilities::probability(double y_there) const {
  const auto next = static_cast<std::size_t>(std::upper_bound(y.begin(), y.end(), y_there) - y.begin());
  if (next == 0) return between == Between::last_known ? 0.0 : probabilities.front();
  if (next == y.size()) return between == Between::next_known ? 1.0 : probabilities.back();
  if (between == Between::last_known) return probabilities[next - 1];
  if (between == Between::next_known) return probabilities[next];
  const double share = (y_there - y[next - 1]) / (y[next] - y[next - 1]);
  return probabilities[next - 1] + share * (probabilities[next] - probabilities[next - 1]);
}

double rate_of(const KnownProbabilities& known, const std::vector<HazardPiece>& pieces) {
  double rate = 0.0;
  for (HazardPiece rest : pieces) {
    do {
      const auto next = std::upper_bound(known.y.begin(), known.y.end(), rest.low);
      HazardPiece part = rest;
      if (next != known.y.end()) cut(part, part.low, *next);
      const bool is_between = next != known.y.begin() && next != known.y.end();
      double slope = 0.0;
      if (known.between == KnownProbabilities::Between::linear && is_between) {
        const auto i = static_cast<std::size_t>(next - known.y.begin());
        slope = (known.probabilities[i] - known.probabilities[i - 1]) / (known.y[i] - known.y[i - 1]);
      }
      rate += rate_on_line(part, known.probability(part.low), slope);
      cut(rest, part.high, rest.high);
    } while (rest.low < rest.high);
  }
  return rate;
}

}  // namespace rocking

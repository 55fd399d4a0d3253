// The integral of a probability over a hazard curve: against closed forms and the midpoint rule, and where points are
// extreme.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "rocking/studies/curves/hazard_integral.hpp"

namespace rocking {
namespace {

using Between = KnownProbabilities::Between;

HazardCurve curve(std::vector<HazardPoint> points) {
  return {.name = "", .intensity = "", .header_line = 0, .points = std::move(points)};
}

/// Its exponents are 0.7, 2.3, 6 and 1.4.
HazardCurve bent() {
  std::vector<HazardPoint> points{{0.05, 3e-1}};
  for (const auto& [x, exponent] :
       {std::pair{0.2, 0.7}, std::pair{0.5, 2.3}, std::pair{0.8, 6.0}, std::pair{2.0, 1.4}}) {
    points.push_back({x, points.back().rate * std::pow(points.back().intensity / x, exponent)});
  }
  return curve(std::move(points));
}

/// Integral of P |dH| by the midpoint rule in ln x; its error falls with the square of the step.
double by_midpoints(const HazardCurve& hazard, double from, double to,
                    const std::function<double(double y)>& probability) {
  constexpr int steps = 100000;
  const auto rate_at = [&](double y) {
    std::size_t i = 0;
    while (i + 2 < hazard.points.size() && y > std::log(hazard.points[i + 1].intensity)) ++i;
    const auto& [x0, h0] = hazard.points[i];
    const auto& [x1, h1] = hazard.points[i + 1];
    return h0 * std::exp(std::log(h1 / h0) * (y - std::log(x0)) / std::log(x1 / x0));
  };
  const double step = std::log(to / from) / steps;
  double rate = 0.0;
  double above = rate_at(std::log(from));
  for (int k = 0; k < steps; ++k) {
    const double y = std::log(from) + k * step;
    const double beyond = rate_at(y + step);
    rate += probability(y + 0.5 * step) * (above - beyond);
    above = beyond;
  }
  return rate;
}

TEST(HazardIntegral, OfALognormalCapacityIsThatOfTheMidpointRule) {
  for (const double dispersion : {0.05, 0.35, 1.5}) {
    for (const double median : {0.02, 0.3, 0.9, 7.0}) {
      const LognormalCapacity capacity{.centre = std::log(median), .dispersion = dispersion};
      const auto probability = [&](double y) {
        return 0.5 * std::erfc(-(y - capacity.centre) / dispersion / std::sqrt(2.0));
      };
      for (const auto& [from, to] : {std::pair{0.05, 1.7}, std::pair{0.13, 0.55}, std::pair{0.6, 9.0}}) {
        const double expected = by_midpoints(bent(), from, to, probability);
        EXPECT_NEAR(rate_of(capacity, pieces_between(bent(), from, to)), expected, 1e-7 * expected + 1e-14)
            << median << ' ' << dispersion << ' ' << from;
      }
    }
  }
}

TEST(HazardIntegral, OfKnownProbabilitiesIsThatOfTheMidpointRule) {
  for (const Between between : {Between::linear, Between::last_known, Between::next_known}) {
    const KnownProbabilities known{
        .y = {std::log(0.1), std::log(0.3), std::log(0.6)}, .probabilities = {0.1, 0.4, 0.9}, .between = between};
    const auto probability = [&known](double y) { return known.probability(y); };
    for (const auto& [from, to] : {std::pair{0.05, 1.7}, std::pair{0.13, 0.55}, std::pair{0.6, 9.0}}) {
      const double expected = by_midpoints(bent(), from, to, probability);
      EXPECT_NEAR(rate_of(known, pieces_between(bent(), from, to)), expected, 3e-5 * expected) << from;
    }
  }
  const KnownProbabilities known{.y = {0.0}, .probabilities = {0.25}, .between = Between::linear};
  EXPECT_NEAR(rate_of(known, pieces_between(bent(), 0.05)), 0.25 * 0.3, 1e-16);
}

TEST(HazardIntegral, AddsUpOverParts) {
  const LognormalCapacity capacity{.centre = std::log(0.4), .dispersion = 0.35};
  const double whole = rate_of(capacity, pieces_between(bent(), 0.05));
  double sum = rate_of(capacity, pieces_between(bent(), 3.0));
  for (const auto& [from, to] : {std::pair{0.01, 0.219}, std::pair{0.219, 0.5}, std::pair{0.5, 3.0}}) {
    sum += rate_of(capacity, pieces_between(bent(), from, to));
  }
  EXPECT_NEAR(sum, whole, 1e-14 * whole);
}

// Between two neighbouring numbers the rate falls at one intensity, so that this part counts with P there.
TEST(HazardIntegral, TakesNeighbouringNumbersAsIntensities) {
  const LognormalCapacity capacity{.centre = std::log(0.4), .dispersion = 0.35};
  const KnownProbabilities known{.y = {std::log(0.4)}, .probabilities = {0.5}, .between = Between::linear};
  for (const double x : {0.1, 0.7, 1.0, 1.9999}) {
    const double next = std::nextafter(x, 10.0);
    const HazardCurve with_step = curve({{x, 1e-2}, {next, 1e-3}, {9.0, 1e-5}});
    const HazardCurve without = curve({{next, 1e-3}, {9.0, 1e-5}});
    const double expected = capacity.probability(std::log(x)) * 9e-3 + rate_of(capacity, pieces_between(without, next));
    EXPECT_NEAR(rate_of(capacity, pieces_between(with_step, x)), expected, 1e-12 * expected) << x;
    EXPECT_NEAR(rate_of(known, pieces_between(with_step, x)), 0.5 * 1e-2, 1e-15) << x;
    // As the last two points, so that the rate falls to 0 there.
    const HazardCurve at_end = curve({{0.01, 1e-1}, {x, 1e-2}, {next, 1e-3}});
    const double at_most =
        rate_of(capacity, pieces_between(at_end, 0.01, x)) + capacity.probability(std::log(next)) * 1e-2;
    EXPECT_NEAR(rate_of(capacity, pieces_between(at_end, 0.01)), at_most, 1e-12 * at_most) << x;
  }
}

/// With a sample of the intensities at which events happen: of equally likely events between each two rates.
double by_events(const HazardCurve& hazard, const LognormalCapacity& capacity) {
  constexpr int count = 200000;
  const std::vector<HazardPiece> pieces = pieces_between(hazard, hazard.points.front().intensity);
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double rate = hazard.points.front().rate * (i + 0.5) / count;
    for (const HazardPiece& piece : pieces) {
      if (!(piece.rate_high < rate && rate <= piece.rate_low)) continue;
      const double fall = std::log(piece.rate_low / rate);
      sum += capacity.probability(piece.low + (piece.low < piece.high ? fall / piece.exponent : 0.0));
    }
  }
  return sum * hazard.points.front().rate / count;
}

TEST(HazardIntegral, CountsNothingWhereNeighbouringRatesAreEqual) {
  const LognormalCapacity capacity{.centre = std::log(0.4), .dispersion = 0.35};
  const HazardCurve flat = curve({{0.1, 1e-2}, {0.3, 1e-3}, {0.5, 1e-3}, {1.0, 1e-4}});
  const double parts = rate_of(capacity, pieces_between(curve({{0.1, 1e-2}, {0.3, 1e-3}}), 0.1, 0.3)) +
                       rate_of(capacity, pieces_between(curve({{0.5, 1e-3}, {1.0, 1e-4}}), 0.5));
  EXPECT_NEAR(rate_of(capacity, pieces_between(flat, 0.1)), parts, 1e-15);
  EXPECT_NEAR(by_events(flat, capacity), parts, 1e-4 * parts);
  const KnownProbabilities known{
      .y = {std::log(0.1), std::log(1.0)}, .probabilities = {0.0, 1.0}, .between = Between::linear};
  // Neighbours that differ by rounding only add nothing but rounding.
  for (const double next : {1e-3, std::nextafter(1e-3, 0.0), 1e-3 * (1.0 - 1e-12)}) {
    const HazardCurve near = curve({{0.3, 1e-3}, {0.5, next}, {1.0, 1e-4}});
    EXPECT_NEAR(rate_of(known, pieces_between(near, 0.3, 0.5)), 0.0, 1e-15) << next;
  }
}

// The last piece on which the rate falls is continued also where equal rates follow it.
TEST(HazardIntegral, ContinuesTheLastFallBeyondTheLastPoint) {
  const LognormalCapacity capacity{.centre = std::log(4.0), .dispersion = 0.35};
  const HazardCurve flat = curve({{0.1, 1e-2}, {1.0, 1e-4}, {2.0, 1e-4}});
  EXPECT_NEAR(rate_of(capacity, pieces_between(flat, 2.0)),
              rate_of(capacity, pieces_between(curve({{0.2, 1e-2}, {2.0, 1e-4}}), 2.0)), 1e-18);
}

// Up to the point of rate 0 the curve continues as before; what is left happens there, and nothing beyond.
TEST(HazardIntegral, EndsWhereTheRateIsZero) {
  const LognormalCapacity capacity{.centre = std::log(0.4), .dispersion = 0.35};
  const HazardCurve open = curve({{0.1, 1e-2}, {1.0, 1e-4}});
  const HazardCurve ended = curve({{0.1, 1e-2}, {1.0, 1e-4}, {2.0, 0.0}, {3.0, 0.0}});
  const double expected =
      rate_of(capacity, pieces_between(open, 0.1, 2.0)) + 1e-4 / 4.0 * capacity.probability(std::log(2.0));
  EXPECT_NEAR(rate_of(capacity, pieces_between(ended, 0.1)), expected, 1e-15);
  EXPECT_NEAR(by_events(ended, capacity), expected, 1e-4 * expected);
  EXPECT_LT(expected, rate_of(capacity, pieces_between(open, 0.1)));
  // Parts add up wherever they are cut, also at the end itself.
  const KnownProbabilities all{.y = {0.0}, .probabilities = {1.0}, .between = Between::linear};
  for (const double at : {0.5, 1.0, 1.5, 2.0, 2.5}) {
    const double sum = rate_of(all, pieces_between(ended, 0.1, at)) + rate_of(all, pieces_between(ended, at));
    EXPECT_NEAR(sum, 1e-2, 1e-17) << at;
    const auto pieces = pieces_between(ended, 0.1);
    EXPECT_NEAR(rate_of(all, pieces_within(pieces, -HUGE_VAL, std::log(at))) +
                    rate_of(all, pieces_within(pieces, std::log(at), HUGE_VAL)),
                1e-2, 1e-17)
        << at;
  }
  EXPECT_TRUE(pieces_between(ended, 2.5).empty());
}

TEST(HazardIntegral, TakesTheLeastAndTheLargestNumbers) {
  const LognormalCapacity capacity{.centre = 0.0, .dispersion = 0.35};
  for (const HazardCurve& hazard : {curve({{1e-308, 1e-2}, {1e308, 1e-3}}), curve({{0.1, 1e300}, {1.0, 1e-300}}),
                                    curve({{1e-308, 1e308}, {1e308, 1e-308}})}) {
    const double first = hazard.points.front().rate;
    const double whole = rate_of(capacity, pieces_between(hazard, hazard.points.front().intensity));
    EXPECT_GE(whole, 0.0);
    EXPECT_LE(whole, first * (1.0 + 1e-12));
  }
  // The exponent is tiny, and with it the part below the median.
  const HazardCurve flat = curve({{1e-308, 1e-2}, {1e308, 1e-3}});
  EXPECT_NEAR(rate_of(capacity, pieces_between(flat, 1e-308)), 1e-2 / std::sqrt(10.0), 1e-7);
}

}  // namespace
}  // namespace rocking

// Frequency of wrong labels on tori, long periods and chaos. The tables are in
// reports/evidence/classification-evidence.md; this program makes them. The seeds are fixed: no false alarm. No series
// has a clear exponent: the points alone must tell a torus from what is none.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classify.hpp"
#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

using support::SplitMix;

constexpr double turn = 2.0 * std::numbers::pi;

/// A closed curve with four harmonics, whose first one is the largest in most draws.
class ClosedCurve {
 public:
  explicit ClosedCurve(SplitMix& draw) : centre_{draw.uniform(-1.0, 1.0), draw.uniform(-1.0, 1.0), 0.0} {
    for (std::size_t h = 0; h < terms_.size(); ++h) {
      const double size = h == 0 ? 1.0 : draw.uniform(0.0, 0.6) / static_cast<double>(h * h + 1);
      for (double& term : terms_[h]) term = size * draw.uniform(-1.0, 1.0);
    }
  }

  [[nodiscard]] StrobePoint at(double position) const {
    StrobePoint p = centre_;
    for (std::size_t h = 0; h < terms_.size(); ++h) {
      const double angle = turn * static_cast<double>(h + 1) * position;
      p.tilt += terms_[h][0] * std::cos(angle) + terms_[h][1] * std::sin(angle);
      p.tilt_rate += terms_[h][2] * std::cos(angle) + terms_[h][3] * std::sin(angle);
    }
    return p;
  }

 private:
  StrobePoint centre_;
  std::array<std::array<double, 4>, 4> terms_{};
};

/// A response: its points, before noise is added.
using Response = std::function<std::vector<StrobePoint>(std::size_t, SplitMix&)>;

/// The circle map x' = x + a - K/(2 pi) sin(2 pi x), on a curve. It is integrable only for K = 0.
Response circle_map(double least, double most) {
  return [=](std::size_t count, SplitMix& draw) {
    const ClosedCurve curve(draw);
    const double drive = draw.uniform();
    const double size = draw.uniform(least, most) / turn;
    double x = draw.uniform();
    std::vector<StrobePoint> points;
    for (std::size_t k = 0; k < count + 2000; ++k) {
      x += drive - size * std::sin(turn * x);
      x -= std::floor(x);
      if (k >= 2000) points.push_back(curve.at(x));
    }
    return points;
  };
}

/// n curves that are visited in turn, on each of them an integrable circle map: a rotation in other coordinates.
Response torus(std::size_t n) {
  return [n](std::size_t count, SplitMix& draw) {
    std::vector<ClosedCurve> curves;
    for (std::size_t i = 0; i < n; ++i) curves.emplace_back(draw);
    const double rotation = draw.uniform();
    const double first = draw.uniform();
    const double bend = draw.uniform(0.0, 0.9) / turn;
    std::vector<StrobePoint> points;
    for (std::size_t k = 0; k < count; ++k) {
      const double even = first + rotation * static_cast<double>(k / n);
      points.push_back(curves[k % n].at(even + bend * std::sin(turn * even)));
    }
    return points;
  };
}

/// x = cos 2 pi t + a cos(2 pi f t + b) with its rate, once in a unit of t.
std::vector<StrobePoint> two_frequencies(std::size_t count, SplitMix& draw) {
  const double frequency = draw.uniform(0.0, 3.0);
  const double size = draw.uniform(0.05, 2.0);
  const double phase = draw.uniform(0.0, turn);
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = turn * frequency * static_cast<double>(k) + phase;
    points.push_back({1.0 + size * std::cos(angle), -size * frequency * std::sin(angle), 0.0});
  }
  return points;
}

/// A period of 13 to half of the points, on a curve or as single points.
Response long_period(bool on_a_curve) {
  return [on_a_curve](std::size_t count, SplitMix& draw) {
    const ClosedCurve curve(draw);
    const int period = 13 + draw.below(static_cast<int>(count / 2) - 13);
    int step = 1 + draw.below(period - 1);
    while (std::gcd(step, period) != 1) step = 1 + draw.below(period - 1);
    std::vector<StrobePoint> cycle;
    for (int k = 0; k < period; ++k) {
      const StrobePoint anywhere{draw.uniform(-1.0, 1.0), draw.uniform(-1.0, 1.0), 0.0};
      cycle.push_back(on_a_curve ? curve.at(static_cast<double>(k) * step / period) : anywhere);
    }
    std::vector<StrobePoint> points;
    for (std::size_t k = 0; k < count; ++k) points.push_back(cycle[k % cycle.size()]);
    return points;
  };
}

/// Henon's map, x' = 1 - 1.4 x^2 + y, y' = 0.3 x.
std::vector<StrobePoint> henon(std::size_t count, SplitMix& draw) {
  double x = draw.uniform(0.0, 0.1);
  double y = draw.uniform(0.0, 0.1);
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count + 500; ++k) {
    const double next = 1.0 - 1.4 * x * x + y;
    y = 0.3 * x;
    x = next;
    if (k >= 500) points.push_back({x, y, 0.0});
  }
  return points;
}

/// The delayed logistic map x' = 2.27 x (1 - y), y' = x, whose curve has broken up into chaos (Aronson et al. 1982,
/// Commun. Math. Phys. 83, 303-354).
std::vector<StrobePoint> broken_curve(std::size_t count, SplitMix& draw) {
  double x = draw.uniform(0.3, 0.4);
  double y = x;
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count + 3000; ++k) {
    const double next = 2.27 * x * (1.0 - y);
    y = x;
    x = next;
    if (k >= 3000) points.push_back({x, y, 0.0});
  }
  return points;
}

/// A focus that attracts (rate > 0) or repels, without noise of its own.
std::vector<StrobePoint> spiral(std::size_t count, SplitMix& draw) {
  const double rate = 0.02 * std::pow(0.02, draw.uniform());
  const double rotation = draw.uniform();
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = turn * rotation * static_cast<double>(k);
    const double size = std::exp(-rate * static_cast<double>(k));
    points.push_back({size * std::cos(angle), size * std::sin(angle), 0.0});
  }
  return points;
}

/// A focus with memory 0.8 to 0.998 that noise keeps turning.
std::vector<StrobePoint> noisy_focus(std::size_t count, SplitMix& draw) {
  const double memory = 1.0 - 0.2 * std::pow(0.01, draw.uniform());
  const double angle = draw.uniform(0.0, turn);
  double x = 0.0;
  double y = 0.0;
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count + 2000; ++k) {
    const double next = memory * (std::cos(angle) * x - std::sin(angle) * y) + draw.normal();
    y = memory * (std::sin(angle) * x + std::cos(angle) * y) + draw.normal();
    x = next;
    if (k >= 2000) points.push_back({x, y, 0.0});
  }
  return points;
}

struct Labels {
  int series = 0;
  int quasi_periodic = 0;
  int chaotic_or_periodic = 0;
};

/// Labels of some series with noise of this standard deviation in both coordinates.
Labels score_of(const Response& response, std::size_t count, double noise, std::uint64_t seed) {
  Labels score;
  SplitMix draw(seed);
  for (score.series = 0; score.series < 200; ++score.series) {
    std::vector<Period> periods;
    for (StrobePoint p : response(count, draw)) {
      p.tilt += noise * draw.normal();
      p.tilt_rate += noise * draw.normal();
      periods.push_back({p, 2, true});
    }
    const ExponentEstimate unclear{2e-4 * draw.normal(), 2e-4};
    const Classification found = classify({.periods = periods, .random = noise > 0.0, .resolution = 1e-7},
                                          [&] { return std::optional(unclear); });
    const bool open = found.mode.kind == ResponseKind::unresolved;
    if (found.mode.kind == ResponseKind::quasi_periodic) {
      ++score.quasi_periodic;
    } else if (!open) {
      ++score.chaotic_or_periodic;
    }
  }
  return score;
}

struct Case {
  const char* name;
  Response response;
  bool is_torus;
};

TEST(QuasiPeriodic, IsToldFromLongPeriodsAndChaosByThePointsAlone) {
  const std::vector<Case> cases{{"torus, 1 curve", torus(1), true},
                                {"torus, 2 curves", torus(2), true},
                                {"torus, 3 curves", torus(3), true},
                                {"two frequencies", two_frequencies, true},
                                {"period 13 ... N/2 on a curve", long_period(true), false},
                                {"period 13 ... N/2, any points", long_period(false), false},
                                {"Henon's map", henon, false},
                                {"broken curve (delayed logistic map)", broken_curve, false},
                                {"circle map, K = 1.2 ... 3", circle_map(1.2, 3.0), false},
                                {"spiral to a point", spiral, false},
                                {"focus kept turning by noise", noisy_focus, false}};
  int others = 0;
  int wrong = 0;
  for (const std::size_t count : {120U, 480U}) {
    for (const double noise : {0.0, 1e-3, 1e-2}) {
      int tori = 0;
      int found = 0;
      for (const Case& each : cases) {
        const Labels score = score_of(each.response, count, noise, 7 * count + static_cast<std::uint64_t>(1e4 * noise));
        std::printf("| %s | %zu | %g | %d | %d | %d |\n", each.name, count, noise, score.series, score.quasi_periodic,
                    score.chaotic_or_periodic);
        (each.is_torus ? tori : others) += score.series;
        (each.is_torus ? found : wrong) += score.quasi_periodic;
        if (each.is_torus) wrong += score.chaotic_or_periodic;
        if (each.is_torus) others += score.series;
      }
      if (noise <= 1e-3) {
        EXPECT_GT(found, 0.4 * tori) << count << ", noise " << noise;
      }
    }
  }
  std::printf("%d of %d wrong\n", wrong, others);
  EXPECT_LE(wrong, 0.003 * others);
}

}  // namespace
}  // namespace rocking::section

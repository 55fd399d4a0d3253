// The series of the motion, compared with the equations and forces of lib/docs/model.md in the fixed frame.

#include "rocking/dynamics/motion_series.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/dynamics/excitation/harmonic.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/guards.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using Series = MotionSeries<double>;

/// A block at the start of a step, in the fixed frame.
struct Start {
  Geometry block;
  double side;       ///< S
  double tilt;       ///< theta
  double tilt_rate;  ///< w
  double slip_rate;  ///< V
  double direction;  ///< s
  double kinetic_friction;
  double inertia;    ///< J
  double amplitude;  ///< of alpha
  double frequency;
  double angle;  ///< argument of the sine at the start

  double weight = 1.0;  ///< 1 + alpha_v at the start
  double weight_slope = 0.0;

  [[nodiscard]] double alpha(double x) const { return amplitude * std::sin(frequency * x + angle); }
  [[nodiscard]] double weight_at(double x) const { return weight + weight_slope * x; }
};

Start random_start(support::SplitMix& draw) {
  const Geometry block = geometry_of({.width = 1.0, .height = draw.uniform(1.0, 10.0)});
  const double side = draw.below(2) == 0 ? -1.0 : 1.0;
  const double direction = draw.below(2) == 0 ? -1.0 : 1.0;
  return {.block = block,
          .side = side,
          .tilt = side * draw.uniform(0.0, 1.5) * block.shape_angle,
          .tilt_rate = draw.uniform(-0.5, 0.5),
          .slip_rate = direction * draw.uniform(0.0, 0.5),
          .direction = direction,
          .kinetic_friction = draw.uniform(0.0, 0.9),
          .inertia = draw.below(2) == 0 ? 1.0 / 3.0 : 4.0 / 3.0,
          .amplitude = draw.uniform(-2.0, 2.0),
          .frequency = draw.uniform(1.0, 10.0),
          .angle = draw.uniform(0.0, 2.0 * std::numbers::pi)};
}

/// The same on a base that also moves vertically.
Start lifted(Start start, support::SplitMix& draw) {
  start.weight = draw.uniform(0.3, 1.7);
  start.weight_slope = draw.uniform(-5.0, 5.0);
  return start;
}

EquationConstants<double> constants_of(const Start& start) {
  return {.shape_angle = start.block.shape_angle,
          .sine = start.block.sine,
          .cosine = start.block.cosine,
          .inertia = start.inertia};
}

/// Of any block.
AnyConstants any_constants_of(const Start& start) {
  return equation_constants({.block = start.block,
                             .inertia = start.inertia,
                             .impact_slip_rule = ImpactSlipRule::absolute,
                             .tolerance = 1e-13},
                            start.side);
}

/// A block with its mass off the middle.
Start general(Start start, support::SplitMix& draw) {
  start.block = geometry_of({.mass = MassLayout{.left_edge = draw.uniform(0.1, 1.0),
                                                .right_edge = draw.uniform(0.1, 1.0),
                                                .centre_height = draw.uniform(0.3, 2.0),
                                                .radius_of_gyration = draw.uniform(0.2, 1.0)}});
  start.inertia = start.block.inertia;
  return start;
}

template <int order, class Constants>
void begin(Series& m, const Start& start, const Constants& constants) {
  expand_harmonic<order>(m.base, start.side * start.amplitude, start.frequency, base::sin_cos(start.angle));
  m.weight.fill(0.0);
  m.weight[0] = start.weight;
  m.weight[1] = start.weight_slope;
  m.tilt[0] = start.side * start.tilt;
  m.tilt_rate[0] = start.side * start.tilt_rate;
  m.slip_rate[0] = start.side * start.slip_rate;
  m.slip[0] = 0.0;
  begin_angle(m, constants);
}

template <int order>
void begin(Series& m, const Start& start) {
  begin<order>(m, start, constants_of(start));
}

SlipParameters<double> slip_of(const Start& start) {
  return {.drag = start.side * start.direction * start.kinetic_friction, .first_rate_gate = 1.0};
}

double value(const Series::Row& row, int degree, double x) {
  double sum = 0.0;
  for (int k = degree; k >= 0; --k) sum = sum * x + row[static_cast<std::size_t>(k)];
  return sum;
}

double derivative(const Series::Row& row, int degree, double x) {
  double sum = 0.0;
  for (int k = degree; k >= 1; --k) sum = sum * x + k * row[static_cast<std::size_t>(k)];
  return sum;
}

/// The motion at time x of the step, in the fixed frame.
struct Moment {
  double tilt, tilt_rate, tilt_acceleration, slip_rate, slip_acceleration, normal;
};

template <int order>
Moment moment(const Series& m, double side, double x) {
  return {.tilt = side * value(m.tilt, order + 1, x),
          .tilt_rate = side * value(m.tilt_rate, order, x),
          .tilt_acceleration = side * derivative(m.tilt_rate, order, x),
          .slip_rate = side * value(m.slip_rate, order, x),
          .slip_acceleration = side * derivative(m.slip_rate, order, x),
          .normal = value(m.normal, order - 1, x)};
}

/// Largest residuals of the equations at a few instants of a step of length h.
struct Residuals {
  double tilt = 0.0, slip = 0.0, normal = 0.0, euler = 0.0;

  void keep(double& largest, double residual) { largest = std::fmax(largest, std::abs(residual)); }
};

/// Rock, if `slips` is false: V' = 0, w' = -S (1 + alpha_v) sin(phi) + alpha cos(phi). Else rock-slide.
template <int order, bool vertical>
Residuals residuals_of_rocking(const Start& start, bool slips, double h) {
  Series m{};
  begin<order>(m, start);
  if (slips) {
    expand_rock_slide<order, vertical>(m, constants_of(start), slip_of(start));
  } else {
    m.slip_rate = {};
    expand_rock<order, vertical>(m, constants_of(start), 1.0);
    expand_normal<order, vertical>(m, constants_of(start));
  }
  Residuals found;
  for (int i = 0; i <= 4; ++i) {
    const double x = h * i / 4.0;
    const Moment now = moment<order>(m, start.side, x);
    const double S = start.side;
    const double w = now.tilt_rate;
    const double phi = start.block.shape_angle - S * now.tilt;
    const double sine = std::sin(phi);
    const double cosine = std::cos(phi);
    const double alpha = start.alpha(x);
    const double weight = start.weight_at(x);
    const double G = 4.0 / 3.0 * weight;
    const double drag = start.direction * start.kinetic_friction;
    const double q = S * sine + drag * cosine;
    const double D = start.inertia + S * sine * q;
    const double acceleration = slips ? -(G - w * w * cosine) * q / D : -S * weight * sine + alpha * cosine;
    const double normal = G + S * acceleration * sine - w * w * cosine;
    const double slip_acceleration =
        slips ? -4.0 / 3.0 * alpha - drag * normal + acceleration * cosine + S * w * w * sine : 0.0;
    const double friction =
        4.0 / 3.0 * alpha + now.slip_acceleration - now.tilt_acceleration * cosine - S * w * w * sine;
    const double inertia = slips ? start.inertia : 1.0 / 3.0;
    found.keep(found.tilt, now.tilt_acceleration - acceleration);
    found.keep(found.slip, now.slip_acceleration - slip_acceleration);
    found.keep(found.normal, now.normal - normal);
    found.keep(found.euler, inertia * now.tilt_acceleration + S * sine * now.normal - cosine * friction);
  }
  return found;
}

/// With Omega_h h <= 0.1 and D >= 0.06 the first neglected terms are below 1e-14 (order 9) and 1e-20 (order 14) times
/// small factors; the rest is rounding of numbers up to about 30.
constexpr double order_9_bound = 2e-11;
constexpr double order_14_bound = 5e-14;

template <int order, bool vertical>
void expect_equations_to_hold(bool slips, double h, double bound) {
  support::SplitMix draw(20);
  for (int i = 0; i < 20'000; ++i) {
    const Start start = vertical ? lifted(random_start(draw), draw) : random_start(draw);
    const Residuals found = residuals_of_rocking<order, vertical>(start, slips, h);
    ASSERT_LT(found.tilt, bound) << "start " << i;
    ASSERT_LT(found.slip, bound) << "start " << i;
    ASSERT_LT(found.normal, bound) << "start " << i;
    ASSERT_LT(found.euler, bound) << "start " << i;
  }
}

TEST(RockSeries, SatisfiesTheEquationsAndForcesOnBothSides) {
  expect_equations_to_hold<14, false>(false, 0.01, order_14_bound);
  expect_equations_to_hold<9, false>(false, 0.01, order_9_bound);
  expect_equations_to_hold<14, true>(false, 0.01, order_14_bound);
}

TEST(RockSlideSeries, SatisfiesTheEquationsAndForcesOnBothSides) {
  expect_equations_to_hold<14, false>(true, 0.01, order_14_bound);
  expect_equations_to_hold<9, false>(true, 0.01, order_9_bound);
  expect_equations_to_hold<14, true>(true, 0.01, order_14_bound);
}

TEST(SlideSeries, SatisfiesItsEquation) {
  support::SplitMix draw(21);
  for (int i = 0; i < 10'000; ++i) {
    Start start = random_start(draw);
    start.side = 1.0;
    Series m{};
    begin<14>(m, start);
    if (i % 2 == 0) {
      expand_slide<14, false>(m, constants_of(start), slip_of(start));
    } else {
      start = lifted(start, draw);
      begin<14>(m, start);
      expand_slide<14, true>(m, constants_of(start), slip_of(start));
    }
    for (const double x : {0.0, 0.02, 0.05}) {
      const double drag = start.direction * start.kinetic_friction * start.weight_at(x);
      const double wanted = -4.0 / 3.0 * (start.alpha(x) + drag);
      ASSERT_NEAR(derivative(m.slip_rate, 14, x), wanted, 1e-14 * 16) << "start " << i;
      ASSERT_NEAR(derivative(m.slip, 15, x), value(m.slip_rate, 14, x), 1e-15) << "start " << i;
    }
  }
}

template <int order>
void expect_residual_to_fall_by_its_order(bool slips) {
  support::SplitMix draw(22);
  double sum = 0.0;
  int counted = 0;
  for (int i = 0; i < 300; ++i) {
    Start start = random_start(draw);
    start.frequency = 5.0;
    start.kinetic_friction *= 0.3;
    const double h = order == 9 ? 0.1 : 0.25;
    const double coarse = residuals_of_rocking<order, false>(start, slips, h).tilt;
    const double fine = residuals_of_rocking<order, false>(start, slips, 0.5 * h).tilt;
    if (fine < 1e-13) continue;  // rounding
    sum += std::log2(coarse / fine);
    ++counted;
  }
  ASSERT_GT(counted, 30);
  EXPECT_NEAR(sum / counted, order, 0.75) << "slips: " << slips;
}

TEST(MotionSeries, ConvergesWithItsOrderWhenTheStepIsHalved) {
  expect_residual_to_fall_by_its_order<9>(false);
  expect_residual_to_fall_by_its_order<14>(false);
  expect_residual_to_fall_by_its_order<9>(true);
  expect_residual_to_fall_by_its_order<14>(true);
}

TEST(MotionSeries, GivesTheSameLowCoefficientsAtEveryOrder) {
  support::SplitMix draw(23);
  for (int i = 0; i < 1'000; ++i) {
    const Start start = random_start(draw);
    Series low{};
    Series high{};
    begin<9>(low, start);
    begin<14>(high, start);
    expand_rock_slide<9, false>(low, constants_of(start), slip_of(start));
    expand_rock_slide<14, false>(high, constants_of(start), slip_of(start));
    for (std::size_t k = 0; k <= 9; ++k) {
      ASSERT_EQ(low.tilt_rate[k], high.tilt_rate[k]);
      ASSERT_EQ(low.slip_rate[k], high.slip_rate[k]);
    }
  }
}

TEST(MotionSeries, OfTheMirrorImageIsTheSameToTheBit) {
  support::SplitMix draw(24);
  for (int i = 0; i < 1'000; ++i) {
    const Start start = random_start(draw);
    Start mirrored = start;
    for (double* sign : {&mirrored.side, &mirrored.tilt, &mirrored.tilt_rate, &mirrored.slip_rate, &mirrored.direction,
                         &mirrored.amplitude}) {
      *sign = -*sign;
    }
    Series one{};
    Series other{};
    begin<14>(one, start);
    begin<14>(other, mirrored);
    expand_rock_slide<14, false>(one, constants_of(start), slip_of(start));
    expand_rock_slide<14, false>(other, constants_of(mirrored), slip_of(mirrored));
    ASSERT_EQ(one.tilt_rate, other.tilt_rate);
    ASSERT_EQ(one.slip_rate, other.slip_rate);
    ASSERT_EQ(one.normal, other.normal);
  }
}

TEST(MotionSeries, HasFirstRatesThatAreZeroExactlyBehindAGate) {
  Start start = {.block = geometry_of({}),
                 .side = 1.0,
                 .tilt = 0.0,
                 .tilt_rate = 0.0,
                 .slip_rate = 0.0,
                 .direction = 1.0,
                 .kinetic_friction = 0.3,
                 .inertia = 1.0 / 3.0,
                 .amplitude = 0.2500001,
                 .frequency = 10.0,
                 .angle = 1.5};
  Series m{};
  begin<14>(m, start);
  expand_rock<14, false>(m, constants_of(start), 0.0);
  EXPECT_EQ(m.tilt_rate[1], 0.0);
  EXPECT_GT(m.tilt_rate[2], 0.0) << "beta' cos(psi)/2";
  SlipParameters<double> slip = slip_of(start);
  slip.first_rate_gate = 0.0;
  expand_slide<14, false>(m, constants_of(start), slip);
  EXPECT_EQ(m.slip_rate[1], 0.0);
  EXPECT_NE(m.slip_rate[2], 0.0);
}

template <class Constants>
void expect_forces_of_series(const Start& start, const Constants& constants) {
  Series m{};
  begin<14>(m, start, constants);
  expand_rock<14, false>(m, constants, 1.0);
  expand_normal<14, false>(m, constants);
  const State state{.tilt = start.tilt, .tilt_rate = start.tilt_rate, .side = start.side};
  const Forces forces =
      rocking_forces(state, {.horizontal = start.side * m.base[0], .weight = 1.0}, any_constants_of(start));
  ASSERT_EQ(forces.normal, m.normal[0]);
  ASSERT_EQ(forces.acceleration, start.side * m.tilt_rate[1]);
  ASSERT_EQ(start.side * forces.friction, constants.load * m.base[0] - m.rate_cosine[1]);
}

TEST(RockingForces, AreThoseOfTheSeriesToTheBit) {
  support::SplitMix draw(25);
  for (int i = 0; i < 10'000; ++i) {
    const Start start = random_start(draw);
    expect_forces_of_series(start, constants_of(start));
    const Start off_middle = general(start, draw);
    expect_forces_of_series(off_middle, any_constants_of(off_middle));
  }
}

/// Smallest value over [0, length] of sum row[k] x^k, k <= degree, at 200 instants.
double least_on(const Series::Row& row, int degree, double length) {
  double least = value(row, degree, 0.0);
  for (int i = 1; i <= 200; ++i) least = std::fmin(least, value(row, degree, length * i / 200.0));
  return least;
}

// Guards that are not evaluated must not fire. The bound holds until the block lands, which another guard detects.
TEST(OutOfReach, IsOnlyWhatASeriesDoesNotReach) {
  support::SplitMix draw(27);
  int balances = 0;
  int normals = 0;
  for (int i = 0; i < 200'000; ++i) {
    Start start = random_start(draw);
    const double balance = start.block.shape_angle;
    start.side = 1.0;
    start.tilt = balance * draw.uniform(0.0, 1.0);
    start.tilt_rate = draw.uniform(-3.0, 3.0) * balance;
    const double length = std::exp2(draw.uniform(-8.0, -1.0)) / start.frequency;
    Series m{};
    begin<14>(m, start);
    expand_rock<14, false>(m, constants_of(start), 1.0);
    expand_normal<14, false>(m, constants_of(start));
    const auto out = out_of_reach<double>(
        {.tilt = m.tilt[0], .tilt_rate = m.tilt_rate[0], .base_amplitude = start.amplitude, .length = length},
        constants_of(start));
    if (least_on(m.tilt, 15, length) < 0.0) continue;
    Series::Row until_balance = m.tilt;
    for (double& coefficient : until_balance) coefficient = -coefficient;
    until_balance[0] += balance;
    balances += out.past_balance ? 1 : 0;
    normals += out.normal ? 1 : 0;
    if (out.past_balance) {
      ASSERT_GT(least_on(until_balance, 15, length), 0.0) << "start " << i;
    }
    if (out.normal) {
      ASSERT_GT(least_on(m.normal, 13, length), 0.0) << "start " << i;
    }
  }
  EXPECT_GT(balances, 20'000);
  EXPECT_GT(normals, 2'000);
}

template <class Constants>
void expect_rates_of_series(const Start& start, const Constants& constants) {
  Series m{};
  begin<14>(m, start, constants);
  expand_rock_slide<14, false>(m, constants, slip_of(start));
  const State state{
      .tilt = start.tilt, .tilt_rate = start.tilt_rate, .side = start.side, .slip_direction = start.direction};
  const SlippingRates rates = slipping_rates(state, {.horizontal = start.side * m.base[0], .weight = 1.0},
                                             start.kinetic_friction, any_constants_of(start));
  ASSERT_EQ(rates.tilt_acceleration, start.side * m.tilt_rate[1]);
  ASSERT_EQ(rates.slip_acceleration, start.side * m.slip_rate[1]);
}

TEST(SlippingRates, AreThoseOfTheSeriesToTheBit) {
  support::SplitMix draw(26);
  for (int i = 0; i < 10'000; ++i) {
    const Start start = random_start(draw);
    expect_rates_of_series(start, constants_of(start));
    const Start off_middle = general(start, draw);
    expect_rates_of_series(off_middle, any_constants_of(off_middle));
  }
}

}  // namespace
}  // namespace rocking::dynamics

// Sliding over cells of different friction (lib/docs/model.md, section 5), against its closed form in each cell.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/realisation/scene_coefficients.hpp"
#include "support/excitation.hpp"
#include "support/scene_with_cells.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t seed_of_draws = 5;

/// The wide block as it slides in full contact, computed from its closed form in each cell: V' = -4/3 (alpha + s mu_k),
/// alpha = a sin(w tau). The ends of slip and of cells are found by bisection. Cells and draws as the documents say.
class SlidingInCells {
 public:
  SlidingInCells(const Scene& scene, const random::Draws& draws)
      : draws_(draws), friction_(*scene.friction), fluctuation_(scene.fluctuation) {
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
    length_ = *scene.fluctuation.refresh_slip_m / block.half_diagonal;
    push_ = mean_of(support::harmonic(scene).amplitude) * block.shape_angle;
    frequency_ = mean_of(support::harmonic(scene).frequency_ratio);
  }

  /// X at the end of each period.
  std::vector<double> slips(int periods) {
    const double step = 1e-3 / frequency_;  // shorter ones add more rounding: at 1e-4, up to 3e-10
    const double period = 2.0 * pi / frequency_;
    std::vector<double> found;
    for (int k = 1; k <= periods; ++k) {
      while (time_ < k * period - 1e-13) advance(std::min(step, k * period - time_));
      found.push_back(slip_);
    }
    return found;
  }

  [[nodiscard]] int crossings() const { return crossings_; }
  [[nodiscard]] int returns() const { return returns_; }

 private:
  [[nodiscard]] std::uint64_t index() const {
    return static_cast<std::uint64_t>(cell_ < 0 ? -2 * cell_ - 1 : 2 * cell_);
  }
  [[nodiscard]] double mu_s() const {
    return std::get<double>(friction_.static_coefficient) +
           fluctuation_.static_friction * draws_.standard_normal(random::Source::static_friction, index());
  }
  [[nodiscard]] double mu_k() const {
    const double wanted =
        std::get<double>(friction_.kinetic_coefficient) +
        fluctuation_.kinetic_friction * draws_.standard_normal(random::Source::kinetic_friction, index());
    return std::min(wanted, mu_s());
  }
  [[nodiscard]] double alpha() const { return push_ * std::sin(frequency_ * time_); }
  [[nodiscard]] double rate_after(double h) const {
    const double swing = push_ / frequency_ * (std::cos(frequency_ * time_) - std::cos(frequency_ * (time_ + h)));
    return rate_ - 4.0 / 3.0 * (swing + direction_ * mu_k() * h);
  }
  [[nodiscard]] double slip_after(double h) const {
    const double w = frequency_;
    const double swing = push_ / w * (std::cos(w * time_) * h - (std::sin(w * (time_ + h)) - std::sin(w * time_)) / w);
    return slip_ + rate_ * h - 4.0 / 3.0 * (swing + direction_ * mu_k() * h * h / 2.0);
  }
  void move(double h) {
    const double slip = slip_after(h);
    rate_ = rate_after(h);
    slip_ = slip;
    time_ += h;
  }
  template <class Below>
  static double first(double h, const Below& is_below) {
    double low = 0.0, high = h;
    for (int k = 0; k < 60; ++k) (is_below(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return high;
  }

  void advance(double h) {
    if (direction_ == 0.0) {
      const auto holds = [this](double t) { return std::abs(push_ * std::sin(frequency_ * (time_ + t))) <= mu_s(); };
      if (holds(h)) {
        time_ += h;
        return;
      }
      time_ += first(h, holds);
      direction_ = alpha() > 0.0 ? -1.0 : 1.0;
      return;
    }
    const double end = (cell_ + 0.5 * direction_) * length_;
    const auto inside = [&](double t) { return direction_ * (end - slip_after(t)) > 0.0; };
    const auto slides = [&](double t) { return direction_ * rate_after(t) > 0.0; };
    const bool just_started = rate_ == 0.0;
    if (!inside(h)) {
      move(first(h, inside));
      cell_ += static_cast<int>(direction_);
      ++crossings_;
      if (cell_ == last_cell_) ++returns_;
      last_cell_ = cell_ - static_cast<int>(direction_);
    } else if (!just_started && !slides(h)) {
      move(first(h, slides));
      rate_ = 0.0;
      direction_ = std::abs(alpha()) <= mu_s() ? 0.0 : (alpha() > 0.0 ? -1.0 : 1.0);
    } else {
      move(h);
    }
  }

  random::Draws draws_;
  Friction friction_;
  Fluctuation fluctuation_;
  double length_ = 0.0, push_ = 0.0, frequency_ = 0.0;
  double time_ = 0.0, slip_ = 0.0, rate_ = 0.0, direction_ = 0.0;
  int cell_ = 0, last_cell_ = 1 << 20, crossings_ = 0, returns_ = 0;
};

TEST(FrictionOfThePlace, GivesTheSlipOfAnIndependentComputation) {
  int crossings = 0, returns = 0;
  for (const double length : {0.001, 0.004, 0.02}) {
    Condition condition;
    condition.scene = support::scene_with_cells(length);
    condition.tolerance = 1e-15;
    support::harmonic(condition.scene).amplitude = 0.8;
    for (std::uint64_t realisation = 0; realisation < 4; ++realisation) {
      const random::Draws draws(seed_of_draws, realisation);
      SlidingInCells sliding(condition.scene, draws);
      const std::vector<double> exact = sliding.slips(6);
      const Trajectory found = trajectory_of(condition, seed_of_draws, realisation, 6);
      ASSERT_EQ(found.strobe.size(), exact.size());
      for (std::size_t k = 0; k < exact.size(); ++k) {
        EXPECT_NEAR(found.strobe[k].slip, exact[k], 1e-10) << length << ", " << realisation << ", period " << k + 1;
      }
      crossings += sliding.crossings();
      returns += sliding.returns();
    }
  }
  EXPECT_GT(crossings, 500);
  EXPECT_GT(returns, 20);
}

TEST(FrictionOfThePlace, TakesTheEnergyThatTheCellsTake) {
  Condition condition;
  condition.scene = support::scene_with_cells(0.003);
  support::harmonic(condition.scene).amplitude = 0.0;
  condition.scene.initial.slip_rate = 0.5;
  for (std::uint64_t realisation = 0; realisation < 20; ++realisation) {
    const random::Draws draws(seed_of_draws, realisation);
    double energy = 0.5 * 0.5 * 0.5, slip = 0.0;
    SceneCoefficients coefficients(condition.scene, draws);
    const dynamics::Clock clock(6.0, 0.0);
    while (true) {  // V'= -4/3 mu_k in each cell
      const double force = 4.0 / 3.0 * coefficients.kinetic_friction(clock);
      const double way = coefficients.cell_end(1.0).value() - slip;
      if (force * way >= energy) break;
      energy -= force * way;
      slip += way;
      coefficients.enter_cell(1.0);
    }
    slip += energy / (4.0 / 3.0 * coefficients.kinetic_friction(clock));
    const Trajectory found = trajectory_of(condition, seed_of_draws, realisation, 4);
    EXPECT_NEAR(found.strobe.back().slip, slip, 1e-13);
    EXPECT_EQ(found.strobe.back().contact, dynamics::ContactState::rest);
  }
}

}  // namespace
}  // namespace rocking

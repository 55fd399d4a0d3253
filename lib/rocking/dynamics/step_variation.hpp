#pragma once

#include <array>
#include <cstddef>

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/dynamics/tangent_series.hpp"

namespace rocking::dynamics {

/// What determines the variational equations of a step besides its series.
struct VariedStep {
  ContactState contact;
  int order;  ///< of the series: full_order or brief_order
  bool has_vertical;
  double drag;  ///< nu = S s mu_k
};

/// The tangent vectors over a step. One vector is a solution of the variational equations; of several, each is a
/// combination of two solutions, whose number does not grow. The truncation error relative to the vector is that of the
/// step relative to psi, as long as the base moves: the coefficients are the step's own series.
template <std::size_t count>
class VariationOfStep {
 public:
  using Tangents = std::array<Tangent<double>, count>;

  /// `start`: the vectors at the start of the step.
  void expand(const MotionSeries<double>& rows, const VariedStep& step, const AnyConstants& constants,
              const Tangents& start) {
    step_ = step;
    start_ = start;
    if (!is_rocking(step.contact)) return;
    if (step.order == full_order) {
      expand_to<full_order>(rows, constants);
    } else {
      expand_to<brief_order>(rows, constants);
    }
  }

  /// Multiplies the vectors by a factor that rounds nothing.
  void scale(double factor) {
    for (Tangent<double>& vector : start_) vector = plus({}, factor, vector);
    if constexpr (solution_count == 1) {
      for (VariationSeries<double>& solution : solutions_) {
        for (double& coefficient : solution.tilt) coefficient *= factor;
        for (double& coefficient : solution.tilt_rate) coefficient *= factor;
      }
    }
  }

  /// At time x of the step.
  [[nodiscard]] Tangents at(double x, const MotionSeries<double>& rows) const {
    const SlipVariation<double> slip = slip_until(x, rows);
    Tangents now;
    if (!is_rocking(step_.contact)) {
      for (std::size_t i = 0; i < count; ++i) now[i] = slip.apply(start_[i], 0.0, 0.0);
      return now;
    }
    std::array<double, solution_count> tilt{};
    std::array<double, solution_count> rate{};
    for (std::size_t k = 0; k < solution_count; ++k) {
      tilt[k] = value(solutions_[k].tilt, step_.order + 1, x);
      rate[k] = value(solutions_[k].tilt_rate, step_.order, x);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Tangent<double>& from = start_[i];
      if constexpr (solution_count == 1) {
        now[i] = slip.apply(from, tilt[0], rate[0]);
      } else {
        now[i] = slip.apply(from, tilt[0] * from.tilt + tilt[1] * from.tilt_rate,
                            rate[0] * from.tilt + rate[1] * from.tilt_rate);
      }
    }
    return now;
  }

 private:
  using Row = MotionSeries<double>::Row;
  static constexpr std::size_t solution_count = count == 1 ? 1 : 2;

  template <int order>
  void expand_to(const MotionSeries<double>& rows, const AnyConstants& constants) {
    begin();
    if (step_.contact == ContactState::rock) {
      if (step_.has_vertical) {
        expand_rock_variation<order, true>(rows, constants, coefficients_);
      } else {
        expand_rock_variation<order, false>(rows, constants, coefficients_);
      }
      for (auto& solution : solutions_) solve_rock_variation<order>(coefficients_, solution);
    } else {
      expand_rock_slide_variation<order>(rows, constants, step_.drag, coefficients_);
      for (auto& solution : solutions_) solve_rock_slide_variation<order>(coefficients_, solution);
    }
  }

  void begin() {
    if constexpr (solution_count == 1) {
      solutions_[0].tilt[0] = start_[0].tilt;
      solutions_[0].tilt_rate[0] = start_[0].tilt_rate;
    } else {
      solutions_[0].tilt[0] = solutions_[1].tilt_rate[0] = 1.0;
      solutions_[0].tilt_rate[0] = solutions_[1].tilt[0] = 0.0;
    }
  }

  [[nodiscard]] SlipVariation<double> slip_until(double x, const MotionSeries<double>& rows) const {
    SlipVariation<double> slip{.duration = x};
    if (step_.contact != ContactState::rock_slide) return slip;
    const auto lever = [this](double sine, double cosine) { return cosine - step_.drag * sine; };
    const auto swing = [this](double sine, double cosine, double rate) { return rate * (sine + step_.drag * cosine); };
    const double sine = value(rows.sine, step_.order + 1, x);
    const double cosine = value(rows.cosine, step_.order + 1, x);
    slip.lever_at_start = lever(rows.sine[0], rows.cosine[0]);
    slip.swing_at_start = swing(rows.sine[0], rows.cosine[0], rows.tilt_rate[0]);
    slip.lever_now = lever(sine, cosine);
    slip.swing_now = swing(sine, cosine, value(rows.tilt_rate, step_.order, x));
    return slip;
  }

  [[nodiscard]] static double value(const Row& row, int degree, double x) {
    double sum = row[static_cast<std::size_t>(degree)];
    for (int k = degree - 1; k >= 0; --k) sum = base::fused(sum, x, row[static_cast<std::size_t>(k)]);
    return sum;
  }

  VariedStep step_{};
  Tangents start_{};
  VariationCoefficients<double> coefficients_;
  std::array<VariationSeries<double>, solution_count> solutions_;
};

}  // namespace rocking::dynamics

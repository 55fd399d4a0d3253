#pragma once

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

/// Two independent solutions of the variational equations over a step, from which that of any tangent vector follows.
/// The truncation error relative to the vector is that of the step relative to psi, as long as the base moves: the
/// coefficients are the step's own series.
class VariationOfStep {
 public:
  void expand(const MotionSeries<double>& rows, const VariedStep& step, const EquationConstants<double>& constants) {
    step_ = step;
    if (!is_rocking(step.contact)) return;
    if (step.order == full_order) {
      expand_to<full_order>(rows, constants);
    } else {
      expand_to<brief_order>(rows, constants);
    }
  }

  /// Over the first `x` of the step.
  [[nodiscard]] StepVariation<double> until(double x, const MotionSeries<double>& rows) const {
    StepVariation<double> over{.duration = x};
    if (!is_rocking(step_.contact)) return over;
    over.tilt_by_tilt = value(by_tilt_.tilt, step_.order + 1, x);
    over.tilt_by_rate = value(by_rate_.tilt, step_.order + 1, x);
    over.rate_by_tilt = value(by_tilt_.tilt_rate, step_.order, x);
    over.rate_by_rate = value(by_rate_.tilt_rate, step_.order, x);
    if (step_.contact == ContactState::rock) return over;
    const auto lever = [this](double sine, double cosine) { return cosine - step_.drag * sine; };
    const auto swing = [this](double sine, double cosine, double rate) { return rate * (sine + step_.drag * cosine); };
    const double sine = value(rows.sine, step_.order + 1, x);
    const double cosine = value(rows.cosine, step_.order + 1, x);
    over.lever_at_start = lever(rows.sine[0], rows.cosine[0]);
    over.swing_at_start = swing(rows.sine[0], rows.cosine[0], rows.tilt_rate[0]);
    over.lever_now = lever(sine, cosine);
    over.swing_now = swing(sine, cosine, value(rows.tilt_rate, step_.order, x));
    return over;
  }

 private:
  using Row = MotionSeries<double>::Row;

  template <int order>
  void expand_to(const MotionSeries<double>& rows, const EquationConstants<double>& constants) {
    by_tilt_.tilt[0] = by_rate_.tilt_rate[0] = 1.0;
    by_tilt_.tilt_rate[0] = by_rate_.tilt[0] = 0.0;
    if (step_.contact == ContactState::rock) {
      if (step_.has_vertical) {
        expand_rock_variation<order, true>(rows, coefficients_);
      } else {
        expand_rock_variation<order, false>(rows, coefficients_);
      }
      solve_rock_variation<order>(coefficients_, by_tilt_);
      solve_rock_variation<order>(coefficients_, by_rate_);
    } else {
      expand_rock_slide_variation<order>(rows, constants, step_.drag, coefficients_);
      solve_rock_slide_variation<order>(coefficients_, by_tilt_);
      solve_rock_slide_variation<order>(coefficients_, by_rate_);
    }
  }

  [[nodiscard]] static double value(const Row& row, int degree, double x) {
    double sum = row[static_cast<std::size_t>(degree)];
    for (int k = degree - 1; k >= 0; --k) sum = base::fused(sum, x, row[static_cast<std::size_t>(k)]);
    return sum;
  }

  VariedStep step_{};
  VariationCoefficients<double> coefficients_;
  VariationSeries<double> by_tilt_;
  VariationSeries<double> by_rate_;
};

}  // namespace rocking::dynamics

#include "rocking/studies/orbits/grazing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Dense>

#include "rocking/studies/orbits/fixed_point.hpp"

namespace rocking {
namespace {

using GrazingMatrix = Eigen::Matrix<double, 4, 5>;  ///< derivative of (H - z, e)

constexpr int most_stages = 40;
constexpr int most_steps_in_stage = 12;
constexpr int most_grazing_halvings = 12;
constexpr double slow_rate = 1e-2;        ///< of a guard that is nearly grazed
constexpr double farthest_start = 1e-2;   ///< from the orbit at which a start is sought
constexpr double widest_passage = 1e-2;   ///< of the guard that is grazed, at the start
constexpr double near_distance = 1e-3;    ///< relative, of the distance of a stage
constexpr double fall_of_distance = 0.1;  ///< from one stage to the next

struct Evaluation {
  PoincareImage image;
  Eigen::Vector4d value;  ///< H - z and e
};

std::optional<Evaluation> evaluate(const GrazingFamily& family, const PlaneUnknowns& at) {
  auto image = image_of(family.orbits, at);
  if (!image || image->not_differentiable.any()) return std::nullopt;
  const auto passed = distance_to(family.guard, *image);
  if (!passed) return std::nullopt;
  const Eigen::Vector4d value{image->end().tilt - at[0], image->end().tilt_rate - at[1], image->end().slip_rate - at[2],
                              *passed};
  return Evaluation{.image = std::move(*image), .value = value};
}

bool is_fixed_by_contact(const PoincareImage& image, std::size_t coordinate) {
  const std::array<double, 3> end{image.end().tilt, image.end().tilt_rate, image.end().slip_rate};
  const auto& row = image.derivative[coordinate];
  return end[coordinate] == 0.0 && row[0] == 0.0 && row[1] == 0.0 && row[2] == 0.0;
}

std::optional<Eigen::Vector4d> slope_along(const GrazingFamily& family, const PlaneUnknowns& at, const Evaluation& here,
                                           std::size_t unknown) {
  const auto beside = [&](double step) -> std::optional<Eigen::Vector4d> {
    PlaneUnknowns other = at;
    other[unknown] += step;
    const auto found = evaluate(family, other);
    if (!found || found->image.sequence != here.image.sequence) return std::nullopt;
    return found->value;
  };
  for (const double step : {1e-6, 1e-7, 1e-8, 1e-9}) {
    const auto above = beside(step);
    const auto below = beside(-step);
    if (above && below) return (*above - *below) / (2.0 * step);
    if (above) return (*above - here.value) / step;
    if (below) return (here.value - *below) / step;
  }
  return std::nullopt;
}

std::optional<GrazingMatrix> matrix_of(const GrazingFamily& family, const PlaneUnknowns& at, const Evaluation& here) {
  GrazingMatrix matrix = GrazingMatrix::Zero();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto column = static_cast<int>(i);
    if (i < 3 && is_fixed_by_contact(here.image, i)) {
      matrix(column, column) = -1.0;
      continue;
    }
    const auto found = slope_along(family, at, here, i);
    if (!found) return std::nullopt;
    matrix.col(column) = *found;
    if (i >= 3) continue;
    for (std::size_t row = 0; row < 3; ++row) {  // exact, from the tangent flow
      matrix(static_cast<int>(row), column) = here.image.derivative[row][i] - (row == i ? 1.0 : 0.0);
    }
  }
  return matrix;
}

double largest_entry_of(const SectionMatrix& matrix) {
  double largest = 1.0;
  for (const auto& row : matrix) {
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  }
  return largest;
}

/// Newton's method for one distance.
class Stage {
 public:
  Stage(const GrazingFamily& family, const PlaneSection& section, base::StopRequest stop)
      : family_(&family), section_(&section), stop_(stop) {}

  /// From `at`, which it moves; whether it converges.
  bool solve(PlaneUnknowns& at, Evaluation& here, double distance) const {
    for (int i = 0; i < most_steps_in_stage; ++i) {
      stop_.check();
      const auto matrix = matrix_of(*family_, at, here);
      if (!matrix) return false;
      Eigen::Matrix<double, 5, 5> whole;
      whole.topRows<4>() = *matrix;
      for (std::size_t k = 0; k < 5; ++k) whole(4, static_cast<int>(k)) = section_->normal[k];
      Eigen::Matrix<double, 5, 1> right;
      right.head<4>() = -here.value;
      right[3] += distance;
      right[4] = -dot(section_->normal, plus(at, -1.0, section_->through));
      const Eigen::Matrix<double, 5, 1> solution = whole.partialPivLu().solve(right);
      if (!solution.allFinite()) return false;
      PlaneUnknowns step{solution[0], solution[1], solution[2], solution[3], solution[4]};
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_fixed_by_contact(here.image, k)) step[k] = -at[k];
      }
      if (!take(at, here, step)) return false;
      if (is_solved(here, distance)) return true;
    }
    return false;
  }

 private:
  /// Steps must keep the changes of contact: beyond the guard there are others, and no distance.
  bool take(PlaneUnknowns& at, Evaluation& here, const PlaneUnknowns& step) const {
    double share = 1.0;
    for (int i = 0; i < most_grazing_halvings; ++i, share *= 0.5) {
      const PlaneUnknowns next = plus(at, share, step);
      auto found = evaluate(*family_, next);
      if (!found || found->image.sequence != here.image.sequence) continue;
      at = next;
      here = std::move(*found);
      return true;
    }
    return false;
  }

  static bool is_solved(const Evaluation& here, double distance) {
    return here.value.head<3>().cwiseAbs().maxCoeff() <= largest_residual * largest_entry_of(here.image.derivative) &&
           std::abs(here.value[3] - distance) <= near_distance * distance;
  }

  const GrazingFamily* family_;
  const PlaneSection* section_;
  base::StopRequest stop_;
};

}  // namespace

std::optional<double> distance_to(dynamics::Guard guard, const PoincareImage& image) {
  std::optional<double> least;
  for (const GuardMinimum& minimum : image.minima) {
    if (minimum.guard != guard || !(minimum.value > 0.0)) continue;
    if (!least || minimum.value < *least) least = minimum.value;
  }
  return least;
}

std::optional<GrazingPoint> graze(const GrazingFamily& family, const PlaneSection& section, const PlaneUnknowns& start,
                                  base::StopRequest stop) {
  auto here = evaluate(family, start);
  if (!here) return std::nullopt;
  PlaneUnknowns at = start;
  const Stage stage(family, section, stop);
  double distance = std::max(here->value[3], grazing_distance);
  if (!stage.solve(at, *here, distance)) return std::nullopt;
  double before = at[3];
  for (int i = 0; i < most_stages && distance > grazing_distance; ++i) {
    before = at[3];
    distance = std::max(fall_of_distance * distance, grazing_distance);
    if (!stage.solve(at, *here, distance)) return std::nullopt;
  }
  const auto matrix = matrix_of(family, at, *here);
  if (!matrix) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(*matrix, Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(4);
  GrazingPoint point{.at = at,
                     .tangent = {last[0], last[1], last[2], last[3], last[4]},
                     .residual = here->value.head<3>().cwiseAbs().maxCoeff(),
                     .distance = here->value[3],
                     .error = std::abs(at[3] - before)};
  for (std::size_t k = 0; k < 5; ++k) point.inward[k] = (*matrix)(3, static_cast<int>(k));
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_fixed_by_contact(here->image, k)) point.tangent[k] = 0.0, point.inward[k] = 0.0;
  }
  if (dot(point.tangent, section.normal) < 0.0) point.tangent = plus({}, -1.0, point.tangent);
  point.image = std::move(here->image);
  return point;
}

std::optional<GrazingStart> start_beside(const CriticalFamily& orbits, const PlaneUnknowns& at) {
  const auto here = image_of(orbits, at);
  if (!here) return std::nullopt;
  const auto slowest = std::ranges::min_element(here->crossings, {},
                                                [](const GuardCrossing& crossing) { return std::abs(crossing.rate); });
  if (slowest == here->crossings.end() || std::abs(slowest->rate) > slow_rate) {
    const auto nearest = std::ranges::min_element(here->minima, {}, &GuardMinimum::value);
    if (nearest == here->minima.end() || !(nearest->value < widest_passage)) return std::nullopt;
    return GrazingStart{.guard = nearest->guard, .at = at};
  }
  const dynamics::Guard guard = slowest->guard;
  for (double far = 1e-9; far <= farthest_start; far *= 2.0) {
    std::optional<GrazingStart> best;
    double least = widest_passage;
    for (std::size_t unknown = 0; unknown < 4; ++unknown) {
      if (unknown < 3 && is_fixed_by_contact(*here, unknown)) continue;
      for (const double side : {-1.0, 1.0}) {
        PlaneUnknowns other = at;
        other[unknown] += side * far;
        const auto found = image_of(orbits, other);
        if (!found || found->sequence.size() >= here->sequence.size()) continue;
        const auto passed = distance_to(guard, *found);
        if (passed && *passed < least) least = *passed, best = {.guard = guard, .at = other};
      }
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace rocking

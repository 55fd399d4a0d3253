#include "rocking/studies/infer/infer.hpp"

#include <algorithm>
#include <utility>

#include <boost/math/distributions/chi_squared.hpp>

#include "rocking/studies/infer/lattice.hpp"
#include "rocking/studies/infer/posterior.hpp"
#include "rocking/studies/infer/profile.hpp"
#include "rocking/studies/infer/survey.hpp"

namespace rocking {
namespace infer {
namespace {

/// Simulated at once: what an interruption loses at most.
constexpr std::size_t points_at_once = 8;
/// Of the width of an interval: how far an end may move when points are added.
constexpr double small_move = 0.1;

/// Of the conditions, candidates last. `former`: of a part of the design; may be empty.
std::vector<ShareModel> models_of(const std::vector<Eigen::VectorXd>& points, const std::vector<DesignPoint>& design,
                                  const std::vector<ShareModel>& former, const base::ManyParts& how) {
  const std::size_t conditions = design.front().counts.size();
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), points.front().size());
  for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  std::vector<std::optional<ShareModel>> fitted(conditions);
  base::for_each_part({.threads = how.threads, .stop = how.stop}, conditions, [&](std::size_t c) {
    std::vector<std::vector<std::uint64_t>> counts;
    for (const DesignPoint& point : design) counts.push_back(point.counts[c]);
    fitted[c].emplace(rows, counts, former.empty() ? nullptr : &former[c], how.stop);
  });
  std::vector<ShareModel> models;
  for (auto& model : fitted) models.push_back(*std::move(model));
  return models;
}

Survey survey_of(const InferenceSetting& setting, const std::vector<ShareModel>& models, const base::ManyParts& how) {
  const auto tested = static_cast<std::ptrdiff_t>(setting.tests.conditions.size());
  std::vector<std::vector<std::uint64_t>> counts;
  for (const TestedCondition& condition : setting.tests.conditions) counts.push_back(condition.counts);
  return survey({models.begin(), models.begin() + tested}, in_one_row(counts), how);
}

class Study {
 public:
  Study(const InferenceSetting& setting, const DesignLimits& limits, const base::ManyParts& how)
      : setting_(&setting), limits_(&limits), how_(how), scale_(setting.unknowns) {}

  [[nodiscard]] Inference inference() {
    try {
      if (extend(first_design(setting_->unknowns.size()))) refine();
      return inference_from(*setting_, design_, end_, how_);
    } catch (const base::Stopped&) {
      return inference_from(*setting_, std::move(design_), InferEnd::stopped, how_);
    }
  }

 private:
  /// Adds points until the intervals have settled.
  void refine() {
    int settled = 0;
    look();
    for (;;) {
      const std::vector<stats::Interval> before = intervals();
      if (points_.size() >= most_points(setting_->unknowns.size())) {
        end_ = InferEnd::most_points;
        return;
      }
      if (!extend(further_points(points_, found_->likelihood.lattice(), found_->deviances))) return;
      look();
      settled = largest_move(before, intervals()) <= small_move ? settled + 1 : 0;
      if (settled == 2) return;
    }
  }

  /// Simulates points; false if it had to end before all were finished.
  [[nodiscard]] bool extend(const std::vector<Eigen::VectorXd>& points) {
    std::vector<std::vector<double>> values;
    for (const Eigen::VectorXd& point : points) values.push_back(scale_.short_values(point));
    for (std::size_t first = 0; first < values.size(); first += points_at_once) {
      const std::size_t end = std::min(values.size(), first + points_at_once);
      if (!simulate(
              {values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(end)}))
        return false;
    }
    return true;
  }

  [[nodiscard]] bool simulate(const std::vector<std::vector<double>>& values) {
    std::vector<std::vector<double>> missing;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!is_known(design_.size() + i, values[i])) missing.push_back(values[i]);
    }
    CountsAtPoints found;
    if (!missing.empty()) {
      how_.stop.check();
      if (!has_time()) {
        end_ = InferEnd::out_of_time;
        return false;
      }
      const double start = elapsed();
      found = setting_->simulate(missing);
      longest_ = std::max(longest_, elapsed() - start);
    }
    auto next = found.begin();
    for (const std::vector<double>& at : values) {
      const std::size_t place = design_.size();
      design_.push_back({.at = at, .counts = is_known(place, at) ? limits_->earlier[place].counts : *next++});
      points_.push_back(scale_.point(at));
    }
    if (limits_->keep && !missing.empty()) limits_->keep(design_);
    return true;
  }

  [[nodiscard]] bool is_known(std::size_t place, const std::vector<double>& at) const {
    return place < limits_->earlier.size() && limits_->earlier[place].at == at;
  }

  [[nodiscard]] double elapsed() const { return limits_->elapsed_seconds ? limits_->elapsed_seconds() : 0.0; }

  [[nodiscard]] bool has_time() const { return !limits_->seconds || elapsed() + longest_ < *limits_->seconds; }

  /// Fits the models to the design.
  void look() {
    models_ = models_of(points_, design_, models_, how_);
    found_.emplace(survey_of(*setting_, models_, how_));
  }

  /// In the unit cube, by the asymptotic limit.
  [[nodiscard]] std::vector<stats::Interval> intervals() const {
    const Lattice& lattice = found_->likelihood.lattice();
    const double limit = boost::math::quantile(boost::math::chi_squared(1.0), setting_->confidence);
    const Eigen::VectorXd limits =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(lattice.points_on_axis()), limit);
    std::vector<stats::Interval> intervals;
    for (std::size_t axis = 0; axis < lattice.axes(); ++axis) {
      intervals.push_back(interval_below(lattice, axis, profile_on(lattice, axis, found_->deviances), limits));
    }
    return intervals;
  }

  /// Of an end, over the width of the interval.
  [[nodiscard]] static double largest_move(const std::vector<stats::Interval>& before,
                                           const std::vector<stats::Interval>& after) {
    double largest = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double move = std::max(std::abs(after[i].low - before[i].low), std::abs(after[i].high - before[i].high));
      largest = std::max(largest, move / std::max(after[i].high - after[i].low, 1e-12));
    }
    return largest;
  }

  const InferenceSetting* setting_;
  const DesignLimits* limits_;
  base::ManyParts how_;
  Scale scale_;
  std::vector<Eigen::VectorXd> points_;  ///< of the design, in the unit cube
  std::vector<ShareModel> models_;       ///< by condition
  std::optional<Survey> found_;
  double longest_ = 0.0;  ///< time of a simulation so far [s]
  std::vector<DesignPoint> design_;
  InferEnd end_ = InferEnd::settled;
};

}  // namespace
}  // namespace infer

Inference inference_from(const InferenceSetting& setting, std::vector<infer::DesignPoint> design, InferEnd end,
                         const base::ManyParts& how) {
  Inference result{.design = std::move(design), .answer = {}, .end = end};
  std::vector<Eigen::VectorXd> points;
  const infer::Scale scale(setting.unknowns);
  for (const infer::DesignPoint& point : result.design) {
    points.push_back(scale.point(point.at));
    for (const auto& of_condition : point.counts) {
      for (const std::uint64_t count : of_condition) result.realisations += count;
    }
  }
  const bool has_first_design = points.size() >= infer::first_design(setting.unknowns.size()).size();
  if (!has_first_design || end == InferEnd::stopped) return result;
  const std::vector<infer::ShareModel> models = infer::models_of(points, result.design, {}, how);
  result.answer = infer::answer_of(setting, models, infer::survey_of(setting, models, how), how);
  return result;
}

std::uint64_t made_up_sets(const InferenceSetting& setting) { return infer::sets_of_answer(setting); }

void check_priors(const std::vector<Unknown>& unknowns) { static_cast<void>(infer::reach_of_priors(unknowns)); }

Inference infer_unknowns(const InferenceSetting& setting, const DesignLimits& limits, const base::ManyParts& how) {
  check_priors(setting.unknowns);
  return infer::Study(setting, limits, how).inference();
}

}  // namespace rocking

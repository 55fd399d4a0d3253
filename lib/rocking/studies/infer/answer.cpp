#include "rocking/studies/infer/survey.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "rocking/studies/infer/made_up_tests.hpp"
#include "rocking/studies/infer/posterior.hpp"
#include "rocking/studies/infer/profile.hpp"

namespace rocking::infer {
namespace {

constexpr std::size_t sets_for_limits = 399;
constexpr std::size_t sets_for_fit = 999;
constexpr std::size_t sets_for_region = 999;

std::vector<std::vector<std::uint64_t>> counts_of(const CountedTests& tests) {
  std::vector<std::vector<std::uint64_t>> counts;
  for (const TestedCondition& condition : tests.conditions) counts.push_back(condition.counts);
  return counts;
}

class Answering {
 public:
  Answering(const InferenceSetting& setting, const std::vector<ShareModel>& models, const Survey& found,
            const base::ManyParts& how)
      : setting_(&setting),
        models_(&models),
        found_(&found),
        scale_(setting.unknowns),
        counts_(counts_of(setting.tests)),
        posterior_(posterior_of({models.begin(), models.begin() + static_cast<std::ptrdiff_t>(counts_.size())},
                                in_one_row(counts_), setting.unknowns, found, how)),
        threads_(how.threads) {
    for (const auto& counts : counts_) {
      tests_.push_back(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    }
    best_ = best_point(lattice(), found.logarithms);
    each_set_.stop = how.stop;
    if (!how.on_part) return;
    each_set_.on_part = [this, &how] {
      const std::lock_guard lock(mutex_);
      how.on_part();
    };
  }
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;

  [[nodiscard]] InferenceAnswer answer() const {
    InferenceAnswer answer;
    answer.unknowns.resize(setting_->unknowns.size());
    answer.candidates.resize(setting_->tests.candidates.size());
    answer.log_likelihood = found_->logarithms[static_cast<Eigen::Index>(best_)] + log_coefficients(counts_);
    answer.predicted = predicted();
    std::vector<std::function<void()>> parts;
    for (std::size_t k = 0; k < answer.unknowns.size(); ++k) {
      parts.emplace_back([&, k] { answer.unknowns[k] = of_unknown(k); });
    }
    for (std::size_t i = 0; i < answer.candidates.size(); ++i) {
      parts.emplace_back([&, i] {
        answer.candidates[i] =
            gain_of((*models_)[tests_.size() + i], setting_->next_tests, posterior_, setting_->seed, each_set_);
      });
    }
    parts.emplace_back([&] { answer.fit = fit(); });
    parts.emplace_back([&] { add_region(answer); });
    base::for_each_part({.threads = threads_, .stop = each_set_.stop}, parts.size(),
                        [&](std::size_t i) { parts[i](); });
    return answer;
  }

 private:
  [[nodiscard]] const Lattice& lattice() const { return found_->likelihood.lattice(); }
  [[nodiscard]] double value_at(std::size_t k, std::size_t place) const {
    return scale_.value(k, lattice().coordinate(place, k));
  }
  /// Of the points of the lattice that the answer has.
  [[nodiscard]] std::size_t places_apart() const { return lattice().axes() == 1 ? 4 : 2; }
  [[nodiscard]] std::span<const ShareModel> tested() const { return {models_->data(), tests_.size()}; }

  [[nodiscard]] Eigen::MatrixXd make_up(const Eigen::VectorXd& point, std::size_t sets,
                                        ErrorsOfConditions errors = ErrorsOfConditions::bounded) const {
    return made_up_tests(tested(), tests_, point, {.seed = setting_->seed, .first = 0, .sets = sets, .errors = errors},
                         each_set_);
  }

  [[nodiscard]] UnknownAnswer of_unknown(std::size_t k) const {
    const Eigen::VectorXd limits = profile_limits(
        found_->likelihood, k, found_->deviances,
        [this](const Eigen::VectorXd& point) { return make_up(point, sets_for_limits); }, setting_->confidence);
    const Eigen::VectorXd profile = profile_on(lattice(), k, found_->deviances);
    const stats::Interval inside = interval_below(lattice(), k, profile, limits);
    UnknownAnswer answer{.estimate = value_at(k, lattice().place(best_, k)),
                         .interval = {.low = scale_.value(k, inside.low), .high = scale_.value(k, inside.high)}};
    const bool reaches_from = inside.low <= 0.0;
    const bool reaches_to = inside.high >= 1.0;
    if (reaches_from && reaches_to)
      answer.reaches = ReachedBound::both;
    else if (reaches_from)
      answer.reaches = ReachedBound::from;
    else if (reaches_to)
      answer.reaches = ReachedBound::to;
    const bool has_prior =
        std::ranges::any_of(setting_->unknowns, [](const Unknown& u) { return u.prior.has_value(); });
    for (std::size_t place = 0; place < lattice().points_on_axis(); place += places_apart()) {
      answer.profile.push_back(
          {.at = value_at(k, place), .likelihood_ratio = std::exp(-0.5 * profile[static_cast<Eigen::Index>(place)])});
    }
    if (has_prior) answer.posterior = summary(posterior_, setting_->unknowns, k, setting_->confidence);
    return answer;
  }

  [[nodiscard]] std::vector<PredictedShares> predicted() const {
    std::vector<PredictedShares> all;
    const Eigen::VectorXd point = lattice().point(best_);
    for (std::size_t c = 0; c < tests_.size(); ++c) {
      PredictedShares of_condition;
      const Eigen::VectorXd shares = (*models_)[c].log_shares(point).array().exp();
      of_condition.shares.assign(shares.begin(), shares.end());
      for (const std::uint64_t count : counts_[c]) {
        of_condition.intervals.push_back(
            stats::clopper_pearson({.successes = count, .trials = tests_[c]}, setting_->confidence));
      }
      all.push_back(std::move(of_condition));
    }
    return all;
  }

  [[nodiscard]] InferenceFit fit() const {
    const Eigen::MatrixXd sets = make_up(lattice().point(best_), sets_for_fit, ErrorsOfConditions::independent);
    const double found = statistic(in_one_row(counts_), found_->logarithms.maxCoeff());
    const Eigen::MatrixXd logarithms = found_->likelihood.logarithms_of_sets(sets);
    const double rounding = 1e-9 * (1.0 + std::abs(found));  // sets with the counts of the tests are ties
    std::size_t larger = 1;
    for (Eigen::Index set = 0; set < sets.cols(); ++set) {
      if (statistic(sets.col(set), logarithms.col(set).maxCoeff()) >= found - rounding) ++larger;
    }
    return {.statistic = found, .p_value = static_cast<double>(larger) / static_cast<double>(sets_for_fit + 1)};
  }

  /// The deviance of a data set whose largest log-likelihood is `most`.
  [[nodiscard]] double statistic(const Counts& counts, double most) const {
    double saturated = 0.0;
    const auto groups = counts.size() / static_cast<Eigen::Index>(tests_.size());
    for (Eigen::Index i = 0; i < counts.size(); ++i) {
      const auto tests = static_cast<double>(tests_[static_cast<std::size_t>(i / groups)]);
      if (counts[i] > 0.0) saturated += counts[i] * std::log(counts[i] / tests);
    }
    return 2.0 * (saturated - most);
  }

  /// Points of every second or so place of the lattice, and the best one.
  void add_region(InferenceAnswer& answer) const {
    const Eigen::MatrixXd sets = make_up(lattice().point(best_), sets_for_region);
    const double limit = region_limit(found_->likelihood.logarithms_of_sets(sets), best_, setting_->confidence);
    answer.region_limit = std::exp(-0.5 * limit);
    for (std::size_t i = 0; i < lattice().size(); ++i) {
      bool is_shown = true;
      for (std::size_t axis = 0; axis < lattice().axes(); ++axis)
        is_shown &= lattice().place(i, axis) % places_apart() == 0;
      const double deviance = found_->deviances[static_cast<Eigen::Index>(i)];
      if ((!is_shown && i != best_) || deviance > limit) continue;
      answer.region.push_back({.at = scale_.values(lattice().point(i)), .likelihood_ratio = std::exp(-0.5 * deviance)});
    }
  }

  const InferenceSetting* setting_;
  const std::vector<ShareModel>* models_;
  const Survey* found_;
  Scale scale_;
  std::vector<std::vector<std::uint64_t>> counts_;
  Posterior posterior_;
  std::vector<std::uint64_t> tests_;  ///< by tested condition
  std::size_t best_ = 0;
  unsigned threads_;
  base::ManyParts each_set_;  ///< how data sets are made up, by several threads at a time
  std::mutex mutex_;
};

}  // namespace

std::uint64_t sets_of_answer(const InferenceSetting& setting) {
  return setting.unknowns.size() * places_of_limits * sets_for_limits + sets_for_fit + sets_for_region +
         setting.tests.candidates.size() * sets_of_candidate;
}

InferenceAnswer answer_of(const InferenceSetting& setting, const std::vector<ShareModel>& models, const Survey& found,
                          const base::ManyParts& how) {
  return Answering(setting, models, found, how).answer();
}

}  // namespace rocking::infer

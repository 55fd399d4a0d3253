#include "rocking/output/check_reported_counts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "rocking/output/validity_fields.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;
constexpr double rounding = 1e-12;

class CountChecker {
 public:
  explicit CountChecker(Problems& problems) : problems_(&problems) {}

  void check(const Report& report) {
    if (const auto& found = report.tolerance_sensitivity) {
      place_ = "/result/tolerance_sensitivity";
      part_of(found->flips.successes, found->flips.trials, "/flips");
    }
    for (std::size_t i = 0; i < report.conditions.size() && problems_->size() < most_problems; ++i) {
      place_ = "/result/conditions/" + std::to_string(i);
      check(report.conditions[i].result);
    }
  }

 private:
  template <class Value>
  void reject(const std::string& place, const Value& value, std::string reason) {
    if (problems_->size() >= most_problems) return;
    problems_->push_back({place_ + place, Json(value).dump(), std::move(reason),
                          "`rocking run` writes the report again; `rocking verify` compares it with its realisations"});
  }

  void part_of(std::uint64_t part, std::uint64_t whole, const std::string& place) {
    if (part > whole) reject(place, part, "is greater than their number, " + std::to_string(whole));
  }

  void check(const ConditionResult& result) {
    if (result.realisations > static_cast<std::uint64_t>(rules::realisations.high)) {
      return reject("/realisations", result.realisations,
                    "is greater than the largest number that an experiment may have");
    }
    check_modes(result);
    if (result.non_recurrence) check_non_recurrence(*result.non_recurrence, result.realisations);
    const PeakQuantiles& peaks = result.peaks;
    check_quantiles(peaks.tilt, result.realisations, "/peak_tilt");
    check_quantiles(peaks.tilt_rate, result.realisations, "/peak_tilt_rate");
    if (result.exponents) check_quantiles(result.exponents->quantiles, result.realisations, "/lyapunov_exponent");
    if (peaks.slip) check_quantiles(peaks.slip->over_half_diagonal, result.realisations, "/peak_slip");
    if (peaks.final_slip) check_quantiles(peaks.final_slip->over_half_diagonal, result.realisations, "/final_slip");
    check_validity(result);
  }

  void check_modes(const ConditionResult& result) {
    std::uint64_t sum = 0;
    for (const auto& [mode, probability] : result.modes) {
      const std::uint64_t count = probability.counts.successes;
      const std::string place = "/probabilities/" + to_string(mode);
      part_of(count, result.realisations, "/counts/" + to_string(mode));
      sum += std::min(count, result.realisations);
      const double share = static_cast<double>(count) / static_cast<double>(result.realisations);
      if (std::abs(probability.estimate - share) > rounding) {
        reject(place + "/estimate", probability.estimate, "is not count/n, " + Json(share).dump());
      }
      if (!probability.corrected) continue;
      const stats::CheckedCounts& checked = probability.corrected->counts;
      part_of(checked.checked, result.realisations, place + "/corrected/checked");
      part_of(checked.gained, checked.checked, place + "/corrected/gained");
      part_of(checked.lost, checked.checked, place + "/corrected/lost");
    }
    if (sum == result.realisations) return;
    reject("/counts", sum, "is the sum of the counts, not the number of realisations");
  }

  void check_non_recurrence(const NonRecurrence& found, std::uint64_t realisations) {
    for (const auto& [times, key] : {std::pair(&found.friction, "/non_recurrence/divergence_by_friction"),
                                     std::pair(&found.arithmetic, "/non_recurrence/divergence_by_tolerance")}) {
      part_of(times->pairs, realisations, std::string(key) + "/pairs");
      part_of(times->diverged, times->pairs, std::string(key) + "/diverged");
    }
    part_of(found.arithmetic_flips.trials, realisations, "/non_recurrence/arithmetic_flips/of");
    part_of(found.arithmetic_flips.successes, found.arithmetic_flips.trials, "/non_recurrence/arithmetic_flips/count");
  }

  void check_quantiles(const Quantiles& quantiles, std::uint64_t realisations, const std::string& place) {
    part_of(quantiles.realisations, realisations, place + "/realisations");
    part_of(quantiles.beyond, quantiles.realisations, place + "/beyond");
  }

  void check_validity(const ConditionResult& result) {
    for_each_case(result.validity, [&](const std::string& name, const Cases& cases) {
      part_of(cases.count, result.realisations, "/validity/" + name);
      for (const std::uint64_t number : cases.first) {
        part_of(number + 1, result.realisations, "/validity/first_realisations/" + name);
      }
    });
  }

  Problems* problems_;
  std::string place_;  ///< of what is checked
};

}  // namespace

void check_reported_counts(const Report& report, Problems& problems) { CountChecker(problems).check(report); }

}  // namespace rocking

#include "rocking/output/alarms.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "rocking/base/number_text.hpp"
#include "rocking/ensemble/law_in_force.hpp"
#include "rocking/output/report.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// The normal law in which a number scatters along the way; absent if there is no number, or it has another law.
std::optional<stats::MeanAndSigma> normal_law_of(const Quantity* number, double sigma, FluctuationLaw law) {
  const double* mean = number == nullptr ? nullptr : std::get_if<double>(number);
  if (mean == nullptr || !(sigma > 0.0) || law != FluctuationLaw::normal) return std::nullopt;
  return stats::MeanAndSigma{*mean, sigma};
}

std::optional<stats::MeanAndSigma> law_of_static(const Scene& scene) {
  const Quantity* number = scene.friction ? &scene.friction->static_coefficient : nullptr;
  return normal_law_of(number, scene.fluctuation.static_friction, scene.fluctuation.laws.static_friction);
}

std::optional<stats::MeanAndSigma> law_of_kinetic(const Scene& scene) {
  const bool is_given = scene.friction && !scene.friction->kinetic_ratio;
  const Quantity* number = is_given ? &scene.friction->kinetic_coefficient : nullptr;
  return normal_law_of(number, scene.fluctuation.kinetic_friction, scene.fluctuation.laws.kinetic_friction);
}

std::optional<stats::MeanAndSigma> law_of_restitution(const Scene& scene) {
  return normal_law_of(std::get_if<Quantity>(&scene.restitution), scene.fluctuation.restitution,
                       scene.fluctuation.laws.restitution);
}

std::optional<stats::MeanAndSigma> law_of_amplitude(const Scene& scene) {
  const Quantity* number = std::visit(
      []<class Kind>(const Kind& kind) -> const Quantity* {
        if constexpr (requires { kind.physical_amplitude; }) return kind.physical_amplitude ? nullptr : &kind.amplitude;
        return nullptr;
      },
      scene.excitation);
  return normal_law_of(number, scene.fluctuation.amplitude, scene.fluctuation.laws.amplitude);
}

/// A number that may be clamped.
struct ClampedNumber {
  std::string_view key;  ///< of the kind of clamp
  const char* name;
  std::optional<stats::MeanAndSigma> (*law)(const Scene& scene);
};

constexpr std::array clamped_numbers{ClampedNumber{"static_friction_at_zero", "static friction", law_of_static},
                                     ClampedNumber{"kinetic_friction_at_zero", "kinetic friction", law_of_kinetic},
                                     ClampedNumber{"kinetic_friction_at_static", "kinetic friction", law_of_kinetic},
                                     ClampedNumber{"restitution", "restitution", law_of_restitution},
                                     ClampedNumber{"amplitude_at_zero", "amplitude", law_of_amplitude}};

/// What clamps of a kind leave of the law of a random number, `the kinetic friction in force has mean 0.348 and sigma 0.0274,
/// not 0.35 and 0.03`. Empty if the law is not normal or not known. `key`: that of the kind of clamp in a report.
std::string law_in_force_words(const Scene& scene, std::string_view key) {
  const auto* const clamped = std::ranges::find(clamped_numbers, key, &ClampedNumber::key);
  if (clamped == clamped_numbers.end()) return "";
  const auto given = clamped->law(scene);
  if (!given) return "";
  const FluctuatingNumber number{
      .law = *given, .limit = law_of_static(scene), .correlation = scene.fluctuation.friction_correlation};
  const auto in_force = law_in_force(number, key);
  if (!in_force) return "";
  return std::string("the ") + clamped->name + " in force has mean " + significant(in_force->mean, 3) + " and sigma " +
         significant(in_force->sigma, 3) + ", not " + significant(given->mean, 3) + " and " +
         significant(given->sigma, 3);
}

/// Tolerances below this one reach no more digits in double precision (reports/evidence/accuracy.md).
constexpr double finest_useful_tolerance = 1e-15;

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// The key of the kind of clamp that occurred most often.
std::string_view commonest_clamp(const Clamps& clamps) {
  const auto found =
      std::ranges::max_element(clamp_kinds, {}, [&clamps](const ClampKind& kind) { return clamps.*kind.count; });
  return found->key;
}

std::optional<std::string> contact_alarm(const Report& report) {
  std::uint64_t count = 0;
  std::string first;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Cases& cases = report.conditions[i].result.validity.left_ground_before_fall;
    if (cases.count > 0 && count == 0) {
      first = "first: --condition " + std::to_string(i) + " --realisation " + std::to_string(cases.first.front());
    }
    count += cases.count;
  }
  if (count == 0) return std::nullopt;
  return counted(count, "realisation") +
         " lost contact with the base (normal force of zero or less) before any final fall; the model does not hold "
         "there (" +
         first + "). Do not rely on the response modes of these realisations";
}

std::optional<std::string> answer_alarm(const Report& report) {
  std::uint64_t count = 0, painleve = 0, all = 0;
  for (const ReportedCondition& condition : report.conditions) {
    count += condition.result.without_answer();
    painleve += condition.result.validity.painleve.count;
    all += condition.result.realisations;
  }
  if (count == 0) return std::nullopt;
  return std::to_string(count) + " of " + counted(all, "realisation") +
         " ended before their horizon without an answer" +
         (painleve > 0 ? ", " + std::to_string(painleve) + " by Painleve's paradox" : "") +
         ": whether they overturn is not known. They are unresolved, and the upper end of each interval counts them "
         "as well. The page names the first of them; the remedy for a budget of steps is less slip in a cell of "
         "friction or in a period (larger /fluctuation/friction/refresh_slip_m)";
}

std::optional<std::string> clamp_alarm(const Report& report) {
  const auto worst = worst_clamps(report);
  if (!worst) return std::nullopt;
  return "random numbers were clamped in " + in_words(worst->share) + " of condition " +
         std::to_string(worst->condition) + ", the most of any; mostly " + worst->remedy;
}

struct Remedy {
  std::string_view key;
  std::string_view text;
};

constexpr std::array remedies{
    Remedy{"kinetic_friction_at_zero",
           "kinetic friction below 0: reduce the sigma of its fluctuation or increase /friction/kinetic"},
    Remedy{"kinetic_friction_at_static",
           "kinetic friction above the static friction in force: add \"correlation\": 1 to /fluctuation/friction, so "
           "that both "
           "move together, reduce the sigma of the friction, or increase the difference between /friction/static and "
           "/friction/kinetic"},
    Remedy{"static_friction_at_zero",
           "static friction below 0: reduce the sigma of its fluctuation or increase /friction/static"},
    Remedy{"restitution", "restitution outside of its range: reduce the sigma in /fluctuation/restitution"},
    Remedy{"amplitude_at_zero", "amplitude below 0: reduce the sigma in /fluctuation/amplitude"},
    Remedy{"block_length_at_bound",
           "width or height of the block outside of its bounds: reduce the sigma of /block/width_m or /block/height_m"},
};

std::string clamp_remedy(const Scene& scene, std::string_view key) {
  const auto* const found = std::ranges::find(remedies, key, &Remedy::key);
  std::string text(found == remedies.end() ? std::string_view("another kind") : found->text);
  const std::string in_force = law_in_force_words(scene, key);
  return in_force.empty() ? text : text + ". The probabilities are those of other numbers: " + in_force;
}

}  // namespace

double ClampedShare::share_of_realisations() const { return share(realisations, of_realisations); }
double ClampedShare::share_of_draws() const { return share(draws, of_draws); }
bool ClampedShare::is_alarming() const {
  return share_of_realisations() > tolerable_clamped_share || share_of_draws() > tolerable_clamped_share;
}

std::string in_words(const ClampedShare& share) {
  return per_cent(share.share_of_realisations()) + " % of the realisations and " + per_cent(share.share_of_draws()) +
         " % of the draws";
}

std::optional<WorstClamps> worst_clamps(const Report& report) {
  std::optional<WorstClamps> worst;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const ConditionResult& result = report.conditions[i].result;
    const ClampedShare here{.realisations = result.validity.clamped.count,
                            .of_realisations = result.realisations,
                            .draws = result.validity.clamps.all(),
                            .of_draws = result.operations.draws()};
    if (!here.is_alarming() || (worst && here.share_of_draws() <= worst->share.share_of_draws())) continue;
    worst = {.condition = i,
             .share = here,
             .remedy = clamp_remedy(report.conditions[i].asked.scene, commonest_clamp(result.validity.clamps))};
  }
  return worst;
}

std::vector<std::string> foreseen_clamps(const Experiment& experiment) {
  const std::vector<SampledClamps> sampled = sample_clamps(experiment);
  std::vector<std::string> alarms;
  for (const ClampKind& kind : clamp_kinds) {
    const auto of_draws = [&kind](const SampledClamps& here) {
      return share(here.clamps.*kind.count, here.realisations);
    };
    const auto worst = std::ranges::max_element(sampled, {}, of_draws);
    if (worst == sampled.end() || of_draws(*worst) <= tolerable_clamped_share) continue;
    const bool is_one = experiment.conditions.size() == 1;
    alarms.push_back("random numbers would be clamped in " + significant(100.0 * of_draws(*worst), 2) +
                     " % of their draws" +
                     (is_one ? "" : " in condition " + std::to_string(worst->condition) + ", the most of any") + ": " +
                     clamp_remedy(experiment.conditions[worst->condition].scene, kind.key));
  }
  return alarms;
}

std::optional<std::string> left_out_records(const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  std::string text = counted(names.size(), "record") + " of the suite could not be read and " +
                     (names.size() == 1 ? "was" : "were") + " left out:";
  for (const std::string& name : names) text += (&name == names.data() ? " " : ", ") + name;
  return text + ". The probabilities are those of the others";
}

std::optional<std::string> restitution_alarm(const Report& report) {
  RateRatios ratios;
  for (const ReportedCondition& condition : report.conditions) ratios.add(condition.asked.scene);
  return ratios.doubt() ? std::optional("restitution " + ratios.text()) : std::nullopt;
}

std::string tolerance_remedy(double tolerance) {
  if (tolerance <= finest_useful_tolerance) {
    return "/accuracy/tolerance is at the limit of double precision: these changes are due to rounding. Treat the "
           "share that changes as an uncertainty of every probability, in addition to its interval";
  }
  const double finer = std::max(finest_useful_tolerance, tolerance / 100.0);
  return "set /accuracy/tolerance to " + base::significant(finer, 2) + " and run again";
}

std::vector<std::string> alarms_of(const Report& report) {
  std::vector<std::string> alarms;
  for (auto& alarm : {left_out_records(report.left_out), answer_alarm(report), far_scaled(report.ground_motions),
                      restitution_alarm(report), contact_alarm(report), clamp_alarm(report)}) {
    if (alarm) alarms.push_back(*alarm);
  }
  return alarms;
}

}  // namespace rocking

#include "rocking/output/clamp_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rocking/ensemble/law_in_force.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr const char* friction_fluctuation = "/fluctuation/friction";

/// Where an experiment has the law of a number that may be clamped.
struct ClampedNumber {
  std::string_view key;  ///< of the kind of clamp
  const char* name;
  const char* mean;         ///< JSON pointer
  const char* fluctuation;  ///< JSON pointer to its sigma and law
};

constexpr std::array clamped_numbers{
    ClampedNumber{"static_friction_at_zero", "static friction", "/friction/static", friction_fluctuation},
    ClampedNumber{"kinetic_friction_at_zero", "kinetic friction", "/friction/kinetic", friction_fluctuation},
    ClampedNumber{"kinetic_friction_at_static", "kinetic friction", "/friction/kinetic", friction_fluctuation},
    ClampedNumber{"restitution", "restitution", "/restitution", "/fluctuation/restitution"},
    ClampedNumber{"amplitude_at_zero", "amplitude", "/excitation/amplitude", "/fluctuation/amplitude"}};

/// The normal law of a number; absent if it has another one.
std::optional<stats::MeanAndSigma> normal_law_of(const Report& report, const ReportedCondition& condition,
                                                 const std::string& mean, const std::string& fluctuation) {
  const Json::json_pointer law(fluctuation + "/law");
  if (report.input.experiment.contains(law) && report.input.experiment.at(law) != "normal") return std::nullopt;
  const auto centre = report.number(mean, condition);
  auto sigma = report.number(fluctuation + "/sigma", condition);
  const auto relative = report.number(fluctuation + "/relative_sigma", condition);
  if (centre && !sigma && relative) sigma = *relative * std::abs(*centre);
  if (!centre || !sigma || !(*sigma > 0.0)) return std::nullopt;
  return stats::MeanAndSigma{*centre, *sigma};
}

}  // namespace

std::string law_in_force_words(const Report& report, const ReportedCondition& condition, std::string_view key) {
  const auto* const place = std::ranges::find(clamped_numbers, key, &ClampedNumber::key);
  if (place == clamped_numbers.end()) return "";
  const auto given = normal_law_of(report, condition, place->mean, place->fluctuation);
  if (!given) return "";
  const FluctuatingNumber number{
      .law = *given,
      .limit = normal_law_of(report, condition, "/friction/static", friction_fluctuation),
      .correlation = report.number(std::string(friction_fluctuation) + "/correlation", condition).value_or(0.0)};
  const auto in_force = law_in_force(number, key);
  if (!in_force) return "";
  return std::string("the ") + place->name + " in force has mean " + significant(in_force->mean, 3) + " and sigma " +
         significant(in_force->sigma, 3) + ", not " + significant(given->mean, 3) + " and " +
         significant(given->sigma, 3);
}

}  // namespace rocking

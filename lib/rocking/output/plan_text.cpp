#include "rocking/output/plan_text.hpp"

#include <algorithm>

#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

std::string at_most(const Plan& plan) { return plan.at_most ? "at most" : "about"; }

/// What `until_classified` adds; empty without it.
std::string continued_text(const Plan& plan) {
  if (plan.most_periods <= plan.periods) return "";
  std::string text;
  if (plan.time->unresolved) {
    const double share = static_cast<double>(*plan.time->unresolved) / static_cast<double>(plan.time->realisations);
    text = "until_classified: " + std::to_string(*plan.time->unresolved) +
           " of the sample were unresolved at the fixed horizon; if all such realisations went on to their limit, at "
           "most about " +
           duration_in_words(seconds_if_continued(plan, share)) + '\n';
  }
  return text + "until_classified: if every realisation went on to its limit, at most about " +
         duration_in_words(seconds_if_continued(plan, 1.0)) + '\n';
}

std::string time_text(const Plan& plan) {
  if (!plan.time) return "";
  const auto& [seconds, realisations, share, unresolved] = *plan.time;
  const std::string horizons =
      share < 1.0 ? " over the first " + significant(100.0 * share, 2) + " % of their periods" : "";
  return at_most(plan) + ' ' + duration_in_words(seconds) +
         (plan.most_periods > plan.periods ? " for the fixed horizon" : "") + ", from a sample of " +
         counted(realisations, "realisation") + horizons + '\n' + continued_text(plan);
}

}  // namespace

std::string plan_text(const Plan& plan) {
  std::string text = plan.title.empty() ? "" : plan.title + '\n';
  text += counted(plan.conditions, "condition") + ", " + (plan.at_most ? "at most " : "") +
          counted(plan.realisations, "realisation") + ", " + counted(plan.periods, "period") + " of the " +
          (plan.has_record ? "strobe" : "excitation") + '\n';
  if (plan.most_periods > plan.periods) {
    text += "at most " + counted(plan.most_periods, "period") + " with until_classified\n";
  }
  text += at_most(plan) + ' ' + size_in_words(plan.needs.disk_bytes) + " of disk space, " +
          size_in_words(plan.needs.memory_bytes) + " of memory\n";
  text += time_text(plan) + "\nSimulated: rocking";
  const bool is_random = std::ranges::any_of(
      plan.effects, [](const std::string& effect) { return effect.find("drawn") != std::string::npos; });
  for (const std::string& effect : plan.effects) text += ", " + effect;
  text += std::string(is_random ? "" : "; nothing is random") + ".\nNot simulated: ";
  for (const std::string& effect : plan.omitted) text += effect + ", ";
  return text + "flight, the third dimension.\nImpacts: " + plan.impacts + ".\n" + plan.thresholds;
}

std::vector<Fact> plan_facts(const Plan& plan) {
  std::vector<Fact> facts{
      {"title", plan.title},     {"conditions", plan.conditions},       {"realisations", plan.realisations},
      {"periods", plan.periods}, {"disk_bytes", plan.needs.disk_bytes}, {"memory_bytes", plan.needs.memory_bytes},
      {"effects", plan.effects}};
  if (plan.most_periods > plan.periods) facts.push_back({"most_periods", plan.most_periods});
  if (plan.time) {
    facts.push_back({"seconds", plan.time->seconds});
    facts.push_back({"sampled_realisations", plan.time->realisations});
    facts.push_back({"sampled_share_of_horizon", plan.time->horizon_share});
    if (plan.most_periods > plan.periods) facts.push_back({"most_seconds", seconds_if_continued(plan, 1.0)});
  }
  return facts;
}

}  // namespace rocking

#include "rocking/output/plan_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/look/table.hpp"
#include "rocking/scene/restitution.hpp"
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

/// Numbers of an edge in all conditions.
struct EdgeNumbers {
  NumberRange distance, radius, shape_angle, degrees, frequency, uplift, rate_ratio;
  std::size_t slides = 0;  ///< conditions in which the block slides before it turns about the edge

  void add(const dynamics::Geometry& block, const dynamics::Edge& edge) {
    distance.add(edge.sine * block.half_diagonal);
    radius.add(edge.radius * block.half_diagonal);
    shape_angle.add(edge.shape_angle);
    degrees.add(edge.shape_angle * (180.0 / std::numbers::pi));
    frequency.add(block.frequency_parameter * std::sqrt(edge.rocking_gain * edge.radius));
    uplift.add(edge.tangent);
    rate_ratio.add(dynamics::inelastic_rate_ratio(edge));
  }
  /// Whether the block turns about it in any condition.
  [[nodiscard]] bool is_known() const { return distance.least <= distance.largest; }
  [[nodiscard]] look::Row row(const std::string& name, const std::string& direction, std::size_t conditions) const {
    const std::string sliding = slides == 0 ? "no"
                                : slides == conditions
                                    ? "yes"
                                    : "in " + std::to_string(slides) + " of " + std::to_string(conditions);
    return {name,
            distance.text(),
            radius.text(),
            shape_angle.text(),
            degrees.text(),
            frequency.text(),
            uplift.text() + direction,
            rate_ratio.text(),
            sliding};
  }
};

/// The numbers of the block as a whole.
struct BodyNumbers {
  NumberRange height, radius, inertia, frequency;
  bool is_drawn = false, has_friction = false, has_sides = false;

  [[nodiscard]] std::string text(std::size_t conditions) const {
    std::string which = is_drawn ? "with the means of its laws" : "";
    if (conditions > 1) which += std::string(is_drawn ? ", " : "") + "over " + counted(conditions, "condition");
    return "Block" + (which.empty() ? "" : " (" + which + ')') + ": centre of mass " + height.text() +
           " m above the base, I = " + inertia.text() + " m R^2; units R = " + radius.text() +
           " m, 1/p with p = " + frequency.text() + " rad/s";
  }
};

constexpr std::string_view block_legend =
    "b: edge to centre of mass, horizontally; R: edge to centre of mass; p: sqrt(m g R/I) with I about the edge; "
    "uplift: base\n"
    "acceleration that lifts a block at rest, which turns about this edge; Housner: rate ratio when this edge lands, e "
    "= 0\n";

}  // namespace

std::string block_text(const Experiment& experiment) {
  BodyNumbers body;
  std::array<EdgeNumbers, 2> sides;
  for (const Condition& condition : experiment.conditions) {
    const Scene& scene = condition.scene;
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
    body.height.add(block.cosine * block.half_diagonal);
    body.radius.add(block.half_diagonal);
    body.inertia.add(block.inertia);
    body.frequency.add(block.frequency_parameter);
    body.is_drawn = body.is_drawn || is_drawn(scene.block);
    body.has_friction = body.has_friction || scene.friction;
    body.has_sides = body.has_sides || !block.has_mirror_symmetry();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (block.open_side * (i == 0 ? 1.0 : -1.0) < 0.0) continue;
      sides[i].add(block, block.edges[i]);
      if (scene.friction && mean_static(*scene.friction) < block.edges[i].tangent) ++sides[i].slides;
    }
  }
  const std::size_t conditions = experiment.conditions.size();
  look::Table table{.title = body.text(conditions), .notes = std::string(block_legend)};
  add_columns(table, {"edge", "b [m]", "R [m]", "psi [rad]", "psi [deg]", "p [rad/s]", "uplift [g]", "Housner",
                      "slides first"});
  if (body.has_sides) {
    const auto add = [&](const EdgeNumbers& side, const char* name, const char* direction) {
      if (side.is_known()) table.rows.push_back(side.row(name, direction, conditions));
    };
    add(sides[0], "left", " to the right");
    add(sides[1], "right", " to the left");
  } else {
    table.rows = {sides[0].row("both", "", conditions)};
  }
  table.notes +=
      body.has_friction
          ? "slides first: a block at rest slides, and does not rock, as static friction is below the uplift\n"
          : "slides first: friction is not given, so that the block cannot slide\n";
  return to_terminal(table);
}

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

#include "rocking/scene/restitution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

using dynamics::Geometry;
using random::Source;

// e itself

double mean(const Quantity& e, const Geometry&, double) { return mean_of(e); }
double as_given(const Quantity& e, const Geometry&) { return mean_of(e); }
double unit(const Quantity&, const Geometry&) { return 1.0; }
std::optional<double> lognormal(const Quantity& e) { return mean_of(e); }
RestitutionNumbers numbers(const Quantity& e) {
  return {{{{{"/restitution", "restitution", "e"}, Source::mean_restitution}, &e}, {}}};
}
Reach bounds(const Quantity&, Source, const Geometry&, double largest) { return {least_restitution, largest}; }
std::optional<Refusal> refusal(const Quantity&, std::size_t, const ShapeRange&, double) { return std::nullopt; }
RightEdge right_edge(const Quantity&, const Geometry&) { return {}; }
bool is_alike(const Quantity&) { return true; }
constexpr Form form(const Quantity*) { return {.name = "", .rule = &rules::restitution}; }
void put(const Quantity& e, Formed& formed) { formed.value = e; }
void set(Quantity& e, Formed value) { e = std::move(value.value); }

// Jeong & Yang (2012)

double mean(const Jy25Restitution&, const Geometry& block, double) { return dynamics::inelastic_rate_ratio(block); }
double as_given(const Jy25Restitution& law, const Geometry& block) { return mean(law, block, 1.0); }
double unit(const Jy25Restitution&, const Geometry&) { return 1.0; }
std::optional<double> lognormal(const Jy25Restitution&) { return std::nullopt; }
RestitutionNumbers numbers(const Jy25Restitution&) { return {}; }
Reach bounds(const Jy25Restitution&, Source, const Geometry&, double largest) { return {least_restitution, largest}; }
std::optional<Refusal> refusal(const Jy25Restitution&, std::size_t, const ShapeRange&, double) { return std::nullopt; }
RightEdge right_edge(const Jy25Restitution&, const Geometry&) { return {}; }
bool is_alike(const Jy25Restitution&) { return true; }
constexpr Form form(const Jy25Restitution*) { return {.name = "jy25", .rule = nullptr}; }
void put(const Jy25Restitution&, Formed&) {}
void set(Jy25Restitution&, const Formed&) {}

// A measured ratio of the tilt rates

/// The number of the edge of a side with the sign of `landing`.
const Quantity& of_edge(const RateRatio& ratio, double landing) {
  return ratio.right && landing < 0.0 ? *ratio.right : ratio.value;
}
/// Sides with the edges to which the number with this source applies.
std::vector<double> sides_of(const RateRatio& ratio, Source source) {
  if (!ratio.right) return {1.0, -1.0};
  return {source == Source::mean_restitution ? 1.0 : -1.0};
}
double mean(const RateRatio& ratio, const Geometry& block, double landing) {
  return dynamics::restitution_of_rate_ratio(block.edge(landing), mean_of(of_edge(ratio, landing)));
}
double as_given(const RateRatio& ratio, const Geometry&) {
  return 0.5 * (mean_of(of_edge(ratio, 1.0)) + mean_of(of_edge(ratio, -1.0)));
}
double unit(const RateRatio&, const Geometry& block) { return dynamics::impact_loss(0.0, block); }
std::optional<double> lognormal(const RateRatio&) { return std::nullopt; }
RestitutionNumbers numbers(const RateRatio& ratio) {
  if (!ratio.right) {
    return {{{{{"/restitution/rate_ratio", "rate ratio", "δ"}, Source::mean_restitution}, &ratio.value}, {}}};
  }
  return {
      {{{{"/restitution/rate_ratio/0", "rate ratio of the left edge", "δ_1"}, Source::mean_restitution}, &ratio.value},
       {{{"/restitution/rate_ratio/1", "rate ratio of the right edge", "δ_-1"}, Source::mean_right_restitution},
        &*ratio.right}}};
}
/// The least ratio that an impact with e at its largest leaves.
double least_ratio(const dynamics::Edge& landing, double largest_e) {
  return std::isinf(largest_e) ? 0.0 : std::max(0.0, dynamics::inelastic_rate_ratio(landing, largest_e));
}
Reach bounds(const RateRatio& ratio, Source source, const Geometry& block, double largest_e) {
  Reach both{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const double side : sides_of(ratio, source)) {
    both.least = std::max(both.least, least_ratio(block.edge(side), largest_e));
    both.largest = std::min(both.largest, dynamics::inelastic_rate_ratio(block.edge(side), least_restitution));
  }
  return both;
}
std::optional<Refusal> refusal(const RateRatio& ratio, std::size_t number, const ShapeRange& shapes, double largest_e) {
  const RestitutionNumber given = numbers(ratio)[number];
  if (given.value == nullptr) return std::nullopt;
  const auto shown = [](double value) { return base::significant(value, 6); };
  for (const double side : sides_of(ratio, given.source)) {
    for (const Geometry* block : {&shapes.most_slender, &shapes.squattest}) {
      const double e = mean(ratio, *block, side);
      if (e >= -1.0 && e <= largest_e) continue;
      const bool is_one = block->has_mirror_symmetry() && !ratio.right;
      const std::string edge = side < 0.0 ? "right" : "left";
      const bool is_bounded = !std::isinf(largest_e);
      const double least = least_ratio(block->edge(side), largest_e);
      return Refusal{"needs a restitution e = " + shown(e) + (is_one ? "" : " at the " + edge + " edge") +
                         " for this block, which must be at least -1" + (is_bounded ? " and at most 1" : ""),
                     "give at least " + std::string(is_bounded && block->is_rectangle() ? "1 - 3 sin^2(psi) = " : "") +
                         shown(least) + " and at most 1" +
                         (is_bounded && e > 1.0 ? "; a block that cannot slide, without scatter of the ratio along the "
                                                  "way, may have less: omit \"friction\" and \"fluctuation\""
                                                : "")};
    }
  }
  return std::nullopt;
}
RightEdge right_edge(const RateRatio& ratio, const Geometry& block) {
  const auto& [left, right] = block.edges;
  const double of_right = dynamics::impact_loss(0.0, right);
  const double more = ratio.right ? (mean_of(ratio.value) - mean_of(*ratio.right)) / of_right : 0.0;
  return {.share = dynamics::impact_loss(0.0, left) / of_right, .more = more};
}
bool is_alike(const RateRatio& ratio) { return !ratio.right || *ratio.right == ratio.value; }
constexpr Form form(const RateRatio*) {
  return {.name = "rate_ratio", .rule = &rules::rate_ratio, .may_differ_by_side = true};
}
void put(const RateRatio& ratio, Formed& formed) {
  formed.value = ratio.value;
  formed.right = ratio.right;
}
void set(RateRatio& ratio, Formed value) { ratio = {.value = std::move(value.value), .right = std::move(value.right)}; }

// The rebound from a wall

/// e with which an impact of this edge sends the block back.
double at_wall(double ratio, const dynamics::Edge& landing) {
  return dynamics::restitution_of_rate_ratio(landing, -ratio);
}
double mean(const WallRatio& wall, const Geometry& block, double landing) {
  return at_wall(mean_of(wall.value), block.edge(landing));
}
double as_given(const WallRatio& wall, const Geometry&) { return mean_of(wall.value); }
double unit(const WallRatio&, const Geometry& block) { return dynamics::impact_loss(0.0, block); }
std::optional<double> lognormal(const WallRatio&) { return std::nullopt; }
RestitutionNumbers numbers(const WallRatio& wall) {
  return {{{{{"/block/wall/rate_ratio", "rate ratio at the wall", "e_w"}, Source::mean_restitution}, &wall.value}, {}}};
}
Reach bounds(const WallRatio&, Source, const Geometry&, double) { return {0.0, largest_wall_ratio}; }
std::optional<Refusal> refusal(const WallRatio&, std::size_t, const ShapeRange&, double) { return std::nullopt; }
RightEdge right_edge(const WallRatio&, const Geometry& block) { return right_edge(RateRatio{}, block); }
bool is_alike(const WallRatio&) { return true; }

/// Along the way.
template <class Law>
Reach redrawn(const Law&, const Geometry&) {
  return {least_restitution, largest_restitution};
}
Reach redrawn(const WallRatio&, const Geometry& block) {
  const dynamics::Edge& landing = block.edge(-block.open_side);
  return {at_wall(0.0, landing), at_wall(largest_wall_ratio, landing)};
}

/// Of the key `restitution`, in the order of the alternatives; the rebound from a wall stands with the wall.
constexpr std::array forms{form(static_cast<const Quantity*>(nullptr)),
                           form(static_cast<const Jy25Restitution*>(nullptr)),
                           form(static_cast<const RateRatio*>(nullptr))};
void put(const WallRatio&, Formed&) {}
void set(WallRatio&, const Formed&) {}

}  // namespace

double mean_restitution(const Restitution& law, const Geometry& block, double landing) {
  return std::visit([&](const auto& each) { return mean(each, block, landing); }, law);
}

double mean_as_given(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return as_given(each, block); }, law);
}

double unit_of(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return unit(each, block); }, law);
}

std::optional<double> lognormal_mean(const Restitution& law) {
  return std::visit([](const auto& each) { return lognormal(each); }, law);
}

RestitutionNumbers numbers_of(const Restitution& law) {
  return std::visit([](const auto& each) { return numbers(each); }, law);
}

double largest_restitution_of(const Scene& scene) {
  const bool is_free =
      std::holds_alternative<RateRatio>(scene.restitution) && !scene.friction && scene.fluctuation.restitution == 0.0;
  return is_free ? std::numeric_limits<double>::infinity() : largest_restitution;
}

Reach bounds_of(const Scene& scene, Source source, const Geometry& block) {
  const double largest = largest_restitution_of(scene);
  return std::visit([&](const auto& each) { return bounds(each, source, block, largest); }, scene.restitution);
}

std::optional<Refusal> refusal_of(const Scene& scene, std::size_t number) {
  const ShapeRange shapes = shapes_of(scene.block);
  const double largest = largest_restitution_of(scene);
  return std::visit([&](const auto& each) { return refusal(each, number, shapes, largest); }, scene.restitution);
}

Reach reach_along_the_way(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return redrawn(each, block); }, law);
}

RightEdge right_edge_of(const Restitution& law, const Geometry& block) {
  return std::visit([&](const auto& each) { return right_edge(each, block); }, law);
}

bool is_alike_at_both_edges(const Restitution& law) {
  return std::visit([](const auto& each) { return is_alike(each); }, law);
}

const FormsType& restitution_type() {
  static const FormsType type(forms,
                              "write a number, \"jy25\" for 1 - 1.5 sin^2(psi), or {\"rate_ratio\": 0.93} for a "
                              "measured ratio of the tilt rates, [left, right] where the edges have two");
  return type;
}

Formed formed(const Restitution& law) {
  Formed formed{.form = law.index()};
  std::visit([&formed](const auto& each) { put(each, formed); }, law);
  return formed;
}

Restitution restitution_of(Formed value) {
  auto law = alternative_at<Restitution>(value.form);
  std::visit([&](auto& each) { set(each, std::move(value)); }, law);
  return law;
}

namespace {

/// Least share of Housner's ratio without a second sentence. Measured ratios lie above it for most blocks.
constexpr double usual_share = 0.85;
/// The least ratio of the rates over Housner's that was measured: slender blocks on rubber (ElGawady, Ma, Butterworth & Ingham,
/// reports/experiments/free_rocking.md). A number from here to 1 may be such a ratio, whatever is meant.
constexpr double least_measured_share = 0.67;

}  // namespace

void NumberRange::add(double number) {
  least = std::min(least, number);
  largest = std::max(largest, number);
}

std::string NumberRange::text() const {
  const std::string first = base::significant(least, 3);
  const std::string last = base::significant(largest, 3);
  return first == last ? first : first + " to " + last;
}

void RateRatios::add(const Scene& scene) {
  if (const auto* wall = std::get_if<WallRatio>(&scene.restitution)) return at_wall_.add(mean_of(wall->value));
  const Geometry block = dynamics::geometry_of(mean_block(scene));
  for (const double side : {1.0, -1.0}) {
    const dynamics::Edge& edge = block.edge(side);
    const double restitution = mean_restitution(scene.restitution, block, side);
    const double ratio = dynamics::inelastic_rate_ratio(edge, restitution);
    const double housner = dynamics::inelastic_rate_ratio(edge);
    OfEdge& here = edges_[side < 0.0 ? 1 : 0];
    here.restitution.add(restitution);
    here.ratio.add(ratio);
    here.housner.add(housner);
    if (!std::holds_alternative<Quantity>(scene.restitution)) continue;
    if (!(housner > 0.0)) continue;
    share_.add(ratio / housner);
    if (restitution >= least_measured_share * housner && restitution < 1.0) like_ratios_.add(restitution);
  }
}

std::string RateRatios::text() const {
  if (at_wall_.largest >= at_wall_.least) {
    return at_wall_.text() + " of the tilt rate comes back from the wall, away from which the block turns";
  }
  const auto of = [this](NumberRange OfEdge::*numbers) {
    const std::string left = (edges_[0].*numbers).text(), right = (edges_[1].*numbers).text();
    return left == right ? left : left + " (left edge) and " + right + " (right edge)";
  };
  const bool is_imposed =
      std::ranges::any_of(edges_, [](const OfEdge& edge) { return edge.restitution.largest > largest_restitution; });
  std::string text = (is_imposed ? "" : "e = " + of(&OfEdge::restitution) + ": ") + of(&OfEdge::ratio) +
                     " of the tilt rate survives an impact without slip (Housner's ratio: " + of(&OfEdge::housner) +
                     (is_imposed ? "), which is less than an impact of edges alone leaves" : ")");
  const auto doubt_in_words = doubt();
  return doubt_in_words ? text + ". " + *doubt_in_words : text;
}

std::optional<std::string> RateRatios::doubt() const {
  const bool is_low = share_.least < usual_share;
  const bool is_like_ratio = like_ratios_.largest > 0.0;
  if (!is_low && !is_like_ratio) return std::nullopt;
  const std::string number = is_like_ratio ? base::significant(like_ratios_.largest, 3) : "0.93";
  return (is_low ? "This is less than 0.85 of Housner's ratio"
                 : "An e of " + number + " is as large as measured ratios of the rates, 0.67 of Housner's and more") +
         std::string(". If your number is such a measured ratio, write \"restitution\": {\"rate_ratio\": ") + number +
         '}';
}

}  // namespace rocking

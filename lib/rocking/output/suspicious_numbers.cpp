#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

#include "rocking/dynamics/impact.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/section/classify.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr double most_usual_g = 5.0;  // the strongest records reach 4.4 g
constexpr double largest_usual_angle = 4.0 * 3.15;
constexpr std::string_view lengths = "lengths are in metres: 45 cm are 0.45, 45 mm 0.045";
constexpr std::string_view strongest =
    "recorded ground motions reach 4 g; \"amplitude_g\" is in g, \"amplitude_m_s2\" in m/s^2";
constexpr std::string_view coefficients = "a coefficient is a ratio, 40 % are 0.4";
constexpr std::string_view angles = "angles are in radians, 90 degrees are 1.571";

/// Values of a key that need no second look.
struct UsualRange {
  std::string_view key;
  double least;
  double largest;
  std::string_view unit;
  std::string_view remedy;
};

constexpr double none = -1e300;
constexpr std::array usual_ranges{
    UsualRange{"width_m", 0.01, 30.0, " m", lengths},
    UsualRange{"height_m", 0.01, 30.0, " m", lengths},
    UsualRange{"centre_height_m", 0.005, 15.0, " m", lengths},
    UsualRange{"edges_m", 0.005, 15.0, " m", lengths},
    UsualRange{"frequency_hz", 0.05, 50.0, " Hz",
               "earthquakes and shake tables have 0.1 to 35 Hz; frequencies are in Hz"},
    UsualRange{"period_s", 0.02, 20.0, " s", "periods are in seconds, 1 ms is 0.001"},
    UsualRange{"amplitude_g", none, most_usual_g, " g", strongest},
    UsualRange{"amplitude_m_s2", none, most_usual_g * 10.0, " m/s^2", strongest},
    UsualRange{"static", none, 2.0, "", coefficients},
    UsualRange{"kinetic", none, 2.0, "", coefficients},
    UsualRange{"phase_rad", -largest_usual_angle, largest_usual_angle, "", angles},
};

const UsualRange* range_of(std::string_view place) {
  const auto* const found = std::ranges::find_if(usual_ranges, [place](const UsualRange& range) {
    return place.ends_with('/' + std::string(range.key)) ||
           place.find('/' + std::string(range.key) + '/') != place.npos;
  });
  return found == usual_ranges.end() ? nullptr : found;
}

/// What is alarming, each place once, with the number of conditions.
class Suspicions {
 public:
  void add(std::string_view place, std::string text, std::string_view remedy = "") {
    const auto known = std::ranges::find(found_, place, &Finding::place);
    const auto index = static_cast<std::size_t>(known - found_.begin());
    if (known == found_.end()) {
      found_.push_back({.name = "unusual number",
                        .text = std::move(text),
                        .remedy = std::string(remedy),
                        .place = std::string(place)});
      conditions_.push_back(0);
    }
    ++conditions_[index];
  }
  [[nodiscard]] std::vector<Finding> among(std::size_t conditions) && {
    for (std::size_t i = 0; conditions > 1 && i < found_.size(); ++i) {
      found_[i].text += " (in " + std::to_string(conditions_[i]) + " of " + counted(conditions, "condition") + ')';
    }
    return std::move(found_);
  }

 private:
  std::vector<Finding> found_;
  std::vector<std::size_t> conditions_;  ///< of each
};

void look_at_numbers(const Scene& scene, Suspicions& found) {
  for_each_quantity(scene, [&found](const QuantityPlace& what, const Quantity& quantity) {
    const UsualRange* usual = range_of(what.place);
    const double mean = mean_of(quantity);
    if (usual == nullptr || (mean >= usual->least && mean <= usual->largest)) return;
    const bool is_more = mean > usual->largest;
    found.add(what.place,
              text_of(quantity) + " is " + (is_more ? "above " : "below ") +
                  significant(is_more ? usual->largest : usual->least, 3) + std::string(usual->unit) +
                  ", which is unusual",
              usual->remedy);
  });
}

/// Whether the classifier has points enough, also in each window of a realisation that goes on until it is classified.
void look_at_horizon(const Condition& condition, Suspicions& found) {
  const bool random = is_random_along_the_way(condition.scene);
  const int fewest = section::fewest_periods(random);
  const int sampled = condition.horizon.sampled_periods;
  if (!is_periodic(condition.scene.excitation) || sampled >= fewest) return;
  found.add("/horizon/sampled_periods",
            std::to_string(sampled) +
                " are too few points to classify a response, so that every block that moves is unresolved or overturns",
            "give at least " + std::to_string(fewest) + (random ? " where something is random" : "") +
                "; the default is 120");
}

void look_at_restitution(const Scene& scene, Suspicions& found) {
  RateRatios ratios;
  ratios.add(scene);
  if (ratios.doubt()) found.add("/restitution", ratios.text());
}

/// Returns whether an impact is unusual.
bool look_at_impacts(const Scene& scene, Suspicions& found) {
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  for (const double side : {1.0, -1.0}) {
    const dynamics::Edge& edge = block.edge(side);
    const double ratio = dynamics::inelastic_rate_ratio(edge, mean_restitution(scene.restitution, block, side));
    const bool is_squat = edge.tangent > 1.0;
    if (!is_squat && (ratio >= 0.0 || scene.block.wall)) continue;
    const std::string shape =
        "the block is squat: its edge is " + significant(edge.sine * block.half_diagonal, 3) +
        " m from the centre of mass, which is " + significant(block.cosine * block.half_diagonal, 3) +
        " m above the base; only a base acceleration above " + significant(edge.tangent, 3) + " g lifts it. ";
    const std::string impact =
        "An impact leaves " + significant(ratio, 3) + " of the tilt rate" +
        (ratio < 0.0
             ? ". Below 0 the block does not go on over its other edge: it swings back over the one on which it came"
             : "");
    found.add(is_squat ? "/block" : "/restitution", (is_squat ? shape : "") + impact,
              is_squat ? "if width and height are swapped, exchange them" : "");
    return true;
  }
  return false;
}

/// Of a part on the mean, two intervals.
struct Rectangle {
  Reach across, up;
};

Rectangle rectangle_of(const BlockPart& part) {
  const double x = mean_of(part.x), half = 0.5 * mean_of(part.width), bottom = mean_of(part.bottom);
  return {.across = {x - half, x + half}, .up = {bottom, bottom + mean_of(part.height)}};
}

/// What two parts have in common in the direction in which that is shorter; negative: their distance.
double overlap(const Rectangle& a, const Rectangle& b) {
  const auto common = [](const Reach& one, const Reach& other) {
    return std::min(one.largest, other.largest) - std::max(one.least, other.least);
  };
  return std::min(common(a.across, b.across), common(a.up, b.up));
}

/// Parts in one place, and parts that nothing carries.
void look_at_parts(const Scene& scene, Suspicions& found) {
  const auto* given = std::get_if<GivenParts>(&scene.block.mass);
  if (given == nullptr) return;
  constexpr double clearance = 1e-6;  // m, of rounding
  std::vector<Rectangle> shapes;
  for (const BlockPart& part : given->parts) shapes.push_back(rectangle_of(part));
  const auto name = [](std::size_t i) { return "/block/parts/" + std::to_string(i); };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double common = overlap(shapes[i], shapes[k]);
      if (common <= clearance) continue;
      found.add(name(i), "overlaps " + name(k) + " by " + significant(common, 3) + " m, where both masses count",
                "move or shorten one of them");
    }
  }
  // From those on the floor, or lowest, to what touches them.
  std::vector<std::size_t> places(shapes.size()), carried;
  std::iota(places.begin(), places.end(), 0);
  const auto bottom = [&shapes](std::size_t i) { return shapes[i].up.least; };
  const double lowest = bottom(*std::ranges::min_element(places, {}, bottom));
  std::erase_if(places, [&](std::size_t i) {
    if (bottom(i) <= lowest + clearance) carried.push_back(i);
    return bottom(i) <= lowest + clearance;
  });
  for (std::size_t next = 0; next < carried.size(); ++next) {
    std::erase_if(places, [&](std::size_t i) {
      const bool touches = overlap(shapes[i], shapes[carried[next]]) >= -clearance;
      if (touches) carried.push_back(i);
      return touches;
    });
  }
  for (const std::size_t i : places) {
    found.add(name(i), "touches no part that is carried from below", "check \"bottom_m\" and \"x_m\"");
  }
}

}  // namespace

std::vector<Finding> suspicious_numbers(const Experiment& experiment) {
  Suspicions found;
  for (const Condition& condition : experiment.conditions) {
    look_at_numbers(condition.scene, found);
    look_at_parts(condition.scene, found);
    if (!look_at_impacts(condition.scene, found)) look_at_restitution(condition.scene, found);
  }
  return std::move(found).among(experiment.conditions.size());
}

std::vector<Finding> too_few_periods(const Experiment& experiment) {
  Suspicions found;
  for (const Condition& condition : experiment.conditions) look_at_horizon(condition, found);
  return std::move(found).among(experiment.conditions.size());
}

}  // namespace rocking

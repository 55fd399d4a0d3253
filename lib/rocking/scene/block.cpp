#include "rocking/scene/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "rocking/base/elementary.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/drawn_quantities.hpp"

namespace rocking {
namespace {

/// Drawn lengths are truncated to their bounds.
Reach reach_of_number(const Quantity& number, bool is_length) {
  const auto [least, largest] = reach_of(number);
  if (!is_drawn(number) || !is_length) return {least, largest};
  return {.least = std::clamp(least, least_length, largest_length),
          .largest = std::clamp(largest, least_length, largest_length)};
}

/// Most numbers with laws whose corners are looked at; the others stay at their means.
constexpr std::size_t most_at_corners = 12;

/// Calls visit(block) for each block whose drawn numbers are at the ends of their reach.
template <class Visit>
void for_each_corner(const SceneBlock& block, const Visit& visit) {
  SceneBlock corner = block;
  std::vector<Quantity*> drawn;
  std::vector<Reach> reaches;
  for_each_block_number(corner, [&](const BlockNumber& what, Quantity& number) {
    if (!is_drawn(number)) return;
    if (drawn.size() == most_at_corners) {
      number = mean_of(number);
      return;
    }
    drawn.push_back(&number);
    reaches.push_back(reach_of_number(number, what.is_length));
  });
  for (std::size_t ends = 0; ends < std::size_t{1} << drawn.size(); ++ends) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      *drawn[i] = (ends >> i & 1) == 0 ? reaches[i].least : reaches[i].largest;
    }
    visit(corner);
  }
}

/// Moments of inertia by Steiner's theorem.
dynamics::Block body_of(const GivenParts& given, double gravity) {
  double mass = 0.0, moment_x = 0.0, moment_y = 0.0;
  double top = 0.0, left = 0.0, right = 0.0;
  bool stands = false;
  for (const BlockPart& part : given.parts) {
    const double width = mean_of(part.width), height = mean_of(part.height), own = mean_of(part.mass);
    const double x = mean_of(part.x), bottom = mean_of(part.bottom);
    mass += own;
    moment_x += own * x;
    moment_y += own * (bottom + 0.5 * height);
    top = std::max(top, bottom + height);
    if (bottom > 0.0) continue;
    left = stands ? std::min(left, x - 0.5 * width) : x - 0.5 * width;
    right = stands ? std::max(right, x + 0.5 * width) : x + 0.5 * width;
    stands = true;
  }
  if (given.base) {
    left = mean_of((*given.base)[0]);
    right = mean_of((*given.base)[1]);
  }
  const double centre_x = moment_x / mass, centre_y = moment_y / mass;
  double inertia = 0.0;
  for (const BlockPart& part : given.parts) {
    const double width = mean_of(part.width), height = mean_of(part.height);
    const double dx = mean_of(part.x) - centre_x, dy = mean_of(part.bottom) + 0.5 * height - centre_y;
    inertia += mean_of(part.mass) * ((width * width + height * height) / 12.0 + (dx * dx + dy * dy));
  }
  return {.width = right - left,
          .height = top,
          .gravity = gravity,
          .mass = dynamics::MassLayout{.left_edge = centre_x - left,
                                       .right_edge = right - centre_x,
                                       .centre_height = centre_y,
                                       .radius_of_gyration = std::sqrt(inertia / mass)}};
}

std::string in_metres(double number) { return base::significant(number, 6); }

std::optional<Refusal> refusal_of_parts(const GivenParts& given) {
  const auto on_floor = [](const BlockPart& part) { return mean_of(part.bottom) == 0.0; };
  if (!given.base && std::ranges::none_of(given.parts, on_floor)) {
    return Refusal{"has no part that stands on the floor", "give a part with \"bottom_m\": 0, or \"base_m\""};
  }
  if (given.base && !(mean_of((*given.base)[0]) < mean_of((*given.base)[1]))) {
    return Refusal{"has a base whose left end is not left of its right end",
                   "give \"base_m\": [left, right], each an x as in the parts"};
  }
  return std::nullopt;
}

/// Of numbers without laws.
std::optional<Refusal> refusal_of_numbers(const SceneBlock& block) {
  if (const auto* parts = std::get_if<GivenParts>(&block.mass)) {
    if (auto refusal = refusal_of_parts(*parts)) return refusal;
  }
  const dynamics::Block body = mean_of(block);
  if (std::holds_alternative<GivenSlenderness>(block.mass)) {
    const auto [shorter, longer] = std::minmax(body.width, body.height);
    if (shorter >= least_length && longer <= largest_length) return std::nullopt;
    return Refusal{"is " + in_metres(body.width) + " m wide and " + in_metres(body.height) +
                       " m high, which must lie from 1e-6 to 1e6 m",
                   "give another p; R is 3 g/(4 p^2)"};
  }
  if (!body.mass) return std::nullopt;
  const auto& [left, right, height, radius] = *body.mass;
  if (!(left >= least_length && right >= least_length)) {
    const double least = std::min(left, right);
    const std::string edge = left < right ? "left edge" : "right edge";
    return Refusal{least > 0.0
                       ? "has its centre of mass " + in_metres(least) + " m from its " + edge
                       : "has its centre of mass outside its base, " + in_metres(-least) + " m beyond the " + edge,
                   "a body at rest needs its centre of mass above its base, at least 1e-6 m from the edges"};
  }
  if (!(height >= least_length)) return Refusal{"has its centre of mass below its base", "give it a positive height"};
  if (!std::holds_alternative<GivenCentre>(block.mass)) return std::nullopt;
  if (!(height < body.height)) {
    return Refusal{"has its centre of mass above its outline",
                   "give a \"centre_height_m\" of less than \"height_m\": " + in_metres(body.height)};
  }
  // Mass within the outline: the variance of a coordinate between two ends with a given mean is at most the product of
  // its distances from them.
  const double most = std::sqrt(left * right + height * (body.height - height));
  if (radius <= most) return std::nullopt;
  return Refusal{"has a radius of gyration of " + in_metres(radius) +
                     " m; mass within its outline, with this centre, has at most " + in_metres(most) + " m",
                 "give a smaller \"radius_of_gyration_m\", or the edges in place of an outline"};
}

}  // namespace

BlockNumber part_number(std::size_t part, std::size_t k) {
  static const auto texts = [] {
    constexpr std::array<std::string_view, 5> keys{"width_m", "height_m", "mass_kg", "x_m", "bottom_m"};
    constexpr std::array<std::string_view, 5> names{"width", "height", "mass", "place", "height above the floor"};
    std::vector<std::array<std::string, 2>> made;
    for (std::size_t i = 0; i < most_parts; ++i) {
      for (std::size_t j = 0; j < keys.size(); ++j) {
        made.push_back({std::string(names[j]) + " of part " + std::to_string(i),
                        "/block/parts/" + std::to_string(i) + '/' + std::string(keys[j])});
      }
    }
    return made;
  }();
  const std::size_t place = 5 * part + k;
  const auto source = static_cast<random::Source>(static_cast<std::size_t>(random::Source::first_block_part) + place);
  return {{{texts[place][1], texts[place][0]}, source}, k < 2};
}

namespace {

/// Without a wall.
dynamics::Block free_mean_of(const SceneBlock& block) {
  dynamics::Block mean{.width = mean_of(block.width), .height = mean_of(block.height), .gravity = block.gravity};
  if (const auto* centre = std::get_if<GivenCentre>(&block.mass)) {
    const double offset = centre->offset ? mean_of(*centre->offset) : 0.0;
    const double diagonal = std::sqrt(mean.width * mean.width + mean.height * mean.height);
    mean.mass =
        dynamics::MassLayout{.left_edge = 0.5 * mean.width + offset,
                             .right_edge = 0.5 * mean.width - offset,
                             .centre_height = centre->height ? mean_of(*centre->height) : 0.5 * mean.height,
                             .radius_of_gyration = centre->radius_of_gyration ? mean_of(*centre->radius_of_gyration)
                                                                              : diagonal / std::sqrt(12.0)};
  } else if (const auto* edges = std::get_if<GivenEdges>(&block.mass)) {
    mean.mass = dynamics::MassLayout{.left_edge = mean_of(edges->edges[0]),
                                     .right_edge = mean_of(edges->edges[1]),
                                     .centre_height = mean_of(edges->centre_height),
                                     .radius_of_gyration = mean_of(edges->radius_of_gyration)};
    mean.width = mean.mass->left_edge + mean.mass->right_edge;
    mean.height = 2.0 * mean.mass->centre_height;
  } else if (const auto* parts = std::get_if<GivenParts>(&block.mass)) {
    mean = body_of(*parts, block.gravity);
  } else if (const auto* given = std::get_if<GivenSlenderness>(&block.mass)) {
    const double diagonal = 1.5 * block.gravity / (given->frequency_parameter * given->frequency_parameter);
    const auto [sine, cosine] = base::sin_cos(given->slenderness);
    mean.width = diagonal * sine;
    mean.height = diagonal * cosine;
  }
  return mean;
}

}  // namespace

dynamics::Block mean_of(const SceneBlock& block) {
  dynamics::Block mean = free_mean_of(block);
  if (block.wall) mean.open_side = *block.wall == dynamics::Side::right ? 1.0 : -1.0;
  return mean;
}

double BlockOutline::left() const { return std::ranges::min(rectangles, {}, &Rectangle::left).left; }
double BlockOutline::right() const { return std::ranges::max(rectangles, {}, &Rectangle::right).right; }
double BlockOutline::top() const { return std::ranges::max(rectangles, {}, &Rectangle::top).top; }

BlockOutline outline_of(const SceneBlock& block) {
  const dynamics::Block mean = mean_of(block);
  BlockOutline outline{.rectangles = {{.left = 0.0, .right = mean.width, .bottom = 0.0, .top = mean.height}},
                       .base = mean.width,
                       .centre_x = 0.5 * mean.width,
                       .centre_height = 0.5 * mean.height,
                       .is_given = !std::holds_alternative<GivenEdges>(block.mass),
                       .open_side = mean.open_side};
  if (!mean.mass) return outline;
  outline.base = mean.mass->left_edge + mean.mass->right_edge;
  outline.centre_x = mean.mass->left_edge;
  outline.centre_height = mean.mass->centre_height;
  const auto* given = std::get_if<GivenParts>(&block.mass);
  if (given == nullptr) return outline;
  double mass = 0.0, moment = 0.0;
  for (const BlockPart& part : given->parts) {
    mass += mean_of(part.mass);
    moment += mean_of(part.mass) * mean_of(part.x);
  }
  outline.rectangles.clear();
  for (const BlockPart& part : given->parts) {
    const double x = mean_of(part.x) - moment / mass + outline.centre_x, half = 0.5 * mean_of(part.width);
    outline.rectangles.push_back({.left = x - half,
                                  .right = x + half,
                                  .bottom = mean_of(part.bottom),
                                  .top = mean_of(part.bottom) + mean_of(part.height)});
  }
  return outline;
}

namespace {

ShapeRange free_shapes_of(const SceneBlock& block) {
  if (std::holds_alternative<UniformMass>(block.mass)) {
    const Reach width = reach_of_number(block.width, true);
    const Reach height = reach_of_number(block.height, true);
    ShapeRange range{
        .most_slender =
            dynamics::geometry_of({.width = width.least, .height = height.largest, .gravity = block.gravity}),
        .squattest = dynamics::geometry_of({.width = width.largest, .height = height.least, .gravity = block.gravity})};
    range.least_tangents = range.most_slender.tangents();
    return range;
  }
  ShapeRange range{};
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  range.least_tangents = {least, least};
  for_each_corner(block, [&](const SceneBlock& corner) {
    const dynamics::Geometry geometry = dynamics::geometry_of(mean_of(corner));
    const std::array<double, 2> tangents = geometry.tangents();
    for (std::size_t i = 0; i < tangents.size(); ++i)
      range.least_tangents[i] = std::min(range.least_tangents[i], tangents[i]);
    const auto [nearer, farther] = std::minmax(tangents[0], tangents[1]);
    if (nearer < least) range.most_slender = geometry;
    if (farther > largest) range.squattest = geometry;
    least = std::min(least, nearer);
    largest = std::max(largest, farther);
  });
  return range;
}

}  // namespace

ShapeRange shapes_of(const SceneBlock& block) {
  ShapeRange range = free_shapes_of(block);
  // The edge about which a block at a wall cannot turn holds whatever the acceleration.
  if (block.wall)
    range.least_tangents[*block.wall == dynamics::Side::left ? 0 : 1] = std::numeric_limits<double>::infinity();
  return range;
}

SizeRange sizes_of(const SceneBlock& block) {
  if (std::holds_alternative<UniformMass>(block.mass)) {
    const Reach width = reach_of_number(block.width, true);
    const Reach height = reach_of_number(block.height, true);
    return {
        .smallest = dynamics::geometry_of({.width = width.least, .height = height.least, .gravity = block.gravity}),
        .largest = dynamics::geometry_of({.width = width.largest, .height = height.largest, .gravity = block.gravity})};
  }
  SizeRange range{};
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  for_each_corner(block, [&](const SceneBlock& corner) {
    const dynamics::Geometry geometry = dynamics::geometry_of(mean_of(corner));
    if (geometry.half_diagonal < least) range.smallest = geometry;
    if (geometry.half_diagonal > largest) range.largest = geometry;
    least = std::min(least, geometry.half_diagonal);
    largest = std::max(largest, geometry.half_diagonal);
  });
  return range;
}

bool is_drawn(const SceneBlock& block) {
  bool has_law = false;
  for_each_block_number(block,
                        [&](const BlockNumber&, const Quantity& number) { has_law = has_law || is_drawn(number); });
  return has_law;
}

std::optional<Refusal> refusal_of(const SceneBlock& block) {
  if (std::holds_alternative<UniformMass>(block.mass)) return std::nullopt;
  std::optional<Refusal> refusal;
  for_each_corner(block, [&](const SceneBlock& corner) {
    if (!refusal) refusal = refusal_of_numbers(corner);
  });
  if (refusal && is_drawn(block)) refusal->reason += " (at an end of what its laws reach)";
  return refusal;
}

}  // namespace rocking

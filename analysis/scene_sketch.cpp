#include "analysis/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "analysis/figure_scripts.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

struct Point {
  double x, y;
};

/// Names of the columns of a table.
const std::vector<Column> corners{{"x", "to the right of the block's left edge [m]"}, {"y", "above the base [m]"}};

double rounded_length(double length) { return std::round(length * 1e6) / 1e6 + 0.0; }

/// A block that stands on its left edge O = (0, 0), turned anticlockwise by `tilt`.
class TiltedBlock {
 public:
  TiltedBlock(const BlockOutline& block, double tilt) : block_(block), cosine_(std::cos(tilt)), sine_(std::sin(tilt)) {}

  /// A point given by its distances along the base and the side of the block.
  [[nodiscard]] Point at(double along, double up) const {
    return {along * cosine_ - up * sine_, along * sine_ + up * cosine_};
  }
  [[nodiscard]] const BlockOutline& block() const { return block_; }
  [[nodiscard]] Point centre() const { return at(block_.centre_x, block_.centre_height); }
  [[nodiscard]] Point right_edge() const { return at(block_.base, 0.0); }
  [[nodiscard]] std::vector<Point> outline_of(const BlockOutline::Rectangle& part) const {
    return {at(part.left, part.bottom), at(part.right, part.bottom), at(part.right, part.top), at(part.left, part.top),
            at(part.left, part.bottom)};
  }

 private:
  BlockOutline block_;
  double cosine_, sine_;
};

/// Adds to the last panel of the figure.
class Sketch {
 public:
  explicit Sketch(Figure& figure) : figure_(figure) {}

  void path(const std::string& name, const std::vector<Point>& points, LayerKind kind, const Style& style) {
    Table table{.name = name, .columns = corners};
    for (const Point& point : points) table.rows.push_back({rounded_length(point.x), rounded_length(point.y)});
    add_drawn(std::move(table), {.kind = kind, .style = style}, figure_);
  }
  void arrow(const std::string& name, const Point& from, const Point& way) {
    Table table{.name = name, .columns = corners};
    table.columns.push_back({"dx", "its length to the right [m]"});
    table.columns.push_back({"dy", "upwards [m]"});
    table.rows.push_back(
        {rounded_length(from.x), rounded_length(from.y), rounded_length(way.x), rounded_length(way.y)});
    add_drawn(std::move(table), {.kind = LayerKind::arrows, .style = {.colour = "#d55e00", .width = 2.0}}, figure_);
  }
  void word(const std::string& text, const Point& where) {
    words_.rows.push_back({rounded_length(where.x), rounded_length(where.y), text});
  }
  void arc(const std::string& name, const Point& centre, double radius, double from, double to) {
    std::vector<Point> points;
    for (int i = 0; i <= 24; ++i) {
      const double angle = from + (to - from) * i / 24.0;
      points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    path(name, points, LayerKind::line, {.colour = "#0072b2", .marker = 0, .width = 1.2});
  }
  void finish() { add_drawn(std::move(words_), {.kind = LayerKind::texts}, figure_); }

 private:
  Figure& figure_;
  Table words_{.name = "words", .columns = {corners[0], corners[1], {"text", "text at this point"}}};
};

constexpr double right_angle = 1.5707963267948966;

/// Draws the ground, the base motion and the forces at the edge.
void draw_base(Sketch& sketch, double size, const BlockOutline& block) {
  const double width = block.base;
  const double left = block.left() - 0.55 * size;
  const double right = block.right() + 0.45 * size;
  sketch.path("base", {{left, 0.0}, {right, 0.0}, {right, -0.06 * size}, {left, -0.06 * size}, {left, 0.0}},
              LayerKind::polygon, {.colour = "#d0d0d0", .hatch = 4});
  sketch.path("surface", {{left, 0.0}, {right, 0.0}}, LayerKind::line, {.marker = 0, .width = 2.0});
  if (block.open_side != 0.0) {
    const double face = block.open_side > 0.0 ? block.right() : block.left(), depth = 0.06 * size * block.open_side;
    sketch.path("wall", {{face, 0.0}, {face + depth, 0.0}, {face + depth, size}, {face, size}, {face, 0.0}},
                LayerKind::polygon, {.colour = "#d0d0d0", .hatch = 4});
  }
  const double begin = std::max(0.04 * size, 0.5 * width - 0.11 * size);  // right of the normal force
  sketch.arrow("base acceleration", {begin, -0.12 * size}, {0.22 * size, 0.0});
  sketch.word("a_h(t)", {begin + 0.33 * size, -0.12 * size});
  sketch.arrow("normal force", {0.0, -0.2 * size}, {0.0, 0.2 * size});
  sketch.word("N", {-0.04 * size, -0.17 * size});
  sketch.arrow("friction force", {-0.26 * size, 0.025 * size}, {0.24 * size, 0.0});
  sketch.word("F", {-0.29 * size, 0.035 * size});
}

/// Names beside an edge: of a rectangle `R` and `ψ`, otherwise with the side.
struct EdgeNames {
  std::string radius, angle;
};

/// The lines from an edge to the centre of mass and along the side above it, and the angle between them. `away`: from the
/// direction of that side to the centre of mass, -1 of the left edge and 1 of the right one.
void draw_edge(Sketch& sketch, const TiltedBlock& block, const Point& edge, double away, double shape_angle,
               double tilt, double size, const EdgeNames& names) {
  const Point centre = block.centre();
  sketch.path("to the centre of mass, " + names.radius, {edge, centre}, LayerKind::line,
              {.colour = "#0072b2", .dash = 2, .marker = 0});
  sketch.word(names.radius,
              {edge.x + 0.82 * (centre.x - edge.x) + 0.035 * away * size, edge.y + 0.82 * (centre.y - edge.y)});
  const double side = right_angle + tilt;
  sketch.arc("shape angle " + names.angle, edge, 0.26 * size, std::min(side, side + away * shape_angle),
             std::max(side, side + away * shape_angle));
  const double place = shape_angle < 0.3 ? side - 0.14 * away : side + 0.5 * away * shape_angle;  // beside a narrow one
  sketch.word(names.angle, {edge.x + 0.3 * size * std::cos(place), edge.y + 0.3 * size * std::sin(place)});
}

void draw_angles(Sketch& sketch, const TiltedBlock& block, double size, const dynamics::Geometry& geometry,
                 double tilt) {
  const bool is_rectangle = geometry.is_rectangle();
  draw_edge(sketch, block, {0.0, 0.0}, -1.0, geometry.edges[0].shape_angle, tilt, size,
            is_rectangle ? EdgeNames{"R", "ψ"} : EdgeNames{"R_l", "ψ_l"});
  if (!is_rectangle) {
    draw_edge(sketch, block, block.right_edge(), 1.0, geometry.edges[1].shape_angle, tilt, size, {"R_r", "ψ_r"});
  }
  sketch.arc("tilt", {0.0, 0.0}, 0.5 * size, 0.0, tilt);
  sketch.word("θ", {0.54 * size * std::cos(0.5 * tilt), 0.54 * size * std::sin(0.5 * tilt)});
}

/// The parts, the base between the edges where it is not the side of a rectangle, and the centre of mass.
void draw_block(Sketch& sketch, const TiltedBlock& block) {
  std::size_t number = 0;
  for (const BlockOutline::Rectangle& part : block.block().rectangles) {
    const std::string end = ++number == 1 ? "" : ' ' + std::to_string(number);
    sketch.path("block" + end, block.outline_of(part), LayerKind::polygon, {.colour = "#dbe9f6"});
    sketch.path("outline" + end, block.outline_of(part), LayerKind::line,
                {.dash = block.block().is_given ? 1 : 2, .marker = 0, .width = 2.0});
  }
  if (!block.block().is_plain()) {
    sketch.path("base of the block", {{0.0, 0.0}, block.right_edge()}, LayerKind::line, {.marker = 0, .width = 4.0});
  }
}

std::string short_number(double number) { return significant(number, 3); }

/// Whether its width and height are given.
bool has_sides(const SceneBlock& block) {
  return std::holds_alternative<UniformMass>(block.mass) || std::holds_alternative<GivenCentre>(block.mass);
}

std::string angle_in_words(double angle) {
  return short_number(angle) + " rad = " + short_number(angle * 90.0 / right_angle) + " deg";
}

std::string edges_in_words(const dynamics::Block& block, const dynamics::Geometry& geometry) {
  const auto& [left, right, height, gyration] = *block.mass;
  return "edges " + short_number(left) + " m left and " + short_number(right) +
         " m right of the centre of mass, which is " + short_number(height) + " m high, radius of gyration " +
         short_number(gyration) + " m, ψ_l = " + angle_in_words(geometry.edges[0].shape_angle) +
         ", ψ_r = " + angle_in_words(geometry.edges[1].shape_angle);
}

std::string in_metres(const Quantity& length) {
  return (is_drawn(length) ? quantity_in_words(length) : number_text(mean_of(length))) + " m";
}

}  // namespace

std::string scene_in_words(const Report& report, const ReportedCondition& condition) {
  const Scene& scene = condition.asked.scene;
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  std::string text = has_sides(scene.block)
                         ? "B = " + in_metres(scene.block.width) + ", H = " + in_metres(scene.block.height) + ", "
                         : "";
  text +=
      block.is_rectangle() ? "ψ = " + angle_in_words(block.shape_angle) : edges_in_words(mean_of(scene.block), block);
  text +=
      ", R = " + short_number(block.half_diagonal) + " m, p = " + short_number(block.frequency_parameter) + " rad/s";
  if (condition.shaking) {
    for (const std::string_view key : {condition.shaking->given_amplitude, condition.shaking->given_frequency}) {
      text += ", " + with_greek(in_both_forms(*condition.shaking, key));
    }
  }
  const auto add = [&text](const std::string& words, const std::string& number) {
    text += ", " + words + ' ' + number;
  };
  const Json asked = applied(report.input.experiment, condition.asked.parameters);
  const Json::json_pointer strobe("/excitation/frequency_ratio"), along_the_way("/fluctuation");
  if (!condition.shaking && asked.contains(strobe)) add("Ω_h =", significant(asked.at(strobe).get<double>(), 6));
  if (const auto& friction = scene.friction) {
    add("μ_s =", quantity_in_words(friction->static_coefficient));
    if (!friction->kinetic_ratio) add("μ_k =", quantity_in_words(friction->kinetic_coefficient));
  }
  if (!asked.contains(along_the_way)) return text;
  for (const auto& [source, scatter] : asked.at(along_the_way).items()) {
    std::string name = source;
    std::ranges::replace(name, '_', ' ');
    for (const auto& [key, words] : {std::pair("sigma", "σ ="), std::pair("relative_sigma", "relative σ =")}) {
      if (scatter.contains(key)) add(name + " fluctuates with " + words, significant(scatter.at(key).get<double>(), 6));
    }
  }
  return text;
}

Figure scene_sketch(const Report& report) {
  const SceneBlock& asked = report.conditions.front().asked.scene.block;
  const dynamics::Geometry geometry = dynamics::geometry_of(mean_of(asked));
  const BlockOutline outline = outline_of(asked);
  const double width = outline.right() - outline.left();
  const double height = outline.top();
  const double size = std::max(width, height);
  const double shape_angle = geometry.edges[0].shape_angle;
  const double tilt = std::min(0.14, 0.5 * shape_angle);
  Figure figure{.name = "scene", .title = "The block, to scale, and the forces on it", .subtitle = report.title()};
  figure.panels.push_back({.to_scale = true});
  Panel& panel = figure.panels.front();
  panel.x.low = outline.left() - 0.6 * size;
  panel.x.high = outline.right() + 0.5 * size;
  panel.y.low = -0.26 * size;
  panel.y.high = 1.08 * height + width * std::sin(tilt);
  const TiltedBlock block(outline, tilt);
  Sketch sketch(figure);
  draw_base(sketch, size, outline);
  draw_block(sketch, block);
  draw_angles(sketch, block, size, geometry, tilt);
  sketch.path("centre of mass", {block.centre()}, LayerKind::points, {.size = 1.0});
  sketch.arrow("weight", block.centre(), {0.0, -0.24 * size});
  const double aside = width < 0.3 * size ? 0.5 * width + 0.11 * size : 0.05 * size;  // beside a narrow block
  const Point beside = geometry.is_rectangle() ? Point{aside, -0.16 * size} : Point{0.0, -0.28 * size};
  sketch.word("mg", {block.centre().x + beside.x, block.centre().y + beside.y});
  if (has_sides(asked)) {
    sketch.word("B", block.at(0.5 * width, height + 0.045 * size));
    sketch.word("H", block.at(width + 0.045 * size, 0.6 * height));
  }
  sketch.finish();
  const bool is_first = report.conditions.size() > 1;
  figure.caption = (is_first ? "The first of " + std::to_string(report.conditions.size()) + " conditions: " : "") +
                   scene_in_words(report, report.conditions.front()) + ". The tilt θ is drawn at " +
                   short_number(tilt / shape_angle) + (geometry.is_rectangle() ? " ψ" : " ψ_l") +
                   ". N and F act at the edge on which the block stands." +
                   (outline.is_given ? "" : " Its outline is not known: a rectangle between its edges.");
  return figure;
}

}  // namespace rocking::analysis

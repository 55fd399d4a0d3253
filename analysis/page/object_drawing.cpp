// The options of a run as blocks from the front, side by side, to one scale.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_drawn = 5;

/// A block and what the sweep changes of it; empty if nothing.
struct DrawnObject {
  BlockOutline block;
  dynamics::Geometry geometry;
  std::string name;
};

/// One for each combination of what is swept, but for the excitation.
std::vector<DrawnObject> objects_of(const Report& report) {
  std::vector<DrawnObject> objects;
  for (const ReportedCondition& condition : report.conditions) {
    std::vector<Parameter> others = condition.asked.parameters;
    std::erase_if(others, [](const Parameter& each) { return each.pointer.starts_with("/excitation"); });
    const std::string name = values_in_words(others);
    if (std::ranges::find(objects, name, &DrawnObject::name) != objects.end()) continue;
    objects.push_back({.block = outline_of(condition.asked.scene.block),
                       .geometry = dynamics::geometry_of(mean_block(condition.asked.scene)),
                       .name = name});
    if (objects.size() == most_drawn) break;
  }
  return objects;
}

/// Lengths in millimetres on the paper.
constexpr double floor_line = 47.0, beside_a_block = 17.0, below_the_floor = 9.0, name_line = 4.0;
constexpr double most_high = 38.0, letter = 1.55, height_label = 3.0;

double wide(const BlockOutline& block) { return block.right() - block.left(); }

/// Whether both edges are as far from the centre of mass.
bool is_even(const BlockOutline& block) { return block.centre_x == 0.5 * block.base; }

/// The distance of the edges, or that of each from the centre of mass.
std::string base_in_words(const BlockOutline& block) {
  const std::string distance =
      is_even(block) ? significant(block.base, 3)
                     : significant(block.centre_x, 3) + " + " + significant(block.base - block.centre_x, 3);
  return distance + " m";
}

double cell_of(const DrawnObject& object, double scale) {
  const std::size_t letters = std::max(object.name.size(), base_in_words(object.block).size() + 2);
  return std::max(1000.0 * wide(object.block) / scale + beside_a_block, letter * static_cast<double>(letters));
}

double width_of(const std::vector<DrawnObject>& objects, double scale) {
  double sum = 0.0;
  for (const DrawnObject& object : objects) sum += cell_of(object, scale);
  return sum;
}

/// The scale at which all fit, a usual one.
double scale_of(const std::vector<DrawnObject>& objects) {
  constexpr std::array scales{1.0, 2.0, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
  const double names = width_of(objects, 1e300);
  const double most_wide =
      std::max(names + 4.0 * static_cast<double>(objects.size()), objects.size() == 1 ? 53.0 : 84.0);
  double highest = 0.0, widest = 0.0;
  for (const DrawnObject& object : objects) {
    highest = std::max(highest, object.block.top());
    widest += wide(object.block);
  }
  const auto fits = [&](double scale) {
    return 1000.0 * highest <= most_high * scale && width_of(objects, scale) <= most_wide;
  };
  const auto found = std::ranges::find_if(scales, fits);
  return found != scales.end() ? *found : std::ceil(std::max(1000.0 * highest / most_high, 1000.0 * widest / 10.0));
}

/// A block with its sizes, around `middle`.
class ObjectDrawing {
 public:
  ObjectDrawing(const BlockOutline& block, double scale, double middle)
      : block_(block), scale_(scale), middle_(middle) {}

  [[nodiscard]] std::string svg() const {
    std::string parts;
    for (const auto& [left, right, bottom, top] : block_.rectangles) {
      parts += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#dddddd\" stroke=\"#000\" "
          "stroke-width=\".35\"{}/>\n",
          x(left), y(top), x(right) - x(left), y(bottom) - y(top),
          block_.is_given ? "" : " stroke-dasharray=\"1.5 .7\"");
    }
    if (!block_.is_plain()) {
      parts += fmt::format("<path d=\"M{:.2f} {} H{:.2f}\" stroke=\"#000\" stroke-width=\"1.2\"/>\n", x(0.0),
                           floor_line, x(block_.base));
    }
    return parts +
           fmt::format(
               "<path d=\"M{0:.2f} {1} L{2:.2f} {3:.2f}{4}\" fill=\"none\" stroke=\"#000\" stroke-width=\".2\" "
               "stroke-dasharray=\"1 .7\"/>\n<circle cx=\"{2:.2f}\" cy=\"{3:.2f}\" r=\".7\"/>\n",
               x(block_.base), floor_line, x(block_.centre_x), y(block_.centre_height),
               is_even(block_) ? "" : fmt::format(" L{:.2f} {}", x(0.0), floor_line)) +
           sizes();
  }

 private:
  [[nodiscard]] double x(double metres) const {
    return middle_ + 1000.0 * (metres - 0.5 * (block_.left() + block_.right())) / scale_;
  }
  [[nodiscard]] double y(double metres) const { return floor_line - 1000.0 * metres / scale_; }

  /// base_in_words(), and the height: that of the centre of mass where no other is known.
  [[nodiscard]] std::string sizes() const {
    const double left = x(0.0), right = x(block_.base), side = x(block_.left());
    const double high = block_.is_given ? block_.top() : block_.centre_height;
    const std::string middle = is_even(block_) ? "" : fmt::format(" M{:.2f} 49 V50.4", x(block_.centre_x));
    return fmt::format(
               "<path d=\"M{0:.2f} 49 V50.4 M{1:.2f} 49 V50.4{2} M{0:.2f} 49.7 H{1:.2f} M{3:.2f} {4:.2f} H{5:.2f} "
               "M{3:.2f} {6} H{5:.2f} M{7:.2f} {4:.2f} V{6}\" fill=\"none\" stroke=\"#000\" stroke-width=\".2\"/>\n",
               left, right, middle, side - 3.0, y(high), side - 1.6, floor_line, side - 2.3) +
           fmt::format(
               "<text x=\"{:.2f}\" y=\"53\" font-size=\"2.8\" text-anchor=\"middle\">{}</text>\n<text x=\"{:.2f}\" "
               "y=\"{:.2f}\" font-size=\"2.8\" text-anchor=\"end\">{} m</text>\n",
               0.5 * (left + right), base_in_words(block_), side - 3.6, 0.5 * (floor_line + y(high)) + 1.0,
               significant(high, 3));
  }

  BlockOutline block_;
  double scale_, middle_;
};

}  // namespace

std::string object_drawings(const Report& report) {
  const std::vector<DrawnObject> objects = objects_of(report);
  const double scale = scale_of(objects), width = width_of(objects, scale) + height_label;
  const double names = objects.size() > 1 ? name_line : 0.0;
  std::string drawn, label;
  double from = 0.0, highest = 0.0;
  for (const DrawnObject& object : objects) {
    const double cell = cell_of(object, scale), middle = from + 0.5 * cell + height_label;
    drawn += ObjectDrawing(object.block, scale, middle).svg();
    if (names > 0.0) {
      drawn += fmt::format("<text x=\"{:.2f}\" y=\"57\" font-size=\"2.6\" text-anchor=\"middle\">{}</text>\n", middle,
                           escaped(object.name));
    }
    label += fmt::format("{}{}{} m wide and {} m high", label.empty() ? "" : "; ",
                         names > 0.0 ? escaped(object.name) + ", " : "", significant(wide(object.block), 3),
                         significant(object.block.top(), 3));
    from += cell;
    highest = std::max(highest, 1000.0 * object.block.top() / scale);
  }
  const double top = floor_line - highest - 1.5, bottom = floor_line + below_the_floor + names;
  return fmt::format(
      "<svg class=\"objects\" width=\"{0:.1f}mm\" height=\"{1:.1f}mm\" viewBox=\"0 {2:.2f} {0:.1f} {1:.1f}\" "
      "role=\"img\" aria-label=\"{3}, to the scale 1 : {4}\">\n{5}<path d=\"M1 {6} H{7:.1f}\" stroke=\"#000\" "
      "stroke-width=\".5\"/>\n<text x=\"{7:.1f}\" y=\"{8}\" font-size=\"2.4\" text-anchor=\"end\">scale 1 : "
      "{4}</text>\n</svg>\n",
      width, bottom - top + 2.5, top, label, significant(scale, 4), drawn, floor_line, width - 1.0, bottom + 1.5);
}

std::string object_facts(const Report& report, const std::optional<double>& share_of_balance) {
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<std::string> headings{"centre of mass above the base [m]", "base", "balance at &psi; [degrees]"};
  if (share_of_balance) headings.push_back(significant(*share_of_balance, 3) + " &psi; [degrees]");
  std::string rows, head;
  for (const std::string& heading : headings) head += "<th>" + heading + "</th>";
  for (const auto& [block, geometry, name] : objects_of(report)) {
    const auto angles = [&edges = geometry.edges](double share) {
      const std::string left = significant(share * edges[0].shape_angle / degree, 3);
      const std::string right = significant(share * edges[1].shape_angle / degree, 3);
      return left == right ? left : left + " left, " + right + " right";
    };
    std::vector<std::string> cells{significant(block.centre_height, 3), base_in_words(block), angles(1.0)};
    if (share_of_balance) cells.push_back(angles(*share_of_balance));
    rows += "<tr><th>" + escaped(name) + "</th>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      rows += fmt::format("<td data-label=\"{}\">{}</td>", headings[i], cells[i]);
    }
    rows += "</tr>\n";
  }
  return fmt::format("<table><thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}</tbody></table>\n", head, rows);
}

}  // namespace rocking::analysis

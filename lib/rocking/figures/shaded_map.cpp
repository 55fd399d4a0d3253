#include "rocking/figures/shaded_map.hpp"

#include <algorithm>
#include <array>

namespace rocking::analysis {
namespace {

constexpr std::array<const char*, 7> shades{"#08306b", "#08519c", "#2171b5", "#4292c6",
                                            "#6baed6", "#9ecae1", "#c6dbef"};

/// The number of classes: none.
std::size_t class_of(double number, std::span<const ShadeClass> classes) {
  const auto found = std::ranges::find_if(classes, [&](const ShadeClass& each) { return number >= each.least; });
  return static_cast<std::size_t>(found - classes.begin());
}

Table boxes_of(const ShadedMap& map, const Shading& shading, std::size_t wanted) {
  Table table{.name = {}, .columns = shading.columns};
  for (std::size_t row = 0; row < map.numbers.size(); ++row) {
    const auto& numbers = map.numbers[row];
    for (std::size_t from = 0; from < numbers.size();) {
      const std::size_t found = class_of(numbers[from], shading.classes);
      std::size_t to = from;
      while (to < numbers.size() && class_of(numbers[to], shading.classes) == found) ++to;
      if (found == wanted) {
        table.rows.push_back({map.x_edges[from], map.x_edges[to], map.y_edges[row], map.y_edges[row + 1]});
      }
      from = to;
    }
  }
  return table;
}

}  // namespace

void add_shades(const ShadedMap& map, const Shading& shading, const std::string& name, Figure& figure) {
  for (std::size_t i = 0; i < shading.classes.size(); ++i) {
    const std::string words = shading.classes[i].words;
    Table table = boxes_of(map, shading, i);
    table.name = name + ", " + words;
    add_drawn(std::move(table),
              {.kind = LayerKind::boxes, .style = {.colour = shades.at(i)}, .legend = shading.quantity + ' ' + words},
              figure);
  }
}

}  // namespace rocking::analysis

#pragma once

#include <span>
#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// Numbers over the cells of a rectangle. Where there is none it is NaN.
struct ShadedMap {
  std::vector<double> x_edges, y_edges;      ///< of the cells, increasing
  std::vector<std::vector<double>> numbers;  ///< by row
};

/// Numbers from `least` on, up to the class before.
struct ShadeClass {
  double least;
  const char* words;
};

/// What the numbers are, and their classes: at most seven, from the darkest on. Smaller numbers are not drawn.
struct Shading {
  std::string quantity;         ///< begins the entries of the legend
  std::vector<Column> columns;  ///< x_low, x_high, y_low, y_high of a box
  std::span<const ShadeClass> classes;
};

/// Adds the cells of each class to the last panel as boxes, neighbours in a row as one. Each class is a table; its name
/// begins with `name`.
void add_shades(const ShadedMap& map, const Shading& shading, const std::string& name, Figure& figure);

}  // namespace rocking::analysis

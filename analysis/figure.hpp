#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a figure is, whoever draws it: tables of numbers, and what of them is shown how. A page and a gnuplot script are
/// made from the same figure.
namespace rocking::analysis {

/// Nothing, a number, or a text.
using Cell = std::variant<std::monostate, double, std::string>;

struct Column {
  std::string name;     ///< one word, as in the data file
  std::string meaning;  ///< in words, with symbol and unit
};

/// Rows of equal length. Of a matrix the columns are nameless points of a grid; `grid` says where they lie.
struct Table {
  struct Grid {
    double x = 0.0, dx = 1.0;  ///< of the first column's middle; from one column to the next
    double y = 0.0, dy = 1.0;  ///< the same of rows
  };
  std::string name;  ///< what of the figure this is, in words
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::optional<Grid> grid = std::nullopt;
  bool only_drawn = false;  ///< says nothing that the tables before it do not: not worth a reader's time
};

struct Tick {
  double place;
  std::string text;
};

struct Axis {
  std::string quantity;  ///< `base amplitude`
  std::string symbol;    ///< `A_h`: what stands behind a `_` is set low; may be empty
  std::string unit;      ///< `periods`; empty: a pure number
  std::optional<double> low = std::nullopt, high = std::nullopt;  ///< absent: what the data need
  std::vector<Tick> ticks = {};                                   ///< empty: round numbers
  bool logarithmic = false;
};

/// `base amplitude A_h [-]` without marks of setting.
[[nodiscard]] std::string label_of(const Axis& axis);

/// How a layer looks; each tells apart without colour too.
struct Style {
  std::string colour = "#000000";
  int dash = 1;    ///< gnuplot's dash types: 1 is solid
  int marker = 7;  ///< gnuplot's point types: 7 is a disc
  int hatch = 0;   ///< gnuplot's fill patterns: 0 is none
  double width = 1.5;
  double opacity = 1.0;  ///< of what is filled
  double size = 0.6;     ///< of markers
};

/// How a layer is drawn, and what its columns are.
enum class LayerKind : std::uint8_t {
  boxes,       ///< x_low, x_high, y_low, y_high
  line,        ///< x, y
  ribbon,      ///< x, low, high
  points,      ///< x, y
  error_bars,  ///< x, y, low, high
  steps,       ///< x, y: level from each x to the next
  image,       ///< none: all cells of a matrix; 0 is left blank, the rest is shaded by its logarithm
  spans,       ///< x_low, x_high: over the whole height
  arrows,      ///< x, y, dx, dy
  polygon,     ///< x, y of its corners
  texts,       ///< x, y, text
};

struct Layer {
  LayerKind kind;
  std::size_t table = 0;             ///< of the figure
  std::vector<std::size_t> columns;  ///< of the table, counted from 0
  Style style = {};
  std::string legend = {};  ///< empty: not in the legend
};

/// One pair of axes.
struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Layer> layers;
  double height = 1.0;    ///< beside that of the panels above and below
  bool to_scale = false;  ///< both axes in one scale, and not drawn
};

/// How panels stand together.
enum class Arrangement : std::uint8_t { grid, stacked };

struct Figure {
  std::string name;         ///< stem of its files
  std::string title;        ///< what it shows
  std::string subtitle;     ///< of what: the experiment's title, the condition
  std::string caption;      ///< how to read it
  std::string description;  ///< what is to be seen, for who cannot
  std::vector<Table> tables;
  std::vector<Panel> panels;
  Arrangement arrangement = Arrangement::grid;
};

}  // namespace rocking::analysis

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// A figure, independent of the program that draws it: tables of numbers, and how they are shown. Pages and gnuplot
/// scripts are made from the same figure.
namespace rocking::analysis {

/// Nothing, a number, or a text.
struct Cell : std::variant<std::monostate, double, std::string> {
  using variant::variant;
  Cell() = default;
  Cell(std::integral auto number) : variant(static_cast<double>(number)) {}
  Cell(const std::optional<double>& number) {
    if (number) *this = *number;
  }
};
using Row = std::vector<Cell>;

struct Column {
  std::string name;           ///< one word, as in the data file
  std::string meaning;        ///< in words, with symbol and unit
  std::string interval = {};  ///< what the next two columns are the ends of, `95 % interval`; empty: of nothing
  bool is_verbatim = false;   ///< whether `meaning` is a name, in which `_` begins no subscript
};

/// Rows of equal length. A matrix has unnamed columns, which are points of a grid; `grid` gives their positions.
struct Table {
  struct Grid {
    double x = 0.0, dx = 1.0;  ///< centre of the first column; distance between columns
    double y = 0.0, dy = 1.0;  ///< the same for rows
  };
  std::string name = {};  ///< which part of the figure it is, in words
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
  std::optional<Grid> grid = std::nullopt;
  bool only_drawn = false;  ///< its numbers stand elsewhere; not shown to readers
};

struct Tick {
  double place;
  std::string text;
};

struct Axis {
  std::string quantity = {};                                      ///< `base amplitude`
  std::string symbol = {};                                        ///< `A_h`, where a `_` begins a subscript
  std::string unit = {};                                          ///< `periods`; empty: dimensionless
  std::optional<double> low = std::nullopt, high = std::nullopt;  ///< absent: given by the data
  std::vector<Tick> ticks = {};                                   ///< empty: round numbers
  bool logarithmic = false;
};

/// Plain text of a label, without markup: `base amplitude A_h [-]`.
[[nodiscard]] std::string label_of(const Axis& axis);

/// Style of a layer. Styles can also be distinguished without colour.
struct Style {
  std::string colour = "#000000";
  int dash = 1;    ///< gnuplot's dash types: 1 is solid
  int marker = 7;  ///< gnuplot's point types: 7 is a disc
  int hatch = 0;   ///< gnuplot's fill patterns: 0 is none
  double width = 1.5;
  double opacity = 1.0;  ///< of filled areas
  double size = 0.6;     ///< of markers
};

/// How a layer is drawn, and the meaning of its columns.
enum class LayerKind : std::uint8_t {
  boxes,       ///< x_low, x_high, y_low, y_high
  line,        ///< x, y
  ribbon,      ///< x, low, high
  points,      ///< x, y
  error_bars,  ///< x, y, low, high
  steps,       ///< x, y: level from each x to the next
  image,       ///< no columns: all cells of a matrix; 0 is blank, others are shaded by their logarithm
  spans,       ///< x_low, x_high: over the full height
  arrows,      ///< x, y, dx, dy
  polygon,     ///< x, y of its corners
  texts,       ///< x, y, text
};

struct Layer {
  LayerKind kind;
  std::size_t table = 0;                  ///< of the figure
  std::vector<std::size_t> columns = {};  ///< their places in the table; draw() takes their names
  Style style = {};
  std::string legend = {};  ///< empty: no entry in the legend
};

/// One pair of axes.
struct Panel {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Layer> layers = {};
  double height = 1.0;    ///< relative to the panels above and below
  bool to_scale = false;  ///< both axes have the same scale and are not drawn
  double strip = 0.0;     ///< height of the stacks of boxes, of which one stands above each whole number; 0: no stacks
};

/// Arrangement of the panels.
enum class Arrangement : std::uint8_t { grid, stacked };

struct Figure {
  std::string name = {};         ///< stem of its files
  std::string title = {};        ///< what the figure shows
  std::string subtitle = {};     ///< the experiment's title, the condition
  std::string caption = {};      ///< how to read it
  std::string description = {};  ///< text for readers who cannot see the figure
  std::vector<Table> tables = {};
  std::vector<Panel> panels = {};
  Arrangement arrangement = Arrangement::grid;
};

/// The first columns, as many as this kind of layer has.
[[nodiscard]] std::vector<std::size_t> first_columns(LayerKind kind);

/// The places of the columns with these names.
[[nodiscard]] std::vector<std::size_t> places_of(const Table& table, const std::vector<std::string>& names);

/// Adds a layer of its table to the last panel, or to that at this place. `columns`: their names, in the order of the kind;
/// empty: the first ones.
void draw(Layer layer, const std::vector<std::string>& columns, Figure& figure,
          std::optional<std::size_t> panel = std::nullopt);

/// Adds a table and a layer of it to the last panel.
void draw(Table table, Layer layer, const std::vector<std::string>& columns, Figure& figure);

/// Adds a table of x and y, unless it has no rows, and a layer of it to each panel.
void add_layer(Table table, LayerKind kind, const Style& style, const std::string& legend, Figure& figure);

/// Adds a table that is only drawn, unless it has no rows, and this layer of it to the last panel; of its first columns,
/// if the layer names none.
void add_drawn(Table table, Layer layer, Figure& figure);

/// Adds the column of an estimate, and NAME_low and NAME_high of its interval. `unit`: what ends their meanings.
void add_estimate(Table& table, const Column& estimate, const std::string& unit = {});

/// These columns alone, as a table that is only drawn; its name begins with `what`.
[[nodiscard]] Table drawn_part(const Table& whole, const std::string& what, const std::vector<std::string>& columns);

/// The shortest decimal text of a number that reads back to the same bits.
[[nodiscard]] std::string number_text(double number);

/// A cell as text for data files and tables: an empty cell is `NaN`, text is unchanged.
[[nodiscard]] std::string cell_text(const Cell& cell);

}  // namespace rocking::analysis

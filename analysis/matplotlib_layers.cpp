#include "analysis/figure_scripts.hpp"

#include <array>
#include <cstddef>

#include "analysis/gnuplot_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// matplotlib's words for gnuplot's numbers of markers, dashes and hatches from 1 on.
constexpr std::array markers_of_matplotlib{"+", "x", "*", "s", "s", "o", "o", "^", "^", "v", "v", "D", "D", "p", "p"};
constexpr std::array dashes_of_matplotlib{"-", "--", ":", "-.", "--"};
constexpr std::array hatches_of_matplotlib{"xx", "xxx", "..", "////", "//", "\\\\\\\\", "\\\\"};

template <std::size_t N>
std::string word_of(const std::array<const char*, N>& words, int number) {
  return words.at(static_cast<std::size_t>(number - 1) % N);
}

/// `columns(TABLE, ...)`: the columns of the layer as arrays.
std::string columns_of(const Layer& layer) {
  std::string text = "*columns(" + std::to_string(layer.table);
  for (const std::size_t column : layer.columns) text += ", " + std::to_string(column);
  return text + ')';
}

std::string stroke_in_python(const Style& style) {
  return ", color=\"" + style.colour + "\", ls=\"" + word_of(dashes_of_matplotlib, style.dash) +
         "\", lw=" + significant(0.75 * style.width, 3);
}

std::string area_in_python(const Style& style) {
  std::string text = ", fc=\"" + style.colour + "\", lw=0";
  if (style.opacity < 1.0) text += ", alpha=" + number_text(style.opacity);
  if (style.hatch != 0) text += ", ec=\"#606060\", hatch=" + python_quoted(word_of(hatches_of_matplotlib, style.hatch));
  return text;
}

std::string marks_in_python(const Style& style) {
  const bool is_open = style.marker > 3 && style.marker % 2 == 0;
  return ", marker=\"" + word_of(markers_of_matplotlib, style.marker) + "\", ms=" + significant(6.0 * style.size, 3) +
         (is_open ? ", mfc=\"none\"" : "");
}

std::string image_in_python(const Layer& layer, const Figure& figure) {
  const Table& table = figure.tables.at(layer.table);
  const Table::Grid& grid = table.grid.value();
  const auto edges = [](double first, double step, std::size_t count) {
    return number_text(first - 0.5 * step) + ", " + number_text(first + (static_cast<double>(count) - 0.5) * step);
  };
  return "ax.imshow(np.ma.log10(np.ma.masked_equal(tables[" + std::to_string(layer.table) +
         "].astype(float), 0)), interpolation=\"none\", origin=\"lower\", aspect=\"auto\", cmap=\"Greys\", vmin=-1, "
         "extent=(" +
         edges(grid.x, grid.dx, table.rows.front().size()) + ", " + edges(grid.y, grid.dy, table.rows.size()) + ")";
}

std::string texts_in_python(const Layer& layer) {
  const std::string table = std::to_string(layer.table);
  return "for x, y, words in zip(" +
         columns_of({.kind = layer.kind, .table = layer.table, .columns = {layer.columns.at(0), layer.columns.at(1)}}) +
         ", tables[" + table + "][:, " + std::to_string(layer.columns.at(2)) +
         "]): ax.text(x, y, words.strip('\"'), ha=\"center\", va=\"center\", parse_math=False, color=\"" +
         layer.style.colour + '"';
}

std::string opened_call(const Figure& figure, const Layer& layer) {
  const Style& style = layer.style;
  switch (layer.kind) {
    case LayerKind::boxes: return "boxes(ax, " + columns_of(layer) + area_in_python(style);
    case LayerKind::spans:
      return "boxes(ax, " + columns_of(layer) + ", 0, 1, transform=ax.get_xaxis_transform()" + area_in_python(style);
    case LayerKind::ribbon: return "ax.fill_between(" + columns_of(layer) + area_in_python(style);
    case LayerKind::polygon: return "ax.fill(" + columns_of(layer) + area_in_python(style);
    case LayerKind::line:
      return "ax.plot(" + columns_of(layer) + stroke_in_python(style) +
             (style.marker == 0 ? "" : marks_in_python(style));
    case LayerKind::steps: return "ax.step(" + columns_of(layer) + ", where=\"post\"" + stroke_in_python(style);
    case LayerKind::points:
      return "ax.plot(" + columns_of(layer) + ", ls=\"\", color=\"" + style.colour + '"' + marks_in_python(style);
    case LayerKind::error_bars:
      return "bars(ax, " + columns_of(layer) + ", ls=\"\", color=\"" + style.colour + '"' + marks_in_python(style);
    case LayerKind::arrows:
      return "ax.quiver(" + columns_of(layer) + ", angles=\"xy\", scale_units=\"xy\", scale=1, color=\"" +
             style.colour + '"';
    case LayerKind::texts: return texts_in_python(layer);
    case LayerKind::image: return image_in_python(layer, figure);
  }
  return "";
}

}  // namespace

std::string without_formulas(std::string_view text) {
  std::string shown;
  for (const char c : printable(text)) shown += c == '$' ? "\\$" : std::string(1, c);
  return shown;
}

std::string python_quoted(const std::string& text) { return Json(text).dump(); }

std::string matplotlib_call(const Figure& figure, const Layer& layer, const std::string& label) {
  // matplotlib shows no entry whose text begins with `_`.
  const std::string shown = (label.starts_with('_') ? "\xE2\x80\x8B" : "") + label;
  return opened_call(figure, layer) + (label.empty() ? "" : ", label=" + python_quoted(without_formulas(shown))) + ')';
}

}  // namespace rocking::analysis

#include "analysis/figure_scripts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "analysis/gnuplot_axes.hpp"
#include "analysis/gnuplot_text.hpp"
#include "analysis/layout.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr double pixels_of_an_inch = 96.0;

/// Texts below each other as one Python string.
std::string python_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    if (!line.empty()) text += (text.empty() ? "" : "\n") + without_formulas(line);
  }
  return python_quoted(text);
}

/// The character behind a `_` as a subscript.
std::string with_subscripts(const std::string& symbol) {
  std::string text;
  for (std::size_t i = 0; i < symbol.size(); ++i) {
    const bool is_mark = symbol[i] == '_' && i + 1 < symbol.size();
    text += is_mark ? std::string("$_") + symbol[i + 1] + '$' : std::string(1, symbol[i]);
    if (is_mark) ++i;
  }
  return text;
}

std::string label_in_python(const Axis& axis) {
  return python_quoted(label_of({.quantity = without_formulas(axis.quantity),
                                 .symbol = with_subscripts(axis.symbol),
                                 .unit = without_formulas(axis.unit)}));
}

std::string ticks_in_python(const Axis& axis, char letter) {
  if (axis.ticks.empty()) return "";
  std::string places;
  std::string words;
  for (const Tick& tick : axis.ticks) {
    const bool is_power = axis.logarithmic && tick.text.starts_with("10^{");
    places += (places.empty() ? "" : ", ") + number_text(tick.place);
    words +=
        (words.empty() ? "" : ", ") + python_quoted(is_power ? '$' + tick.text + '$' : without_formulas(tick.text));
  }
  return std::string("ax.set_") + letter + "ticks([" + places + "], [" + words + "])\nax." + letter +
         "axis.set_minor_locator(plt.NullLocator())\n";
}

/// `xlabel=..., xscale=..., xlim=...`
std::string settings_of(const Axis& axis, char letter) {
  const auto end = [](const std::optional<double>& value) { return value ? number_text(*value) : std::string("None"); };
  const std::string name = std::string(", ") + letter;
  std::string text = name + "label=" + label_in_python(axis);
  if (axis.logarithmic) text += name + "scale=\"log\"";
  if (axis.low || axis.high) text += name + "lim=(" + end(axis.low) + ", " + end(axis.high) + ')';
  return text;
}

/// The calls that draw one panel on `ax`. An entry of the legend is given to the first layer that has it.
std::string panel_in_python(const Figure& figure, const Panel& original, const Place& place,
                            std::set<std::string>& entries) {
  const Panel panel = with_settled_axes(figure, original, place);
  std::string text;
  for (const Layer& layer : panel.layers) {
    if (figure.tables.at(layer.table).rows.empty()) continue;
    const bool is_new = !layer.legend.empty() && entries.insert(layer.legend).second;
    text += matplotlib_call(figure, layer, is_new ? layer.legend : "") + '\n';
  }
  const auto letters = static_cast<std::size_t>((place.right - place.left) / screen_look().letter_width);
  text += "ax.set(title=" + python_lines(wrapped(printable(panel.title), letters));
  text += settings_of(panel.x, 'x') + settings_of(panel.y, 'y') + ")\n";
  text += ticks_in_python(panel.x, 'x') + ticks_in_python(panel.y, 'y');
  return text + (panel.to_scale ? "ax.axis(\"off\")\nax.set_aspect(\"equal\")\n" : "");
}

/// The numbers of panels beside and below each other, and the size.
std::string subplots_of(const Figure& figure, const Layout& layout) {
  const double top = layout.panels.front().top;
  const auto columns = std::ranges::count_if(layout.panels, [top](const Place& place) { return place.top == top; });
  const auto rows = (static_cast<std::ptrdiff_t>(figure.panels.size()) + columns - 1) / columns;
  std::string heights;
  for (std::size_t i = 0; i < figure.panels.size(); i += static_cast<std::size_t>(columns)) {
    heights += (heights.empty() ? "" : ", ") + number_text(figure.panels[i].height);
  }
  std::string text = "figure, axes = plt.subplots(" + std::to_string(rows) + ", " + std::to_string(columns) +
                     ", figsize=(" + fixed_point(layout.width / pixels_of_an_inch, 2) + ", " +
                     fixed_point(layout.height / pixels_of_an_inch, 2) + "), layout=\"constrained\", squeeze=False";
  if (rows > 1) text += ", gridspec_kw={\"height_ratios\": [" + heights + "]}";
  text += ")\n";
  if (rows * columns == std::ssize(figure.panels)) return text;
  return text + "for ax in axes.flat[" + std::to_string(figure.panels.size()) + ":]: ax.axis(\"off\")\n";
}

/// Below the panels, in as many columns as fit.
std::string legend_in_python(const std::set<std::string>& entries, const FigureLook& look) {
  if (entries.empty()) return "";
  std::size_t letters = 0;
  for (const std::string& entry : entries) letters = std::max(letters, letters_in(entry));
  const double width = look.sample_width + 20.0 + look.letter_width * static_cast<double>(letters);
  return "figure.legend(loc=\"upper center\", bbox_to_anchor=(0.5, 0), ncol=" +
         std::to_string(std::max(1, static_cast<int>(look.width / width))) + ")\n";
}

bool has_layer(const Figure& figure, LayerKind kind) {
  return std::ranges::any_of(figure.panels, [kind](const Panel& panel) {
    return std::ranges::any_of(panel.layers, [kind](const Layer& layer) { return layer.kind == kind; });
  });
}

/// Reads the tables, and defines what the layers need.
std::string preparation_of(const Figure& figure, const FigureLook& look) {
  const std::string name = figure.name;
  std::string text =
      "# Draws " + name + " from " + name + ".tsv with matplotlib: python3 " + name + ".py writes " + name +
      "-matplotlib.pdf\nimport matplotlib.pyplot as plt\nimport numpy as np\n\n"
      "with open(" +
      python_quoted(name + ".tsv") +
      ", encoding=\"utf-8\") as file:\n"
      "    tables = [np.array([line.split(\"\\t\") for line in table.splitlines() if line[:1] != \"#\"])\n"
      "              for table in file.read().split(\"\\n\\n\\n\")]\n"
      "def columns(table, *places): return tables[table][:, places].T.astype(float)\n";
  if (has_layer(figure, LayerKind::boxes) || has_layer(figure, LayerKind::spans)) {
    text +=
        "def boxes(ax, left, right, low, high, **style):\n"
        "    ax.bar(left, high - low, right - left, low, align=\"edge\", **style)\n";
  }
  if (has_layer(figure, LayerKind::error_bars)) {
    text += "def bars(ax, x, y, low, high, **style): ax.errorbar(x, y, (abs(y - low), abs(high - y)), **style)\n";
  }
  return text + "\nplt.rcParams[\"font.size\"] = " + number_text(look.font_size) + '\n';
}

}  // namespace

std::string matplotlib_text(const Figure& original, const FigureLook& look) {
  const Figure figure = adapted(original, look);
  const Layout layout = layout_of(figure, look);
  std::string text = preparation_of(figure, look) + subplots_of(figure, layout);
  std::set<std::string> entries;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    text += "ax = axes.flat[" + std::to_string(i) + "]\n";
    text += panel_in_python(figure, figure.panels[i], layout.panels[i], entries);
  }
  if (!figure.title.empty() || !figure.subtitle.empty()) {
    text += "figure.suptitle(" + python_lines({figure.title, figure.subtitle}) + ", fontsize=\"medium\")\n";
  }
  text += legend_in_python(entries, look);
  return text + "figure.savefig(" + python_quoted(figure.name + "-matplotlib.pdf") + ", bbox_inches=\"tight\")\n";
}

}  // namespace rocking::analysis

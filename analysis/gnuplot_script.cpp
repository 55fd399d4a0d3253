#include "analysis/figure_scripts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/gnuplot_axes.hpp"
#include "analysis/gnuplot_text.hpp"
#include "analysis/layout.hpp"
#include "rocking/look/text_table.hpp"

namespace rocking::analysis {
namespace {

/// A position on the page in gnuplot's coordinates.
std::string at(const Layout& layout, double x, double y) {
  const auto rounded = [](double share) { return number_text(std::round(share * 1e5) / 1e5); };
  return "screen " + rounded(x / layout.width) + ", screen " + rounded(y / layout.height);
}

constexpr double pixels_of_a_point = 96.0 / 72.0;

// gnuplot halves fonts and lines in a PDF. With these factors a font has its size in points, and a line of width 1 is a
// pixel wide, 0.75 points, as in the other formats.
constexpr const char* pdf_scales = " fontscale 0.75 linewidth 1.5";

/// A number with two decimals.
std::string rounded(double number) { return number_text(std::round(number * 100.0) / 100.0); }

std::string size_of(const Layout& layout, double scale) {
  return rounded(scale * layout.width) + ',' + rounded(scale * layout.height);
}

/// The name of a figure in the scripts of an SVG, where gnuplot allows letters, digits and _ only.
std::string script_name(const Figure& figure) {
  const auto is_refused = [](char c) {
    return !(('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_');
  };
  std::string name = figure.name;
  std::ranges::replace_if(name, is_refused, '_');
  return name;
}

// Fonts and sizes are given explicitly and no date or machine name is used, so that equal data give equal bytes.
std::string terminals(const Figure& figure, const Layout& layout, const FigureLook& look) {
  const std::string stem = gnuplot_quoted(figure.name);
  const auto font = [](double size) { return " font 'DejaVu Sans," + rounded(size) + "'"; };
  const std::string enlarged = rounded(look.png_pixels);
  return "  if (format eq 'svg') {\n    set terminal svg enhanced size " + size_of(layout, 1.0) +
         font(look.font_size * pixels_of_a_point) + " background '#ffffff' name " +
         gnuplot_quoted(script_name(figure)) +
         "\n  }\n  if (format eq 'png') {\n    set terminal pngcairo enhanced size " +
         size_of(layout, look.png_pixels) + font(look.font_size) + " fontscale " + enlarged + " linewidth " + enlarged +
         " pointscale " + enlarged +
         " background '#ffffff'\n  }\n  if (format eq 'pdf') {\n    set terminal pdfcairo enhanced size " +
         size_of(layout, look.pdf_inches) + font(look.font_size) + pdf_scales +
         " background '#ffffff'\n  }\n  set output " + stem + ".'.'.format.ending\n";
}

std::string rectangle(const Layout& layout, const FigureLook& look, const LegendEntry& entry) {
  const std::string place = "  set object rectangle from " + at(layout, entry.left, entry.middle - 6.0) + " to " +
                            at(layout, entry.left + look.sample_width, entry.middle + 6.0) + " front noclip ";
  std::string text = place + fill_of(entry.style) + '\n';
  if (entry.style.hatch != 0) text += place + hatch_over(entry.style) + '\n';
  return text + place + "fs empty border lc rgb '#606060' lw 0.67\n";
}

std::string stroke(const Layout& layout, const FigureLook& look, const LegendEntry& entry) {
  return "  set arrow from " + at(layout, entry.left, entry.middle) + " to " +
         at(layout, entry.left + look.sample_width, entry.middle) + " nohead front " + stroke_of(entry.style) + '\n';
}

std::string marker(const Layout& layout, const FigureLook& look, const LegendEntry& entry) {
  return "  set label '' at " + at(layout, entry.left + 0.5 * look.sample_width, entry.middle) + " point pt " +
         std::to_string(entry.style.marker) + " ps " + number_text(std::max(entry.style.size, 0.6)) + " lc rgb '" +
         entry.style.colour + "' lw " + number_text(entry.style.width) + " front\n";
}

std::string sample(const Layout& layout, const FigureLook& look, const LegendEntry& entry) {
  switch (entry.kind) {
    case LayerKind::boxes:
    case LayerKind::ribbon:
    case LayerKind::spans:
    case LayerKind::image:
    case LayerKind::polygon: return rectangle(layout, look, entry);
    case LayerKind::line:
      return stroke(layout, look, entry) + (entry.style.marker == 0 ? "" : marker(layout, look, entry));
    case LayerKind::steps:
    case LayerKind::arrows: return stroke(layout, look, entry);
    case LayerKind::points:
    case LayerKind::error_bars: return marker(layout, look, entry);
    case LayerKind::texts: return "";
  }
  return "";
}

/// One string of gnuplot with a line for each text.
std::string quoted_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : ".\"\\n\".") + gnuplot_quoted(line);
  return text;
}

std::string heading(const Figure& figure, const Layout& layout, const FigureLook& look) {
  std::string text;
  if (look.style == FigureStyle::screen) {
    text += "  set label " + gnuplot_quoted(cut(printable(figure.title), letters_across)) + " at " +
            at(layout, 0.5 * layout.width, layout.title) + " center noenhanced font ',13' front\n";
  }
  if (!figure.subtitle.empty()) {
    text += "  set label " + gnuplot_quoted(cut(printable(figure.subtitle), letters_across)) + " at " +
            at(layout, 0.5 * layout.width, layout.subtitle) + " center noenhanced textcolor rgb '#404040' front\n";
  }
  for (const LegendEntry& entry : layout.legend) {
    text += sample(layout, look, entry);
    text += "  set label " + quoted_lines(entry.lines) + " at " +
            at(layout, entry.left + look.sample_width + 7.0, entry.middle) + " noenhanced front\n";
  }
  return text;
}

std::string margins(const Layout& layout, const Place& place) {
  const auto share = [](double part, double whole) { return number_text(std::round(part / whole * 1e5) / 1e5); };
  return "  set lmargin at screen " + share(place.left, layout.width) + "\n  set rmargin at screen " +
         share(place.right, layout.width) + "\n  set bmargin at screen " + share(place.bottom, layout.height) +
         "\n  set tmargin at screen " + share(place.top, layout.height) + '\n';
}

/// gnuplot refuses to plot nothing: a plot of NaN draws the axes alone.
std::string plot_text(const Figure& figure, const Panel& panel) {
  std::string elements;
  for (const Layer& layer : panel.layers) {
    for (const std::string& element : plot_elements(figure, layer)) {
      elements += (elements.empty() ? "" : ", \\\n    ") + element + " notitle";
    }
  }
  return "  plot " + (elements.empty() ? "NaN notitle" : elements) + '\n';
}

/// The quantity of an axis, cut so that its label has at most so many characters.
std::string fitting(const Axis& axis, std::size_t letters) {
  const std::size_t others = letters_in(label_of(axis)) - letters_in(axis.quantity);
  return letters_in(label_of(axis)) <= letters ? axis.quantity
                                               : cut(axis.quantity, std::max(others + 4, letters) - others);
}

std::string panel_text(const Figure& figure, const Layout& layout, const FigureLook& look, std::size_t number) {
  const Place& place = layout.panels[number];
  const LettersOfPanel letters = letters_of(place, look);
  Panel panel = with_settled_axes(figure, figure.panels[number], place);
  if (look.style == FigureStyle::journal) {
    panel.x.quantity = fitting(panel.x, letters.x);
    panel.y.quantity = fitting(panel.y, letters.y);
  }
  const bool with_x = figure.arrangement == Arrangement::grid || number + 1 == figure.panels.size();
  std::string text = margins(layout, place) + axes_text(panel, with_x) + "  set title " +
                     quoted_lines(title_lines(panel, place, look)) + " noenhanced offset 0,-0.6\n";
  if (shows_nothing(figure, panel)) {
    text += "  set label 'nothing to show' at graph 0.5, graph 0.5 center noenhanced textcolor rgb '#404040' front\n";
  }
  return text + plot_text(figure, panel) + "  unset label\n  unset object\n  unset arrow\n";
}

/// The logarithm of the largest number of an image; 1 if there is none.
double top_shade(const Figure& figure) {
  double most = 10.0;
  for (const Table& table : figure.tables) {
    if (!table.grid) continue;
    for (const auto& row : table.rows) {
      for (const Cell& cell : row) most = std::max(most, std::get<double>(cell));
    }
  }
  return std::log10(most);
}

}  // namespace

std::string script_text(const Figure& original, const FigureLook& look) {
  const Figure figure = adapted(original, look);
  const Layout layout = layout_of(figure, look);
  std::string text = "# Draws " + figure.name + " from " + figure.name +
                     ".tsv, with gnuplot 5.4 or later:\n#   gnuplot " + figure.name +
                     ".gp\n#   gnuplot -e \"formats='svg'\" " + figure.name + ".gp\n" +
                     "if (!exists(\"formats\")) formats = 'svg png pdf'\nif (!exists(\"ending\")) ending = ''\nset "
                     "encoding utf8\ndata = " +
                     gnuplot_quoted(figure.name + ".tsv") +
                     "\nset datafile separator tab\nset key off\nset minussign\n"
                     "set offsets graph 0.02, graph 0.02, graph 0.05, graph 0.05\nset y2range [0:1]\n"
                     "unset colorbox\nset palette defined (0 '#b0b0b0', 1 '#000000')\nset cbrange [0:" +
                     number_text(std::round(top_shade(figure) * 1e4) / 1e4) + "]\ndo for [format in formats] {\n";
  text += terminals(figure, layout, look) + "  set multiplot\n" + heading(figure, layout, look);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) text += panel_text(figure, layout, look, i);
  return text + "  unset multiplot\n  set output\n}\n";
}

}  // namespace rocking::analysis

#include "analysis/gnuplot_layers.hpp"

#include "analysis/data_file.hpp"

namespace rocking::analysis {
namespace {

std::string column(const Layer& layer, std::size_t which) { return std::to_string(layer.columns.at(which) + 1); }

std::string dollar(const Layer& layer, std::size_t which) { return '$' + column(layer, which); }

/// `using a:b:...` of the layer's columns as they are.
std::string as_they_are(const Layer& layer) {
  std::string text = "using ";
  for (std::size_t i = 0; i < layer.columns.size(); ++i) text += (i == 0 ? "" : ":") + column(layer, i);
  return text;
}

std::string middle(const Layer& layer, std::size_t low) {
  return "(0.5*(" + dollar(layer, low) + '+' + dollar(layer, low + 1) + "))";
}

std::string boxes(const Layer& layer) {
  return "using " + middle(layer, 0) + ':' + middle(layer, 2) + ':' + column(layer, 0) + ':' + column(layer, 1) + ':' +
         column(layer, 2) + ':' + column(layer, 3) + " with boxxyerror";
}

std::string spans(const Layer& layer) {
  return "using " + middle(layer, 0) + ":(0.5):" + column(layer, 0) + ':' + column(layer, 1) +
         ":(0):(1) axes x1y2 with boxxyerror";
}

std::string image(const Table::Grid& grid) {
  return "matrix using (" + number_text(grid.x) + "+$1*" + number_text(grid.dx) + "):(" + number_text(grid.y) + "+$2*" +
         number_text(grid.dy) + "):($3>0?log10($3):NaN) with image";
}

std::string markers_of(const Style& style) {
  return " pt " + std::to_string(style.marker) + " ps " + number_text(style.size);
}

/// Whether a colour such as `#0072b2` would be dark in a grey print: by its luma, ITU-R BT.601.
bool is_dark(const std::string& colour) {
  const auto part = [&colour](std::size_t place) { return std::stoi(colour.substr(place, 2), nullptr, 16); };
  return 0.299 * part(1) + 0.587 * part(3) + 0.114 * part(5) < 150.0;
}

std::vector<std::string> filled(const std::string& what, const Style& style) {
  std::vector<std::string> elements{what + ' ' + fill_of(style)};
  if (style.hatch != 0) elements.push_back(what + ' ' + hatch_over(style));
  return elements;
}

}  // namespace

std::string fill_of(const Style& style) {
  const std::string fill = "fc rgb '" + style.colour + "' fs transparent solid " + number_text(style.opacity);
  // A border in the same colour closes the seams between neighbours; through a sheer one it would show.
  return fill + (style.opacity < 1.0 ? std::string(" noborder") : " border lc rgb '" + style.colour + "' lw 0.67");
}

std::string hatch_over(const Style& style) {
  const char* ink = is_dark(style.colour) ? "#ffffff" : "#404040";  // in grey a hatch must show by itself
  return std::string("fc rgb '") + ink + "' fs transparent pattern " + std::to_string(style.hatch) + " noborder";
}

std::string stroke_of(const Style& style) {
  return "lc rgb '" + style.colour + "' dt " + std::to_string(style.dash) + " lw " + number_text(style.width);
}

std::vector<std::string> plot_elements(const Figure& figure, const Layer& layer) {
  const std::string data = "data index " + std::to_string(layer.table) + ' ';
  const Style& style = layer.style;
  switch (layer.kind) {
    case LayerKind::boxes: return filled(data + boxes(layer), style);
    case LayerKind::spans: return filled(data + spans(layer), style);
    case LayerKind::polygon: return filled(data + as_they_are(layer) + " with filledcurves closed", style);
    case LayerKind::ribbon: return filled(data + as_they_are(layer) + " with filledcurves", style);
    case LayerKind::image: return {data + image(figure.tables.at(layer.table).grid.value())};
    case LayerKind::line:
      return {data + as_they_are(layer) + " with " + (style.marker == 0 ? "lines " : "linespoints ") +
              stroke_of(style) + (style.marker == 0 ? "" : markers_of(style))};
    case LayerKind::steps: return {data + as_they_are(layer) + " with steps " + stroke_of(style)};
    case LayerKind::points:
      return {data + as_they_are(layer) + " with points lc rgb '" + style.colour + "' lw " + number_text(style.width) +
              markers_of(style)};
    case LayerKind::error_bars:
      return {data + as_they_are(layer) + " with yerrorbars lc rgb '" + style.colour + "' lw " +
              number_text(style.width) + markers_of(style)};
    case LayerKind::arrows:
      return {data + as_they_are(layer) + " with vectors filled head size graph 0.02,20 " + stroke_of(style)};
    case LayerKind::texts: return {data + as_they_are(layer) + " with labels textcolor rgb '" + style.colour + '\''};
  }
  return {};
}

}  // namespace rocking::analysis

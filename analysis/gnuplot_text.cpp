#include "analysis/gnuplot_text.hpp"

#include <algorithm>

#include "analysis/figure_scripts.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/look/text_table.hpp"

namespace rocking::analysis {
namespace {

constexpr std::string_view plain_marks = " ,.;:?()[]/+-*=_";
constexpr std::string_view replacement = "\xEF\xBF\xBD";       // U+FFFD
constexpr std::string_view ellipsis = "\xE2\x80\xA6";          // U+2026
constexpr std::string_view zero_width_space = "\xE2\x80\x8B";  // U+200B

/// A UTF-8 character that is a control (U+0000 to U+001F, U+007F to U+009F).
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  return first < 0x20 || first == 0x7f || (first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0);
}

bool is_forbidden_in_xml(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";  // U+FFFE, U+FFFF
}

/// Characters that need no escape within gnuplot's double quotes, wherever the string is used.
bool is_plain(char c) {
  const bool letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
  return letter || (static_cast<unsigned char>(c) & 0x80U) != 0 || plain_marks.find(c) != std::string_view::npos;
}

std::string octal(char c) {
  const auto code = static_cast<unsigned char>(c);
  return {'\\', static_cast<char>('0' + code / 64), static_cast<char>('0' + code / 8 % 8),
          static_cast<char>('0' + code % 8)};
}

/// gnuplot's SVG output interprets `&#x` as a character reference and does not escape `]]>`, which XML forbids: both
/// are broken up.
std::string safe_in_svg(std::string text) {
  for (const std::string_view sequence : {"&#x", "]]>"}) {
    for (std::size_t place = text.find(sequence); place != std::string::npos; place = text.find(sequence, place)) {
      text.insert(place + sequence.size() - 1, zero_width_space);
    }
  }
  return text;
}

/// `text` with `mark` inserted before each character that is in `special`.
std::string marked(std::string_view text, std::string_view special, char mark) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += mark;
    result += c;
  }
  return result;
}

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

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = base::utf8_length_at(text, place);
    const std::string_view character = text.substr(place, length);
    if (length == 0 || is_forbidden_in_xml(character)) {
      result += replacement;
    } else if (is_control(character)) {
      result += ' ';
    } else if (const std::string direction = base::direction_control_at(text, place); !direction.empty()) {
      result += direction;
    } else {
      result += character;
    }
    place += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string cut(const std::string& text, std::size_t most) {
  if (letters_in(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t count = 1; count < most; ++count) end += base::utf8_length_at(text, end);
  return text.substr(0, end).append(ellipsis);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = cut(text.substr(start, end - start), most);
    const bool fits = letters_in(lines.back()) + 1 + letters_in(word) <= most;
    if (!lines.back().empty() && !fits) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    start = end + 1;
  }
  return lines;
}

std::string gnuplot_quoted(std::string_view text) {
  std::string result = "\"";
  bool after_octal = false;
  for (const char c : safe_in_svg(printable(text))) {
    // gnuplot reads a digit after an octal number as part of that number.
    const bool misread = after_octal && '0' <= c && c <= '9';
    after_octal = misread || !is_plain(c);
    result += after_octal ? octal(c) : std::string(1, c);
  }
  return result + '"';
}

std::string without_marks(std::string_view text) { return marked(printable(text), "\\^_{}@&~", '\\'); }

std::string without_formats(std::string_view text) { return marked(printable(text), "%", '%'); }

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

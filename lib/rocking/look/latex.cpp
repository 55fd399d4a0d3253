#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/look/table.hpp"

namespace rocking::look {
namespace {

/// A number with a minus sign or a power of ten is set in mathematics: `$-0.45$`, `$1.9 \times 10^{-4}$`.
std::string number_in_latex(const std::string& number) {
  const std::size_t exponent = number.find('e');
  if (exponent == number.npos) return number.starts_with('-') ? '$' + number + '$' : number;
  return '$' + number.substr(0, exponent) + " \\times 10^{" + std::to_string(std::stoi(number.substr(exponent + 1))) +
         "}$";
}

/// Words; those of a cell may be a number.
std::string words_in_latex(const std::string& words) {
  const bool is_number = words.find_first_not_of("-+.e0123456789") == words.npos &&
                         words.find_first_of("0123456789") != words.npos && words.find_last_of('-') != words.size() - 1;
  return is_number ? number_in_latex(words) : latex_text(words);
}

std::string end_in_latex(const std::optional<double>& end, Form form) {
  if (!end) return "--";
  return std::isfinite(*end) ? number_in_latex(in_form(*end, form)) : "unbounded";
}

std::string cell_in_latex(const Cell& cell) {
  if (const std::string* words = std::get_if<std::string>(&cell)) return words_in_latex(*words);
  const Number* number = std::get_if<Number>(&cell);
  if (number == nullptr) return "--";
  std::string text = number->bound == '\0' ? "" : std::string{'$', number->bound, '$', ' '};
  text += number->value ? number_in_latex(in_form(*number->value, number->form)) : "--";
  if (const auto& ends = number->interval) {
    text += " [" + end_in_latex(ends->low, number->form) + ", " + end_in_latex(ends->high, number->form) + ']';
  }
  return text + number->after;
}

/// Greek letters by code point from U+0391 and U+03B1 on; those without a command of their own look like Latin ones.
constexpr std::array<std::string_view, 25> capitals{
    "A",    "B", "\\Gamma", "\\Delta", "E", "Z",       "H", "\\Theta",   "I",     "K", "\\Lambda", "M",      "N",
    "\\Xi", "O", "\\Pi",    "P",       "",  "\\Sigma", "T", "\\Upsilon", "\\Phi", "X", "\\Psi",    "\\Omega"};
constexpr std::array<std::string_view, 25> small{
    "\\alpha", "\\beta",   "\\gamma",   "\\delta",  "\\varepsilon", "\\zeta", "\\eta",  "\\theta", "\\iota",
    "\\kappa", "\\lambda", "\\mu",      "\\nu",     "\\xi",         "o",      "\\pi",   "\\rho",   "\\varsigma",
    "\\sigma", "\\tau",    "\\upsilon", "\\varphi", "\\chi",        "\\psi",  "\\omega"};

struct Sign {
  char32_t code;
  std::string_view latex;
};
constexpr std::array<Sign, 21> signs{
    {{0xa0, "~"},          {0xb0, "$^\\circ$"}, {0xb1, "$\\pm$"},    {0xb2, "$^2$"},         {0xb3, "$^3$"},
     {0xb5, "$\\mu$"},     {0xb7, "$\\cdot$"},  {0xd7, "$\\times$"}, {0xf7, "$\\div$"},      {0x2013, "--"},
     {0x2014, "---"},      {0x2018, "`"},       {0x2019, "'"},       {0x201c, "``"},         {0x201d, "''"},
     {0x2026, "\\dots{}"}, {0x2032, "$'$"},     {0x2212, "$-$"},     {0x2248, "$\\approx$"}, {0x2264, "$\\le$"},
     {0x2265, "$\\ge$"}}};

/// Latin letters with the accents that OT1 sets, in U+00C0 to U+017F; it lacks the others there.
bool is_accented_letter(char32_t code) {
  constexpr std::array<char32_t, 29> missing{0xd0,  0xd7,  0xde,  0xf0,  0xf7,  0xfe,  0x104, 0x105, 0x110, 0x111,
                                             0x118, 0x119, 0x126, 0x127, 0x12e, 0x12f, 0x132, 0x133, 0x138, 0x13f,
                                             0x140, 0x149, 0x14a, 0x14b, 0x166, 0x167, 0x172, 0x173, 0x17f};
  return code >= 0xc0 && code <= 0x17f && std::ranges::find(missing, code) == missing.end();
}

char32_t code_of(std::string_view character) {
  constexpr std::array<unsigned, 5> kept{0, 0x7f, 0x1f, 0x0f, 0x07};
  char32_t code = static_cast<unsigned char>(character.front()) & kept[character.size()];
  for (const char c : character.substr(1)) code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3fU);
  return code;
}

std::string latex_of(std::string_view character) {
  const char32_t code = code_of(character);
  const auto sign = std::ranges::find(signs, code, &Sign::code);
  if (sign != signs.end()) return std::string(sign->latex);
  const bool is_capital = code >= 0x391 && code < 0x391 + capitals.size() && code != 0x3a2;
  const bool is_small = code >= 0x3b1 && code < 0x3b1 + small.size();
  if (is_capital) return '$' + std::string(capitals[code - 0x391]) + '$';
  if (is_small) return '$' + std::string(small[code - 0x3b1]) + '$';
  if (is_accented_letter(code)) return std::string(character);
  std::array<char, 16> escape{};
  std::snprintf(escape.data(), escape.size(), "[U+%04X]", static_cast<unsigned>(code));
  return escape.data();
}

std::string latex_of(char c) {
  switch (c) {
    case '\\': return "\\textbackslash{}";
    case '~': return "\\textasciitilde{}";
    case '^': return "\\textasciicircum{}";
    case '<': return "\\textless{}";
    case '>': return "\\textgreater{}";
    case '|': return "\\textbar{}";
    case '"': return "''";
    case '&':
    case '%':
    case '$':
    case '#':
    case '_':
    case '{':
    case '}': return std::string("\\") + c;
    default: return std::string(1, c);
  }
}

}  // namespace

std::string to_latex(const Table& all, const std::string& caption) {
  const Table table = part_in(Media::latex, all);
  const auto line_of = [](const auto& cells, auto&& latex) {
    std::string line;
    for (const auto& cell : cells) line += (line.empty() ? "    " : " & ") + latex(cell);
    return line + " \\\\\n";
  };
  std::string text =
      "% Needs \\usepackage{booktabs}; of a long table, longtable.\n\\begin{table}\n  \\centering\n  \\caption{" +
      caption + "}\n  \\begin{tabular}{" + std::string(table.columns.size(), 'r') + "}\n    \\toprule\n" +
      line_of(table.columns,
              [](const Column& column) { return column.latex.empty() ? latex_text(column.title) : column.latex; }) +
      "    \\midrule\n";
  for (const Row& row : table.rows) text += line_of(row, cell_in_latex);
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

std::string latex_caption(const std::string& title, const std::string& caption) {
  if (title.empty()) return caption;
  return latex_text(title) + (std::string_view(".?!").find(title.back()) == std::string_view::npos ? ". " : " ") +
         caption;
}

std::string latex_text(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  const std::string shown = base::printable(text);
  std::string result;
  for (std::size_t i = 0; i < shown.size();) {
    const std::size_t length = std::max<std::size_t>(1, base::utf8_length_at(shown, i));
    const std::string_view character = std::string_view(shown).substr(i, length);
    result += length == 1 ? latex_of(character.front()) : latex_of(character);
    i += length;
  }
  return result;
}

std::string latex_symbol(std::string_view symbol) {
  std::string text = latex_text(std::string(symbol));
  std::erase(text, '$');
  constexpr std::string_view escaped_subscript = "\\_";
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (!text.compare(i, escaped_subscript.size(), escaped_subscript)) {
      const std::size_t end = std::min(text.find('/', i), text.size());
      const std::string lower = text.substr(i + escaped_subscript.size(), end - i - escaped_subscript.size());
      result += lower.size() == 1 ? '_' + lower : "_{" + lower + '}';
      i = end;
    } else {
      result += text[i++];
    }
  }
  const bool is_word = result.find_first_of("\\_'") == result.npos && result.size() > 1;
  return '$' + (is_word ? "\\mathrm{" + result + '}' : result) + '$';
}

}  // namespace rocking::look

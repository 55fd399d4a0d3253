#include "rocking/look/markup.hpp"
#include "rocking/look/table.hpp"

namespace rocking::look {
namespace {

std::string latex_of(const Cell& cell) {
  if (const std::string* words = std::get_if<std::string>(&cell)) return latex_text(*words);
  const Number* number = std::get_if<Number>(&cell);
  if (number == nullptr) return "--";
  const std::string ends = interval_words(*number, "--");
  return (number->bound == '\0' ? "" : std::string{'$', number->bound, '$', ' '}) +
         (number->value ? in_form(*number->value, number->form) : "--") + (ends.empty() ? "" : ' ' + ends) +
         number->after;
}

}  // namespace

std::string to_latex(const Table& table, const std::string& caption) {
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
  for (const Row& row : table.rows) text += line_of(row, latex_of);
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

}  // namespace rocking::look

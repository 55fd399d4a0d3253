#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figure_scripts.hpp"
#include "analysis/page/page.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/base/error.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/run_tables.hpp"
#include "rocking/studies/studies.hpp"

/// Reading of files that rocking wrote and that may have been changed, as in the commands, without drawing and without
/// files.
namespace rocking::fuzz {

enum class Reading : std::uint8_t { used, refused };

/// As `rocking report` with every format. Rethrows any exception that is not a refusal.
inline Reading try_report(std::string_view text) {
  try {
    const Report report = parse_report(text);
    std::vector<analysis::DrawnFigure> drawn;
    for (analysis::Figure& figure : analysis::run_figures(report)) {
      static_cast<void>(analysis::script_text(figure));
      static_cast<void>(analysis::data_text(figure));
      drawn.push_back({.figure = std::move(figure), .svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"});
    }
    const std::string page = analysis::page_text(report, drawn);
    if (page.find("<script>alert") != std::string::npos) throw std::logic_error("text of a report runs in its page");
    static_cast<void>(table_files(report, {"csv", "latex"}));
    return Reading::used;
  } catch (const base::InputError& error) {
    if (error.problems().empty()) throw std::logic_error("a refusal without a reason");
    return Reading::refused;
  }
}

/// Reads a report as `rocking verify` does before it runs anything.
inline Reading try_claims(std::string_view text) {
  try {
    static_cast<void>(claims_of_report(text));
    return Reading::used;
  } catch (const base::InputError&) {
    return Reading::refused;
  }
}

/// As `rocking report`.
inline Reading try_output(const std::string& text) {
  try {
    for (const analysis::Figure& figure : analysis::output_figures({{.path = "file.json", .text = text}}, {})) {
      static_cast<void>(analysis::script_text(figure));
      static_cast<void>(analysis::data_text(figure));
    }
    return Reading::used;
  } catch (const base::InputError& error) {
    if (error.problems().empty()) throw std::logic_error("a refusal without a reason");
    return Reading::refused;
  }
}

}  // namespace rocking::fuzz

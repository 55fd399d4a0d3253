#pragma once

#include <string>

/// Texts that the build embeds in the program.
namespace rocking::analysis {

/// dygraphs 2 (MIT licence): script and style; empty if it was not available at the build.
[[nodiscard]] std::string dygraphs_script();
[[nodiscard]] std::string dygraphs_style();

/// The project's own script and style of a page: shapes.js, series.js, charts.js, animation.js and page.js; page.css.
[[nodiscard]] std::string page_script();
[[nodiscard]] std::string page_style();

/// sheet.css.
[[nodiscard]] std::string sheet_style();

}  // namespace rocking::analysis

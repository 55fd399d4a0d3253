#pragma once

#include <string>

/// Texts that the build puts into the program.
namespace rocking::analysis {

/// dygraphs 2 (MIT licence): script and style; empty where it was not there at the build.
[[nodiscard]] std::string dygraphs_script();
[[nodiscard]] std::string dygraphs_style();

/// Our own part of a page: shapes.js, series.js, charts.js and page.js; page.css.
[[nodiscard]] std::string page_script();
[[nodiscard]] std::string page_style();

}  // namespace rocking::analysis

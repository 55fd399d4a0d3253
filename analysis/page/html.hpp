#pragma once

#include <string>
#include <string_view>

#include "rocking/look/markup.hpp"
#include "rocking/text/json.hpp"

/// Pieces of HTML. None has a style attribute or an event handler: the policy of a page forbids both.
namespace rocking::analysis {

using look::escaped;
using look::lowered;

/// JSON that can be inserted into a script element: it cannot end the element.
[[nodiscard]] std::string json_for_script(const Json& json);

/// An image as a data address for an `img` element. `format`: `svg+xml` or `png`.
[[nodiscard]] std::string data_address(std::string_view format, std::string_view image);

/// Source expression of a content-security policy for a script or style with this text: `'sha256-...'`.
[[nodiscard]] std::string policy_hash(std::string_view text);

/// The text of a sentence as HTML, in which the words `A_h` and `Ω_h` are set as symbols. Other words keep their `_`:
/// they may be names of files.
[[nodiscard]] std::string with_symbols(std::string_view text);

/// A symbol as HTML, with subscripts: `A_h`, `mu_s/mu_k`.
[[nodiscard]] std::string symbol_html(std::string_view symbol);

/// What is folded away until its summary is chosen, both HTML.
[[nodiscard]] std::string folded(const std::string& summary, const std::string& content);

/// What surrounds the content of a page.
struct Frame {
  std::string title;
  bool has_charts = true;  ///< whether dygraphs is embedded, if it was available at the build
};

/// A page without external resources: `content` (HTML) below its title. Its content-security policy allows only its own
/// script and style, given by their hashes, and embedded pictures.
[[nodiscard]] std::string framed(const Frame& frame, const std::string& content);

/// dygraphs 2 (MIT licence): script and style; empty if it was not available at the build.
[[nodiscard]] std::string dygraphs_script();
[[nodiscard]] std::string dygraphs_style();

/// The project's own script and style of a page: shapes.js, series.js, charts.js, animation.js and page.js; page.css.
[[nodiscard]] std::string page_script();
[[nodiscard]] std::string page_style();

/// sheet.css.
[[nodiscard]] std::string sheet_style();

}  // namespace rocking::analysis

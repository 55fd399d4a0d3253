#pragma once

#include <string>
#include <string_view>

namespace rocking::look {

/// Text for LaTeX, for the fonts (OT1) and the encoding (UTF-8) that it has without packages: other characters than those
/// of ASCII, accented Latin letters, Greek letters and common signs are written as `[U+1F30A]`.
[[nodiscard]] std::string latex_text(std::string text);

/// A symbol, where a `_` begins a subscript, as mathematics: `$A_h$`, `$\delta_{-1}$`, `$\mathrm{PGA}$`.
[[nodiscard]] std::string latex_symbol(std::string_view symbol);

/// Text that can be inserted into an element or a quoted attribute of HTML: special characters are escaped.
[[nodiscard]] std::string escaped(std::string_view text);

/// Text as HTML, with letters and digits after a `_` as subscripts: `base amplitude A_h`.
[[nodiscard]] std::string lowered(std::string_view text);

}  // namespace rocking::look

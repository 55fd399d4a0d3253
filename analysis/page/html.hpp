#pragma once

#include <string>
#include <string_view>

#include "rocking/report/json.hpp"

/// Pieces of HTML. None of them holds a style attribute or a handler: a page's policy forbids both.
namespace rocking::analysis {

/// Text as HTML may hold it, within an element or a quoted attribute: nothing of it is taken for a tag.
[[nodiscard]] std::string escaped(std::string_view text);

/// JSON as a script element may hold it: nothing of it ends the element.
[[nodiscard]] std::string json_for_script(const report::Json& json);

/// An image as the address of an `img` element.
[[nodiscard]] std::string data_address(std::string_view svg);

/// What a content-security policy calls a script or style of this text: `'sha256-...'`.
[[nodiscard]] std::string policy_hash(std::string_view text);

/// Text as HTML, with letters and digits behind a `_` set low: `base amplitude A_h`.
[[nodiscard]] std::string lowered(std::string_view text);

/// The same of a symbol: `A_h`, `mu_s/mu_k`.
[[nodiscard]] std::string symbol_html(std::string_view symbol);

}  // namespace rocking::analysis

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts from outside on their way into a gnuplot script, a data file and a picture.
namespace rocking::analysis {

/// A text as one line of valid UTF-8 that XML may hold: a control character becomes a space; a byte that is no UTF-8, and a
/// character that XML forbids, becomes U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

/// The first `most` characters of UTF-8 text, the last of them an ellipsis where some were left off.
[[nodiscard]] std::string cut(const std::string& text, std::size_t most);

/// A text as a gnuplot string that shows just this text. In double quotes; every ASCII character that could mean something to
/// gnuplot is given by its octal number, so nothing in it ends the string, opens a block or starts a command. For places
/// that are `noenhanced`.
[[nodiscard]] std::string quoted(std::string_view text);

/// A text for a place where gnuplot reads marks of setting (`_`, `^`, `{`), which are then shown as they are; to be quoted.
[[nodiscard]] std::string without_marks(std::string_view text);

/// A text for a tick, where gnuplot reads `%` as the start of a number's format, which is then shown as it is; to be quoted.
[[nodiscard]] std::string without_formats(std::string_view text);

}  // namespace rocking::analysis

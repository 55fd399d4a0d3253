#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/figures/figure.hpp"

/// The parts of a gnuplot script: external text, prepared so that it can do no harm, and the elements of `plot`.
namespace rocking::analysis {

/// The text as one line of valid UTF-8 without characters that XML forbids. A control character becomes a space, one of
/// writing direction its escape (`\u202e`); an invalid byte and a forbidden character become U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

/// The first `most` characters of a valid UTF-8 text. If some are omitted, the last one is an ellipsis.
[[nodiscard]] std::string cut(const std::string& text, std::size_t most);

/// The text in lines of at most `most` characters, broken at spaces; a longer word is cut as above.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t most);

/// A double-quoted gnuplot string that shows exactly this text. Every ASCII character with a meaning in gnuplot is
/// given by its octal number, so that nothing in it can end the string, open a block or start a command. For places
/// that are `noenhanced`.
[[nodiscard]] std::string gnuplot_quoted(std::string_view text);

/// A text for a place where gnuplot interprets markup (`_`, `^`, `{`), escaped so that it is shown as it is. To be
/// quoted.
[[nodiscard]] std::string without_marks(std::string_view text);

/// A text for a tick, where gnuplot interprets `%` as a number format, escaped so that it is shown as it is. To be
/// quoted.
[[nodiscard]] std::string without_formats(std::string_view text);

/// `fc ... fs transparent solid ...` of a filled shape; with a hatch there is another to be laid over it.
[[nodiscard]] std::string fill_of(const Style& style);
[[nodiscard]] std::string hatch_over(const Style& style);

/// `lc ... dt ... lw ...`.
[[nodiscard]] std::string stroke_of(const Style& style);

/// What `plot` is given for a layer: one element, or two where a hatch is laid over it.
[[nodiscard]] std::vector<std::string> plot_elements(const Figure& figure, const Layer& layer);

}  // namespace rocking::analysis

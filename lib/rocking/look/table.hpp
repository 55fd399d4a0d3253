#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rocking/stats/interval.hpp"

/// A table as data, and its renderers: for a terminal, CSV, LaTeX and HTML.
namespace rocking::look {

/// How a number is written for readers. Data files have all its digits.
struct Form {
  enum class Kind : std::uint8_t { significant, fixed, per_cent, rate } kind = Kind::significant;
  int digits = 3;  ///< significant ones, decimals, or at least so many decimals of a percentage
  constexpr Form(int significant) : digits(significant) {}
  constexpr Form(Kind of, int number) : kind(of), digits(number) {}
};
[[nodiscard]] constexpr Form decimals(int number) { return {Form::Kind::fixed, number}; }
[[nodiscard]] constexpr Form percentage(int least = 1) { return {Form::Kind::per_cent, least}; }
/// Of rates and their quotients: rate_text().
[[nodiscard]] constexpr Form rate_form() { return {Form::Kind::rate, 2}; }

/// Ends of an interval; absent: open, shown as `-`. An infinite one is shown as `unbounded`.
struct Ends {
  Ends(const stats::Interval& closed) : low(closed.low), high(closed.high) {}
  Ends(std::optional<double> from, std::optional<double> to) : low(from), high(to) {}
  std::optional<double> low, high;
};

/// `98.5 [94.4, 99.8] (48)`, `< 2.8`, `> 1000 [740, -]`.
struct Number {
  std::optional<double> value;  ///< absent: nothing is known but its interval
  Form form = 3;
  std::optional<Ends> interval = std::nullopt;
  std::string after = {};  ///< what is written behind it, with a blank
  char bound = '\0';       ///< `<` or `>`: the value is a bound
};

/// Nothing, words, or a number.
using Cell = std::variant<std::monostate, std::string, Number>;
using Row = std::vector<Cell>;

/// Where a table or a column is shown: one medium, or several. Publications are LaTeX and pages.
enum class Media : std::uint8_t {
  terminal = 1,
  csv = 2,
  latex = 4,
  page = 8,
  publications = 12,
  readers = 13,
  all = 15
};
[[nodiscard]] constexpr Media operator|(Media a, Media b) {
  return static_cast<Media>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
[[nodiscard]] constexpr bool is_shown_in(Media medium, Media media) {
  return (static_cast<unsigned>(medium) & static_cast<unsigned>(media)) != 0;
}

struct Column {
  std::string title;          ///< on a terminal and in CSV
  std::string latex = {};     ///< in LaTeX; empty: the title
  std::string html = {};      ///< in HTML; empty: the title, with letters after a `_` as subscripts
  bool has_interval = false;  ///< CSV has two more columns for its ends
  Media media = Media::all;
};

/// Rows have as many cells as there are columns.
struct Table {
  std::string title = {};  ///< lines above it on a terminal
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
  std::string notes = {};    ///< lines below it on a terminal, each with its end
  std::string absent = ".";  ///< what stands for nothing on a terminal
};

/// Nothing if there is no number. `after`: words behind it.
[[nodiscard]] Cell number(const std::optional<double>& value, Form form, std::string after = {});
[[nodiscard]] Cell number(double value, const std::optional<stats::Interval>& interval, Form form,
                          std::string after = {});
/// The interval alone.
[[nodiscard]] Cell interval(const std::optional<stats::Interval>& ends, Form form);
[[nodiscard]] Cell whole(std::uint64_t count);
[[nodiscard]] Cell without_interval(Cell cell);

[[nodiscard]] std::string in_form(double value, Form form);
/// `[94.4, 99.8]` with `open` for an open end; empty without an interval.
[[nodiscard]] std::string interval_words(const Number& number, const std::string& open);

/// Adds columns with these titles.
void add_columns(Table& table, const std::vector<std::string>& titles);

/// Adds these cells to a row.
void append(Row& row, const Row& cells);

/// Neighbouring rows that differ only in the `count` columns from `first` on become one row, with `0.15 to 0.35` there.
void merge_rows(Table& table, std::size_t first, std::size_t count);

/// The table with the columns that are shown in this medium; what the renderers show.
[[nodiscard]] Table part_in(Media medium, const Table& table);

/// Without so many of its last columns that no line on a terminal is longer than `width`, where one column is not.
[[nodiscard]] Table narrowed(Table table, std::size_t width);

/// A cell as a terminal shows it.
[[nodiscard]] std::string plain_text(const Cell& cell, const std::string& absent = ".");

/// Lines of columns, flush right, below their titles, between `title` and `notes`.
[[nodiscard]] std::string to_terminal(const Table& table);
/// The length of its longest line in letters, without title and notes.
[[nodiscard]] std::size_t width_of(const Table& table);

/// CSV (RFC 4180). Numbers have all their digits; nothing is an empty field. The ends of intervals are `low` and `high`,
/// and of several columns `TITLE_low` and `TITLE_high`.
[[nodiscard]] std::string to_csv(const Table& table);
/// One line of it, for a table that is too long to be kept.
[[nodiscard]] std::string csv_line(const std::vector<Column>& columns, const Row& row);

/// A table of booktabs, flush right. `caption`: LaTeX. Nothing is `--`.
[[nodiscard]] std::string to_latex(const Table& table, const std::string& caption);

/// A title, as a sentence of its own, and what follows it in LaTeX.
[[nodiscard]] std::string latex_caption(const std::string& title, const std::string& caption);

/// What is said of a table on a page.
struct Caption {
  std::string label;  ///< plain text, escaped
  std::string html;
};
/// A table that the script of a page lets sort; its first `most` rows, and a line if there are more. The first cell of a
/// row is its heading. Nothing is `none`.
[[nodiscard]] std::string to_html(const Table& table, const Caption& caption, std::size_t most);

}  // namespace rocking::look

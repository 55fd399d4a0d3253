#include "rocking/input/csv_table.hpp"

#include <algorithm>

namespace rocking {
namespace {

/// Where blanks separate fields, a tab is one of them.
constexpr std::string_view separators_of(bool do_blanks_separate) { return do_blanks_separate ? ",;" : ",;\t"; }

std::string fields_in_words(std::size_t count) { return std::to_string(count) + (count == 1 ? " field" : " fields"); }

/// Cuts a line into fields, character by character.
class FieldSplitter {
 public:
  FieldSplitter(CsvStyle style, bool do_blanks_separate, std::vector<std::string>& fields)
      : style_(style), do_blanks_separate_(do_blanks_separate), fields_(fields) {
    fields_.assign(1, "");
  }

  /// Returns whether every quotation mark is closed.
  [[nodiscard]] bool split(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == '"') {
        const bool is_doubled = is_quoted_ && line.substr(i + 1).starts_with('"');
        if (is_doubled) fields_.back() += line[++i];
        if (!is_doubled) is_quoted_ = !is_quoted_;
      } else if (is_quoted_) {
        fields_.back() += c;
      } else if (style_.has_comments && c == '#') {
        break;
      } else {
        add(c, line.substr(i + 1));
      }
    }
    return !is_quoted_;
  }

 private:
  void add(char c, std::string_view rest) {
    const bool is_blank = c == ' ' || c == '\t';
    const bool is_separator = do_blanks_separate_ ? is_blank : separators_of(false).find(c) != std::string_view::npos;
    if (is_separator && depth_ == 0) {
      if (do_blanks_separate_ && fields_.back().empty()) return;  // blanks side by side separate once
      fields_.emplace_back();
      return;
    }
    if (c == '(' && rest.find(')') != std::string_view::npos) ++depth_;
    if (c == ')' && depth_ > 0) --depth_;
    fields_.back() += c;
  }

  CsvStyle style_;
  bool do_blanks_separate_;
  std::vector<std::string>& fields_;
  bool is_quoted_ = false;
  std::size_t depth_ = 0;
};

}  // namespace

bool CsvTable::next() {
  while (!text_.empty() && !problems_->enough()) {
    line_ = problems_->next_line(text_);
    if (!split()) continue;
    if (std::ranges::all_of(fields_, &std::string::empty)) {
      if (columns_ > 0 && style_.does_empty_line_end) return false;
      continue;
    }
    if (columns_ == 0) columns_ = fields_.size();
    if (fields_.size() == columns_) return true;
    problems_->reject_line(
        line(), "has " + fields_in_words(fields_.size()) + ", but the first line has " + std::to_string(columns_),
        "give every line as many; write decimal points, and a text with a comma between quotation marks");
  }
  return false;
}

bool CsvTable::split() {
  const std::string_view line = trimmed(line_);
  const bool do_blanks_separate =
      style_.do_blanks_separate &&
      line.substr(0, line.find('#')).find_first_of(separators_of(true)) == std::string_view::npos;
  const bool is_closed = FieldSplitter(style_, do_blanks_separate, fields_).split(line);
  for (std::string& field : fields_) field = std::string(trimmed(field));
  if (do_blanks_separate && fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
  if (!is_closed) {
    problems_->reject_line(fields_.back(), "has a quotation mark that is not closed", "write for example \"(1,1)\"");
  }
  return is_closed;
}

}  // namespace rocking

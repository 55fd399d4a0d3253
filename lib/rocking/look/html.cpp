#include <algorithm>
#include <cctype>

#include "rocking/base/utf8.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/look/table.hpp"

namespace rocking::look {
namespace {

std::string html_of(const Cell& cell) {
  if (const std::string* words = std::get_if<std::string>(&cell)) return escaped(*words);
  const Number* number = std::get_if<Number>(&cell);
  const std::string none = "<span class=\"none\">none</span>";
  if (number == nullptr) return none;
  const std::string value = number->value ? in_form(*number->value, number->form) : none;
  const std::string ends = interval_words(*number, "open");
  return (number->bound == '\0'
              ? value
              : "<span class=\"none\">" + escaped(std::string{number->bound, ' '}) + value + "</span>") +
         (ends.empty() ? "" : " <span class=\"interval\">" + ends + "</span>") + number->after;
}

/// An upper bound is sorted as 0, a lower one as its number, other cells by the number with which their text begins.
std::string element(const char* name, const char* scope, const Cell& cell) {
  const Number* number = std::get_if<Number>(&cell);
  const bool is_bound = number != nullptr && number->bound != '\0';
  const std::string value = is_bound && number->bound == '>' ? in_form(number->value.value_or(0.0), number->form) : "0";
  return std::string("<") + name + scope + (is_bound ? " data-value=\"" + value + '"' : "") + '>' + html_of(cell) +
         "</" + name + '>';
}

}  // namespace

std::string to_html(const Table& all, const Caption& caption, std::size_t most) {
  const Table table = part_in(Media::page, all);
  std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + caption.label +
                     "\"><table class=\"sortable\"><caption><span>" + caption.html + "</span></caption>\n<thead><tr>";
  for (const Column& column : table.columns) {
    text += "<th scope=\"col\">" + (column.html.empty() ? lowered(column.title) : column.html) + "</th>";
  }
  text += "</tr></thead>\n<tbody>\n";
  const std::size_t shown = std::min(most, table.rows.size());
  for (std::size_t r = 0; r < shown; ++r) {
    const Row& row = table.rows[r];
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i == 0 ? element("th", " scope=\"row\"", row[i]) : element("td", "", row[i]);
    }
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  if (shown == table.rows.size()) return text;
  return text + "<p class=\"limit\">The first " + std::to_string(shown) + " of " + std::to_string(table.rows.size()) +
         " rows. <code>rocking report DIR --format csv</code> writes all of them.</p>\n";
}

std::string escaped(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::string direction = base::direction_control_at(text, i);
    switch (const char c = text[i]) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&#39;"; break;
      default:
        if (direction.empty()) {
          html += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
        } else {
          html += direction;
        }
    }
    i += direction.empty() ? 1 : base::utf8_length_at(text, i);
  }
  return html;
}

std::string lowered(std::string_view text) {
  std::string html;
  bool low = false;
  for (const char c : text) {
    const bool goes_on = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (c == '_') {
      html += "<sub>";
      low = true;
    } else {
      if (low && !goes_on) {
        html += "</sub>";
        low = false;
      }
      html += escaped({&c, 1});
    }
  }
  return html + (low ? "</sub>" : "");
}

}  // namespace rocking::look

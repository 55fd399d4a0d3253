#include <cctype>

#include "rocking/base/utf8.hpp"
#include "rocking/look/markup.hpp"

namespace rocking::look {

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

#include "analysis/page/html.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <openssl/evp.h>

#include "rocking/base/digest.hpp"
#include "rocking/base/utf8.hpp"

namespace rocking::analysis {
namespace {

std::string base64(std::string_view bytes) {
  std::vector<unsigned char> text(4 * ((bytes.size() + 2) / 3) + 1);
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  const int written = EVP_EncodeBlock(text.data(), first, static_cast<int>(bytes.size()));
  return {text.begin(), text.begin() + written};
}

}  // namespace

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

std::string json_for_script(const Json& json) {
  const std::string text = json.dump();
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::string direction = base::direction_control_at(text, i);
    if (!direction.empty()) {
      safe += '\\' + direction;
    } else if (text[i] == '<') {
      safe += "\\u003c";
    } else {
      safe += text[i];
    }
    i += direction.empty() ? 1 : base::utf8_length_at(text, i);
  }
  return safe;
}

std::string data_address(std::string_view format, std::string_view image) {
  return "data:image/" + std::string(format) + ";base64," + base64(image);
}

std::string policy_hash(std::string_view text) {
  const base::Sha256 digest = base::sha256(text);
  return "'sha256-" + base64({reinterpret_cast<const char*>(digest.data()), digest.size()}) + '\'';
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

std::string with_symbols(std::string_view text) {
  std::string html;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string_view word = text.substr(start, end - start);
    html += word == "A_h" || word == "Ω_h" ? symbol_html(word) : escaped(word);
    if (end < text.size()) html += ' ';
    start = end + 1;
  }
  return html;
}

std::string symbol_html(std::string_view symbol) { return "<i>" + lowered(symbol) + "</i>"; }

}  // namespace rocking::analysis

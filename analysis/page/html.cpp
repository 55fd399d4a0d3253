#include "analysis/page/html.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
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

constexpr std::string_view dygraphs_licence =
    "Copyright (c) 2006, 2009, 2011, 2012, 2013, 2017 Dan Vanderkam and other contributors. Permission is hereby "
    "granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the "
    "\"Software\"), to deal in the Software without restriction, including without limitation the rights to use, copy, "
    "modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom "
    "the Software is furnished to do so, subject to the following conditions: The above copyright notice and this "
    "permission notice shall be included in all copies or substantial portions of the Software. THE SOFTWARE IS "
    "PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES "
    "OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR "
    "COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR "
    "OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.";

std::string library_of(const Frame& frame) { return frame.has_charts ? dygraphs_script() : std::string(); }

std::string head(const Frame& frame) {
  const std::string style = (frame.has_charts ? dygraphs_style() : std::string()) + page_style();
  const std::string library = library_of(frame);
  const std::string script = page_script();
  const std::string scripts = library.empty() ? policy_hash(script) : policy_hash(library) + ' ' + policy_hash(script);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; script-src {}; img-src "
      "data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<link rel=\"icon\" "
      "href=\"data:,\">\n<style>{}</style>\n</head>\n",
      policy_hash(style), scripts, escaped(frame.title), style);
}

std::string footer(const Frame& frame) {
  if (library_of(frame).empty()) return "";
  return fmt::format(
      "<footer>\n<details><summary>Charts by dygraphs, under the MIT licence</summary>\n<p>{}</p></details>\n"
      "</footer>\n",
      escaped(dygraphs_licence));
}

std::string scripts(const Frame& frame) {
  const std::string library = library_of(frame);
  std::string text;
  if (!library.empty()) text += "<script>" + library + "</script>\n";
  return text + "<script>" + page_script() + "</script>\n";
}

}  // namespace

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

std::string folded(const std::string& summary, const std::string& content) {
  return fmt::format("<details class=\"folded\"><summary>{}</summary>\n{}</details>\n", summary, content);
}

std::string framed(const Frame& frame, const std::string& content) {
  return head(frame) +
         fmt::format(
             "<body>\n<a class=\"skip\" href=\"#main\">To the results</a>\n<header>\n<h1>{}</h1>\n</header>\n<main "
             "id=\"main\">\n",
             escaped(frame.title)) +
         content + "</main>\n" + footer(frame) + scripts(frame) + "</body>\n</html>\n";
}

}  // namespace rocking::analysis

#include "rocking/text/json.hpp"

#include <algorithm>
#include <cctype>
#include <list>
#include <string>
#include <unordered_set>
#include <utility>

namespace rocking {
namespace {

constexpr std::size_t most_repeated = 20;
constexpr std::size_t deepest = 32;  // our formats need 5; unbounded nesting would exhaust the stack

std::string place_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position == 0 ? 0 : std::min(position - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto newline = before.rfind('\n');
  const auto column = 1 + (newline == std::string_view::npos ? before.size() : before.size() - newline - 1);
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Whether `text` starts with a word, in any case and with any sign.
bool begins_with_word(std::string_view text, std::string_view word) {
  if (text.starts_with('-')) text.remove_prefix(1);
  if (text.size() < word.size()) return false;
  return std::equal(word.begin(), word.end(), text.begin(), [](char expected, char actual) {
    return expected == static_cast<char>(std::tolower(static_cast<unsigned char>(actual)));
  });
}

// The word or number around a position; empty at the end of the text.
std::string_view word_at(std::string_view text, std::size_t position) {
  const auto belongs = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
  };
  if (position >= text.size()) return {};
  std::size_t start = position;
  while (start > 0 && belongs(text[position]) && belongs(text[start - 1])) --start;
  std::size_t end = position;
  while (end < text.size() && belongs(text[end])) ++end;
  return text.substr(start, std::min<std::size_t>(40, std::max(end, position + 1) - start));
}

// Builds the document from the parser's calls.
class DocumentBuilder final : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(std::string_view text, std::vector<base::Problem>& problems) : text_(text), problems_(problems) {}

  Json take() { return std::move(root_); }

  bool null() override { return put(Json()); }
  bool boolean(bool value) override { return put(Json(value)); }
  bool number_integer(number_integer_t value) override { return put(Json(value)); }
  bool number_unsigned(number_unsigned_t value) override { return put(Json(value)); }
  bool number_float(number_float_t value, const string_t&) override { return put(Json(value)); }
  bool string(string_t& value) override { return put(Json(value)); }
  bool binary(binary_t&) override { return false; }  // not in text

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Frame& frame = open_.back();
    frame.key = name;
    frame.is_rerun = !frame.keys.insert(name).second;
    if (frame.is_rerun && repeated_++ < most_repeated) {
      problems_.push_back({pointer(), "", "this key occurs twice", "keep one of them"});
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
    const std::string_view word = word_at(text_, position == 0 ? 0 : position - 1);
    base::Problem problem{place_of(text_, position), std::string(word), "", ""};
    const bool is_no_number = begins_with_word(word, "nan") || begins_with_word(word, "inf");
    const std::string key = pointer();
    if ((is_no_number || error.id == 406) && !key.empty()) problem.place = key + " (" + problem.place + ")";
    if (is_no_number) {
      problem.reason = "not a number that JSON allows";
      problem.remedy = "give a finite number, or omit the key";
    } else if (error.id == 406) {
      problem.reason = "exceeds the largest double, 1.8e308, in absolute value";
      problem.remedy = "give a finite number";
    } else if (explain_character(position, problem)) {
      return refuse(std::move(problem));
    } else {
      problem.reason = "not JSON: " + explanation_in(error.what());
      problem.remedy = "look for a missing or superfluous comma, quote or bracket before it";
    }
    return refuse(std::move(problem));
  }

 private:
  static bool refuse(base::Problem problem) { throw base::InputError(std::move(problem)); }

  /// Of characters that word processors and people of other languages write: the reason, and what to write.
  bool explain_character(std::size_t position, base::Problem& problem) const {
    const std::size_t place = position == 0 ? 0 : position - 1;
    // The parser stops behind the first byte of a character that is not ASCII, or at its end.
    const std::string_view around = text_.substr(place >= 2 ? place - 2 : 0, 5);
    for (const std::string_view quote : {"\u201C", "\u201D", "\u201E", "\u2018", "\u2019", "\u00AB", "\u00BB"}) {
      if (around.find(quote) == std::string_view::npos) continue;
      problem.value = quote;
      problem.reason = "a curly quotation mark, which JSON does not have";
      problem.remedy = "write the straight one, \"; a word processor has changed it";
      return true;
    }
    if (place < text_.size() && text_[place] == '\'') {
      problem.reason = "a single quotation mark, which JSON does not have";
      problem.remedy = "write double ones: \"block\"";
      return true;
    }
    const std::string_view before = text_.substr(0, std::min(place, text_.size()));
    const std::size_t comma = before.find_last_not_of("0123456789.eE+-");
    const bool is_digit_before = comma != std::string_view::npos && comma > 0 && before[comma] == ',' &&
                                 std::isdigit(static_cast<unsigned char>(before[comma - 1])) != 0;
    const bool is_digit_behind = comma != std::string_view::npos && comma + 1 < text_.size() &&
                                 std::isdigit(static_cast<unsigned char>(text_[comma + 1])) != 0;
    if (!is_digit_before || !is_digit_behind) return false;
    problem.reason = "a decimal comma, which JSON does not have";
    problem.remedy = "write a point: 0.35";
    return true;
  }

  struct Frame {
    Json* node;
    std::string key;
    bool is_rerun = false;  ///< the key has a value already
    /// Of an object; the search for a key in the document takes linear time.
    std::unordered_set<std::string> keys = {};
  };

  // The message of the parser without its number, its place and the last token.
  static std::string explanation_in(std::string_view message) {
    if (const auto column = message.find("column "); column != std::string_view::npos) {
      if (const auto colon = message.find(": ", column); colon != std::string_view::npos)
        message.remove_prefix(colon + 2);
    }
    message = message.substr(0, message.find("; last read"));
    return std::string(message);
  }

  bool put(Json value) {
    static_cast<void>(attach(std::move(value)));
    return true;
  }

  Json* attach(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Frame& parent = open_.back();
    if (parent.node->is_array()) {
      parent.node->push_back(std::move(value));
      return &parent.node->back();
    }
    if (parent.is_rerun) return &dropped_.emplace_back(std::move(value));  // read and discarded
    auto& members = parent.node->get_ref<Json::object_t&>();
    members.emplace_back(parent.key, std::move(value));
    return &members.back().second;
  }

  bool open(Json container) {
    if (open_.size() >= deepest) {
      throw base::InputError(
          {pointer(), "", "nested more deeply than any format of rocking", "see `rocking schema experiment`"});
    }
    open_.push_back({attach(std::move(container)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// Pointer to the next value, which is not yet in the innermost list.
  std::string pointer() const {
    std::string place;
    for (const Frame& frame : open_) {
      const bool in_list = frame.node->is_array();
      const std::size_t next = frame.node->size();
      place = child_pointer(place, in_list ? std::to_string(&frame == &open_.back() ? next : next - 1) : frame.key);
    }
    return place;
  }

  std::string_view text_;
  std::vector<base::Problem>& problems_;
  Json root_;
  std::list<Json> dropped_;  // a list, because open frames point into it
  std::vector<Frame> open_;
  std::size_t repeated_ = 0;
};

}  // namespace

Json parse_json(std::string_view text, std::vector<base::Problem>& problems) {
  // The parser would treat it as the end of the text.
  if (const std::size_t position = text.find('\0'); position != std::string_view::npos) {
    throw base::InputError({place_of(text, position + 1), "", "a NUL byte, which JSON does not allow",
                            "remove it; the file may be damaged, or not be text in UTF-8"});
  }
  DocumentBuilder builder(text, problems);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

Json parse_json(std::string_view text) {
  std::vector<base::Problem> problems;
  Json json = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return json;
}

std::string child_pointer(std::string_view parent, std::string_view key) {
  std::string pointer(parent);
  pointer += '/';
  for (const char c : key) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      pointer += c;
    }
  }
  return pointer;
}

std::string last_key(std::string_view pointer) { return std::string(pointer.substr(pointer.rfind('/') + 1)); }

std::string brief(const Json& value) {
  constexpr std::size_t longest = 60;
  if (value.is_string() && value.get_ref<const std::string&>().size() > longest) {
    // Only the beginning, because the rest may be many megabytes.
    const std::string start = value.get_ref<const std::string&>().substr(0, longest);
    return Json(start).dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, longest - 3) + "...";
  }
  // ASCII only, so that the cut does not split a character.
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > longest) text = text.substr(0, longest - 3) + "...";
  return text;
}

std::string_view kind_name(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null: return "null";
    case Json::value_t::boolean: return "true or false";
    case Json::value_t::string: return "text";
    case Json::value_t::array: return "a list";
    case Json::value_t::object: return "an object";
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
    case Json::value_t::number_float: return "a number";
    case Json::value_t::binary:
    case Json::value_t::discarded: break;
  }
  return "no JSON value";
}

}  // namespace rocking

#include "rocking/text/locate.hpp"

#include <algorithm>
#include <utility>

#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// The keys of a JSON pointer, their escapes resolved (RFC 6901). What stands before the first slash is no key.
std::vector<std::string> keys_of(std::string_view pointer) {
  std::vector<std::string> keys;
  for (std::size_t i = std::min(pointer.find('/'), pointer.size()); i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      keys.emplace_back();
    } else if (pointer[i] == '~' && i + 1 < pointer.size()) {
      keys.back() += pointer[++i] == '1' ? '/' : '~';
    } else {
      keys.back() += pointer[i];
    }
  }
  return keys;
}

/// Scans the text of a document without building values. The scan ends early if the text is not JSON.
class TextWalk {
 public:
  explicit TextWalk(std::string_view text) : text_(text) {}

  /// Positions of the members with this key of the value at `start`: of the key, and of the value.
  struct Member {
    std::size_t key;
    std::size_t value;
  };
  [[nodiscard]] std::vector<Member> members(std::size_t start, const std::string& key) {
    std::vector<Member> found;
    at_ = start;
    skip_blanks();
    if (at_ >= text_.size() || (text_[at_] != '{' && text_[at_] != '[')) return found;
    const bool is_list = text_[at_++] == '[';
    for (std::size_t index = 0; next_item(); ++index) {
      const std::size_t place = at_;
      bool matches = is_list && std::to_string(index) == key;
      if (!is_list) {
        matches = is_string(key);
        skip_blanks();
        if (at_ < text_.size()) ++at_;  // the colon
        skip_blanks();
      }
      if (matches) found.push_back({.key = place, .value = at_});
      skip_value();
    }
    return found;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  bool next_item() {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == ',') ++at_;
    skip_blanks();
    return at_ < text_.size() && text_[at_] != '}' && text_[at_] != ']';
  }

  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  void skip_value() {
    int depth = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (depth == 0 && (c == ',' || c == '}' || c == ']')) return;
      if (c == '"') {
        skip_string();
        continue;
      }
      depth += (c == '{' || c == '[') ? 1 : (c == '}' || c == ']') ? -1 : 0;
      ++at_;
    }
  }

  /// Skips a string; returns whether it is this key.
  bool is_string(const std::string& key) {
    const std::size_t begin = at_;
    skip_string();
    const std::string_view token = text_.substr(begin, at_ - begin);
    if (token.find('\\') == std::string_view::npos) {
      return token.size() == key.size() + 2 && token.substr(1, key.size()) == key;
    }
    const Json value = Json::parse(token, nullptr, false);
    return value.is_string() && value.get_ref<const std::string&>() == key;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::size_t line_at(std::string_view text, std::size_t position) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, position), '\n'));
}

bool is_of_the_text(const std::string& place) {
  if (place.find(", line ") != std::string::npos) return false;  // in a ground motion
  return place.starts_with('/') || place.starts_with("line ") || place == "the file";
}

}  // namespace

std::vector<std::size_t> lines_of(std::string_view text, std::string_view pointer) {
  TextWalk walk(text);
  std::size_t value = 0;
  std::size_t place = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::vector<std::string> keys = keys_of(pointer);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto found = walk.members(value, keys[i]);
    if (found.empty()) break;
    if (i + 1 == keys.size()) {
      std::vector<std::size_t> lines;
      for (const auto& member : found) {
        const std::size_t line = line_at(text, member.key);
        if (lines.empty() || lines.back() != line) lines.push_back(line);
      }
      return lines;
    }
    place = found.front().key;
    value = found.front().value;
  }
  return {line_at(text, place)};
}

base::InputError located(const base::InputError& error, std::string_view text, const std::string& file) {
  std::vector<base::Problem> problems = error.problems();
  for (base::Problem& problem : problems) {
    if (!is_of_the_text(problem.place)) continue;
    problem.where = file;
    if (!problem.place.starts_with('/') || problem.place.ends_with(')')) continue;  // has its line already
    const auto lines = lines_of(text, problem.place);
    problem.where += lines.size() > 1 ? ", lines " : ", line ";
    constexpr std::size_t most_listed = 5;
    for (std::size_t i = 0; i < std::min(most_listed, lines.size()); ++i) {
      problem.where += (i == 0 ? "" : ", ") + std::to_string(lines[i]);
    }
    if (lines.size() > most_listed) problem.where += ", ...";
  }
  return base::InputError(std::move(problems));
}

}  // namespace rocking

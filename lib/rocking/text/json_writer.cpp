#include "rocking/text/json_writer.hpp"

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

constexpr std::size_t indent = 2;

}  // namespace

void JsonWriter::element(const Json& value) {
  begin_line();
  put(value);
}

void JsonWriter::line(const Json& value) {
  begin_line();
  (*sink_)(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void JsonWriter::member(std::string_view key, const Json& value) {
  put_key(key);
  put(value);
}

void JsonWriter::begin_object() {
  begin_line();
  open('{', '}');
}

void JsonWriter::begin_object(std::string_view key) {
  put_key(key);
  open('{', '}');
}

void JsonWriter::begin_list(std::string_view key) {
  put_key(key);
  open('[', ']');
}

void JsonWriter::end() {
  ROCKING_EXPECT(!levels_.empty() && !levels_.back().is_empty);
  const char closing = levels_.back().closing;
  levels_.pop_back();
  (*sink_)('\n' + std::string(indent * levels_.size(), ' ') + closing);
}

void JsonWriter::begin_line() {
  if (levels_.empty()) return;
  (*sink_)((levels_.back().is_empty ? "\n" : ",\n") + std::string(indent * levels_.size(), ' '));
  levels_.back().is_empty = false;
}

void JsonWriter::put_key(std::string_view key) {
  begin_line();
  (*sink_)(Json(key).dump() + ": ");
}

// A dump has line breaks between values only, since those within a text are written as \n. The next line is indented.
void JsonWriter::put(const Json& value) {
  const std::string text = value.dump(static_cast<int>(indent), ' ', false, Json::error_handler_t::replace);
  const std::string line_break = '\n' + std::string(indent * levels_.size(), ' ');
  std::string placed;
  placed.reserve(2 * text.size());
  for (const char c : text) {
    if (c == '\n') {
      placed += line_break;
    } else {
      placed += c;
    }
  }
  (*sink_)(placed);
}

void JsonWriter::open(char bracket, char closing) {
  (*sink_)(std::string_view(&bracket, 1));
  levels_.push_back({.closing = closing});
}

}  // namespace rocking

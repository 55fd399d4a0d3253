#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "rocking/text/json.hpp"

namespace rocking {

/// Receives a text in pieces.
using TextSink = std::function<void(std::string_view)>;

/// Writes a JSON document that is too large for memory, value by value. But for lines the bytes are those of
/// Json::dump(2), with U+FFFD in place of bytes that are no UTF-8.
class JsonWriter {
 public:
  explicit JsonWriter(const TextSink& sink) : sink_(&sink) {}

  /// The next value of the innermost list.
  void element(const Json& value);
  /// The same on one line.
  void line(const Json& value);
  /// The next value of the innermost object.
  void member(std::string_view key, const Json& value);

  void begin_object();
  void begin_object(std::string_view key);
  void begin_list(std::string_view key);
  /// Ends the innermost object or list. It has at least one value.
  void end();

 private:
  void begin_line();
  void put_key(std::string_view key);
  void put(const Json& value);
  void open(char bracket, char closing);

  struct Level {
    char closing;
    bool is_empty = true;
  };
  const TextSink* sink_;
  std::vector<Level> levels_;
};

}  // namespace rocking

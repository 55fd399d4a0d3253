#include "rocking/text/json.hpp"

namespace rocking {

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

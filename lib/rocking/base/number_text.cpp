#include "rocking/base/number_text.hpp"

#include <charconv>
#include <system_error>

#include "rocking/base/error.hpp"

namespace rocking::base {
namespace {
constexpr std::size_t longest =
    128;  // more than a double has in the shorter notation with any sensible number of digits
}

std::string significant(double number, int digits) {
  char text[longest];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

std::string shortest(double number) {
  char text[longest];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

}  // namespace rocking::base

#include "terminal.hpp"

#include <cstdlib>
#include <string_view>

#include <langinfo.h>
#include <locale.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace rocking::program {
namespace {

constexpr std::size_t usual_columns = 80;

/// Letters that the locale of the environment supports. The process itself stays in the "C" locale, with decimal
/// points.
Letters letters_of_locale() {
  const locale_t locale = newlocale(LC_CTYPE_MASK, "", nullptr);
  if (locale == nullptr) return Letters::ascii;
  const bool unicode = std::string_view(nl_langinfo_l(CODESET, locale)) == "UTF-8";
  freelocale(locale);
  return unicode ? Letters::unicode : Letters::ascii;
}

}  // namespace

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::optional<std::size_t> terminal_columns(int descriptor) {
  winsize size{};
  const bool is_known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? std::optional<std::size_t>(size.ws_col) : std::nullopt;
}

TableLook table_look() {
  if (isatty(STDOUT_FILENO) != 1) return {};
  return {.width = terminal_columns(STDOUT_FILENO).value_or(usual_columns), .bars = letters_of_locale()};
}

}  // namespace rocking::program

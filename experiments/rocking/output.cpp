#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <langinfo.h>
#include <locale.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "exit_code.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

// DEL, controls of writing direction, and the control characters of Unicode from U+0080 to U+009F. Other text than JSON
// has been made printable before; in JSON they stand in strings only, and escaped they mean the same.
std::string with_escaped_controls(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    if (text[i] == '\x7f') {
      escaped += "\\u007f";
    } else if (text[i] == '\xc2' && next >= 0x80 && next < 0xa0) {
      escaped += fmt::format("\\u{:04x}", next);
      ++i;
    } else if (const std::string direction = base::direction_control_at(text, i); !direction.empty()) {
      escaped += direction;
      i += text[i] == '\xd8' ? 1 : 2;
    } else {
      escaped += text[i];
    }
  }
  return escaped;
}

constexpr std::size_t usual_columns = 80;

/// Printable; on a terminal with lines broken between words.
std::string shown_on(int descriptor, std::string_view text) {
  const std::string shown = base::printable(text);
  return isatty(descriptor) == 1 ? wrapped(shown, terminal_columns(descriptor).value_or(usual_columns)) : shown;
}

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

void add_loudness(CLI::App& command, Loudness& loudness) {
  command.add_flag("--json", loudness.json, "Print the result as JSON on standard output, and nothing else there");
  const auto quiet = command.add_flag("-q,--quiet", loudness.quiet, "Print only results and errors");
  command.add_flag("-v,--verbose", loudness.verbose, "Print more details of the work")->excludes(quiet);
  command.add_flag("--no-progress", loudness.no_progress, "Show no progress on standard error");
}

void add_extent(CLI::App& command, Extent& extent) {
  command.add_flag_callback(
      "--all", [&extent] { extent = Extent::all; }, "Print every row, also if there are more than a screen shows");
}

void print_result(std::string_view text) {
  print_result([text](const TextSink& sink) { sink(text); });
}

void print_result(const std::function<void(const TextSink& sink)>& write) {
  const auto expect = [](bool written) {
    if (!written) throw std::system_error(errno, std::generic_category(), "standard output: cannot be written");
  };
  write([&](std::string_view piece) {
    const std::string shown = with_escaped_controls(piece);
    expect(std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size());
  });
  expect(std::fflush(stdout) == 0);
}

void print_written(const Loudness& loudness, const std::vector<std::string>& files, std::string above) {
  for (const std::string& file : files) above += file + '\n';
  loudness.json ? print_result(facts_text(std::vector<Fact>{{"written", files}})) : print_text(above);
}

void print_text(std::string_view text) { print_result(shown_on(STDOUT_FILENO, text)); }

void print_notice(std::string_view text) { print_aside(shown_on(STDERR_FILENO, fmt::format("rocking: {}\n", text))); }

void print_aside(const std::string& text) { static_cast<void>(std::fputs(text.c_str(), stderr)); }

std::string listed_problems(const base::InputError& error) {
  std::string text = counted(error.problems().size(), "problem");
  for (const base::Problem& problem : error.problems()) text += "\n  " + to_string(problem);
  return text;
}

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

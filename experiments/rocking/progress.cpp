#include "progress.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "output.hpp"
#include "rocking/text/number_text.hpp"
#include "terminal.hpp"

namespace rocking::program {
namespace {

constexpr std::size_t longest_bar = 24;
constexpr std::size_t shortest_bar = 6;

constexpr std::chrono::milliseconds interval_of(ProgressStyle style) {
  return style == ProgressStyle::rewritten_line ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
}

/// Width of standard error if it is a terminal; 80 if it is not known.
std::size_t columns() { return terminal_columns(STDERR_FILENO).value_or(80); }

/// no-color.org: any value but an empty one turns colour off.
bool wants_colour() { return environment("NO_COLOR").empty(); }

std::string bar(const Pace& pace, std::size_t length) {
  const double part =
      pace.all == 0 ? (pace.done > 0 ? 0.0 : 1.0) : static_cast<double>(pace.done) / static_cast<double>(pace.all);
  const auto filled = std::min(length, static_cast<std::size_t>(part * static_cast<double>(length)));
  std::string text(length, ' ');
  std::fill_n(text.begin(), filled, '=');
  if (filled < length) text[filled] = '>';
  return text;
}

/// At most `length` bytes; no character is cut in two.
std::string cut(std::string text, std::size_t length) {
  if (text.size() <= length) return text;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
  text.resize(length);
  return text;
}

/// The words take precedence over the bar. The last column stays free because some terminals break the line there.
void rewrite_line(const Pace& pace, const std::string& words) {
  constexpr std::size_t frame = 3;
  const std::size_t width = columns() - 1;
  const std::size_t room = width - std::min(width, words.size() + frame);
  const std::size_t length = std::clamp(room, shortest_bar, longest_bar);
  if (width < 3 * length) {
    print_aside("\r" + cut(words, width) + "\x1b[K");
  } else {
    const std::string_view on = wants_colour() ? "\x1b[32m" : "";
    const std::string_view off = wants_colour() ? "\x1b[0m" : "";
    print_aside(fmt::format("\r[{}{}{}] {}\x1b[K", on, bar(pace, length), off, cut(words, width - length - frame)));
  }
}

}  // namespace

ProgressStyle suitable_progress_style(const Loudness& loudness) {
  if (loudness.quiet || loudness.no_progress) return ProgressStyle::none;
  const bool rewrites = isatty(STDERR_FILENO) == 1 && environment("TERM") != "dumb";
  return rewrites ? ProgressStyle::rewritten_line : ProgressStyle::log_lines;
}

std::string progress_line(const Pace& pace, std::string_view noun) {
  const auto part = static_cast<double>(pace.done);
  const auto whole = static_cast<double>(pace.all);
  const bool is_open = pace.all == 0 && pace.done > 0;
  std::string line = fmt::format("{}/{}", pace.done, pace.all);
  if (is_open) {
    line = fmt::format("{} {} so far", pace.done, noun);
  } else if (!noun.empty()) {
    line =
        fmt::format("{} of {} {} ({:.1f} %)", pace.done, pace.all, noun, pace.all == 0 ? 100.0 : 100.0 * part / whole);
  }
  if (!pace.rate || *pace.rate <= 0.0) return line;
  const std::string rate = *pace.rate < 100.0 ? fmt::format("{:.3g}", *pace.rate) : fmt::format("{:.0f}", *pace.rate);
  line += fmt::format(", {}/s", rate);
  if (!is_open) line += fmt::format(", {} remaining", duration_in_words((whole - part) / *pace.rate));
  return line;
}

Progress::Progress(ProgressStyle style, std::string noun)
    : style_(style), noun_(std::move(noun)), start_(Clock::now()), next_(start_) {
  if (style_ == ProgressStyle::log_lines) next_ += interval_of(style_);
}

Progress::~Progress() {
  if (line_open_) print_aside("\r\x1b[K");  // leave the line as it was found
}

void Progress::show(std::uint64_t done, std::uint64_t all, const std::function<std::string()>& more) {
  if (!done_at_first_) {
    done_at_first_ = done;
    first_ = elapsed();
  }
  if (style_ == ProgressStyle::none || Clock::now() < next_) return;
  next_ = Clock::now() + interval_of(style_);
  const Pace reached = pace(done, all);
  const bool is_short = style_ == ProgressStyle::rewritten_line && all > 0;
  std::string words = progress_line(reached, is_short ? "" : noun_);
  if (const std::string also = more ? more() : ""; !also.empty()) words += "; " + also;
  if (style_ == ProgressStyle::rewritten_line) {
    rewrite_line(reached, words);
    line_open_ = true;
  } else {
    print_aside(words + "\n");
  }
}

double Progress::elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

Pace Progress::pace(std::uint64_t done, std::uint64_t all) {
  Pace pace{.done = done, .all = all, .rate = {}};
  const double time = elapsed() - first_;
  const std::uint64_t since = done - std::min(done, *done_at_first_);
  if (time > 0.0 && since > 0) pace.rate = static_cast<double>(since) / time;
  return pace;
}

}  // namespace rocking::program

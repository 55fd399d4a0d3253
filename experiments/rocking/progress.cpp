#include "progress.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "interrupt.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

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
  const double part = pace.all == 0 ? 1.0 : static_cast<double>(pace.done) / static_cast<double>(pace.all);
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

/// Whether it is known how much there is to do.
bool is_end_known(const Pace& pace, const Counted& counted) {
  return counted.then.empty() && (pace.all > 0 || pace.done == 0);
}

/// The words take precedence over the bar. The last column stays free because some terminals break the line there.
void rewrite_line(const Pace& pace, bool has_end, const std::string& words) {
  constexpr std::size_t frame = 3;
  const std::size_t width = columns() - 1;
  const std::size_t room = width - std::min(width, words.size() + frame);
  const std::size_t length = std::clamp(room, shortest_bar, longest_bar);
  if (!has_end || width < 3 * length) {
    print_aside("\r" + cut(words, width) + "\x1b[K");
  } else {
    const std::string_view on = wants_colour() ? "\x1b[32m" : "";
    const std::string_view off = wants_colour() ? "\x1b[0m" : "";
    print_aside(fmt::format("\r[{}{}{}] {}\x1b[K", on, bar(pace, length), off, cut(words, width - length - frame)));
  }
}

constexpr std::chrono::seconds between_notes(5);

}  // namespace

ProgressStyle suitable_progress_style(const Loudness& loudness) {
  if (loudness.quiet || loudness.no_progress) return ProgressStyle::none;
  const bool rewrites = isatty(STDERR_FILENO) == 1 && environment("TERM") != "dumb";
  return rewrites ? ProgressStyle::rewritten_line : ProgressStyle::log_lines;
}

std::string progress_line(const Pace& pace, const Counted& counted, bool is_short) {
  const auto part = static_cast<double>(pace.done);
  const auto whole = static_cast<double>(pace.all);
  const bool counts_next = pace.all == 0 && !counted.then.empty();
  const bool has_end = is_end_known(pace, counted);
  std::string line = fmt::format("{}/{}", pace.done, pace.all);
  if (counts_next) {
    line = fmt::format("{} {}", pace.done, counted.then);
  } else if (pace.all == 0 && !has_end) {
    line = fmt::format("{} {} so far", pace.done, counted.noun);
  } else if (!is_short) {
    line = fmt::format("{} of {} {}", pace.done, pace.all, counted.noun);
    if (has_end) line += fmt::format(" ({:.1f} %)", pace.all == 0 ? 100.0 : 100.0 * part / whole);
  }
  if (!pace.rate || *pace.rate <= 0.0) {
    line += ", " + duration_in_words(pace.elapsed) + " elapsed";
  } else {
    line += *pace.rate < 100.0 ? fmt::format(", {:.3g}/s", *pace.rate) : fmt::format(", {:.0f}/s", *pace.rate);
    if (has_end) line += fmt::format(", {} remaining", duration_in_words((whole - part) / *pace.rate));
  }
  return counts_next || counted.then.empty() ? line : line + "; then " + counted.then;
}

Progress::Progress(ProgressStyle style, std::string noun, std::string then)
    : style_(style), counted_{std::move(noun), std::move(then)}, start_(Clock::now()), next_(start_) {
  if (style_ == ProgressStyle::none) return;
  if (style_ == ProgressStyle::log_lines) next_ += interval_of(style_);
  printer_ = std::thread([this] { keep_printing(); });
}

Progress::~Progress() {
  if (printer_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      has_ended_ = true;
    }
    ended_.notify_one();
    printer_.join();
  }
  if (line_open_) print_aside("\r\x1b[K");  // leave the line as it was found
}

void Progress::show(std::uint64_t done, std::uint64_t all, const std::function<std::string()>& more) {
  const std::lock_guard lock(mutex_);
  const bool counts_another = done_at_first_ && all == 0 && all_ > 0;
  if (!done_at_first_ || counts_another) {
    done_at_first_ = counts_another ? 0 : done;
    first_ = elapsed();
  }
  done_ = done;
  all_ = all;
  if (!is_due()) return;
  more_ = more ? more() : "";
  print();
}

/// A realisation may take longer than the time between two lines; without it nothing shows that the program works.
void Progress::keep_printing() {
  constexpr std::chrono::milliseconds look(500);
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, look, [this] { return has_ended_; })) {
    if (done_at_first_ && is_due()) print();
  }
}

void Progress::print() {
  next_ = Clock::now() + interval_of(style_);
  const Pace reached = pace();
  std::string words = progress_line(reached, counted_, style_ == ProgressStyle::rewritten_line);
  if (!more_.empty()) words += "; " + more_;
  if (style_ == ProgressStyle::rewritten_line) {
    rewrite_line(reached, is_end_known(reached, counted_), words);
    line_open_ = true;
  } else {
    print_aside(words + "\n");
  }
}

double Progress::elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

Pace Progress::pace() const {
  Pace pace{.done = done_, .all = all_, .rate = {}, .elapsed = elapsed()};
  const double time = pace.elapsed - first_;
  const std::uint64_t since = done_ - std::min(done_, *done_at_first_);
  if (time > 0.0 && since > 0) pace.rate = static_cast<double>(since) / time;
  return pace;
}

Execution watched(const ExecutionOptions& options, Progress& progress) {
  const auto show = [&progress](std::uint64_t done, std::uint64_t all) {
    progress.show(done, all);
    return Decision::proceed;
  };
  return {.threads = options.threads, .on_progress = show, .stop = &stop_on_interrupt()};
}

ProgressFile::ProgressFile(std::filesystem::path path) : path_(std::move(path)), start_(Clock::now()), next_(start_) {}

ProgressFile::~ProgressFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void ProgressFile::note(std::uint64_t done, std::uint64_t all) {
  if (!done_before_) done_before_ = done;
  if (done == all || Clock::now() < next_) return;  // after the last realisation the file is removed at once
  next_ = Clock::now() + between_notes;
  const ProgressNote note{.process = static_cast<std::uint64_t>(::getpid()),
                          .elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count(),
                          .done_before = *done_before_,
                          .done = done,
                          .all = all};
  try {
    write_atomically(path_, to_text(note));
  } catch (const std::system_error&) {
    // The disk is full or missing; the store reports that where it matters.
  }
}

}  // namespace rocking::program

#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "output.hpp"

namespace rocking::program {
namespace {

constexpr std::chrono::milliseconds interval_of(ProgressStyle style) {
  return style == ProgressStyle::rewritten_line ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
}

}  // namespace

Progress::Progress(ProgressStyle style) : style_(style), start_(Clock::now()), next_(start_ + interval_of(style)) {}

Progress::~Progress() {
  if (line_open_) fmt::print(stderr, "\r\x1b[K");  // leave the line as it was found
}

void Progress::show(std::uint64_t done, std::uint64_t all) {
  if (style_ == ProgressStyle::none || Clock::now() < next_) return;
  next_ = Clock::now() + interval_of(style_);
  const std::string line = progress_line(done, all, elapsed());
  if (style_ == ProgressStyle::rewritten_line) {
    fmt::print(stderr, "\r{}\x1b[K", line);
    line_open_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
}

double Progress::elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

std::string progress_line(std::uint64_t done, std::uint64_t all, double elapsed) {
  const auto part = static_cast<double>(done);
  const auto whole = static_cast<double>(all);
  std::string line =
      fmt::format("{} of {} realisations ({:.1f} %)", done, all, all == 0 ? 100.0 : 100.0 * part / whole);
  if (done == 0 || elapsed <= 0.0) return line;
  const double rate = part / elapsed;
  line += fmt::format(", {:.3g}/s, {} to go", rate, spoken_duration((whole - part) / rate));
  return line;
}

ProgressStyle suitable_progress_style() {
  return isatty(STDERR_FILENO) == 1 ? ProgressStyle::rewritten_line : ProgressStyle::log_lines;
}

}  // namespace rocking::program

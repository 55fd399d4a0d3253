#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "output.hpp"

namespace rocking::program {

enum class ProgressStyle : std::uint8_t {
  none,
  rewritten_line,  ///< on a terminal: one line, ten times a second
  log_lines,       ///< elsewhere: a line every ten seconds
};

/// The style that the options request and standard error can show.
[[nodiscard]] ProgressStyle suitable_progress_style(const Loudness& loudness);

/// State of a computation.
struct Pace {
  std::uint64_t done = 0;
  std::uint64_t all = 0;       ///< 0 beside a number done: not known yet
  std::optional<double> rate;  ///< [1/s]; absent before there is one
};

/// `1200 of 7600 realisations (15.8 %), 410/s, 15 s to go`; without a noun `1200/7600, 410/s, 15 s to go`.
[[nodiscard]] std::string progress_line(const Pace& pace, std::string_view noun);

/// Progress on standard error: amount done, rate, estimated time to go, and text of the caller. On a terminal a bar
/// precedes it, and the line is cut to the width of the terminal.
class Progress {
 public:
  /// `noun`: what is counted, in the plural.
  Progress(ProgressStyle style, std::string noun);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Prints the progress if it is due. `more` gives further text and is called only then; empty: none.
  void show(std::uint64_t done, std::uint64_t all, const std::function<std::string()>& more = nullptr);

  /// Time since construction [s].
  [[nodiscard]] double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// Rate of this session; work of an earlier session does not count.
  [[nodiscard]] Pace pace(std::uint64_t done, std::uint64_t all);

  ProgressStyle style_;
  std::string noun_;
  Clock::time_point start_;
  Clock::time_point next_;
  std::optional<std::uint64_t> done_at_first_;
  double first_ = 0.0;  ///< when `show` was first called [s]
  bool line_open_ = false;
};

}  // namespace rocking::program

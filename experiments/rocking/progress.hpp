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
  log_lines,       ///< elsewhere: a line each ten seconds
};

/// What suits standard error and was asked for.
[[nodiscard]] ProgressStyle suitable_progress_style(const Loudness& loudness);

/// How far a piece of work has come.
struct Pace {
  std::uint64_t done = 0;
  std::uint64_t all = 0;
  std::optional<double> rate;  ///< [1/s]; absent before there is one
};

/// `1200 of 7600 realisations (15.8 %), 410/s, 15 s to go`; without a noun `1200/7600, 410/s, 15 s to go`.
[[nodiscard]] std::string progress_line(const Pace& pace, std::string_view noun);

/// Progress on standard error: how much is done, rate, estimated time to go, and what the caller adds. On a terminal a bar
/// stands before it, and the line is cut to the terminal's width.
class Progress {
 public:
  /// `noun`: what is counted, in the plural.
  Progress(ProgressStyle style, std::string noun);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Tells how far it came, if it is time to. `more` is then asked what else there is to say; empty: nothing.
  void show(std::uint64_t done, std::uint64_t all, const std::function<std::string()>& more = nullptr);

  /// Since it was made [s].
  [[nodiscard]] double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// Of this session: what an earlier one did took none of its time.
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

#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace rocking::program {

enum class ProgressStyle : std::uint8_t {
  none,
  rewritten_line,  ///< on a terminal: one line, ten times a second
  log_lines,       ///< elsewhere: a line each ten seconds
};

/// Progress on standard error, with rate and estimated time to go.
class Progress {
 public:
  explicit Progress(ProgressStyle style);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void show(std::uint64_t done, std::uint64_t all);

  /// Since it was made [s].
  [[nodiscard]] double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;

  ProgressStyle style_;
  Clock::time_point start_;
  Clock::time_point next_;
  bool line_open_ = false;
};

/// `1200 of 7600 realisations (15.8 %), 410/s, 15 s to go`.
[[nodiscard]] std::string progress_line(std::uint64_t done, std::uint64_t all, double elapsed);

/// What suits standard error.
[[nodiscard]] ProgressStyle suitable_progress_style();

}  // namespace rocking::program

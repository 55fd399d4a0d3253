#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "arguments.hpp"
#include "rocking/api/run.hpp"
#include "rocking/output/progress_note.hpp"

namespace rocking::program {

enum class ProgressStyle : std::uint8_t {
  none,
  rewritten_line,  ///< on a terminal: one line, ten times a second
  log_lines,       ///< elsewhere: a line every ten seconds
};

/// The style that the options request and standard error can show.
[[nodiscard]] ProgressStyle suitable_progress_style(const Loudness& loudness);

/// What is counted, in the plural.
struct Counted {
  std::string noun;
  std::string then = {};  ///< counted after it, up to a number that is not known; empty: nothing
};

/// State of a computation.
struct Pace {
  std::uint64_t done = 0;
  std::uint64_t all = 0;       ///< 0 beside a number done: how many there will be is not known
  std::optional<double> rate;  ///< [1/s]; absent before there is one
  double elapsed = 0.0;        ///< [s]
};

/// `1200 of 7600 realisations (15.8 %), 410/s, 15 s remaining`, or `1200/7600, ...` where `is_short`; before there is a
/// rate the time since the start; `1200 realisations so far, 410/s` where their number is not known. Where something is
/// counted `then`, neither a share nor a time remaining is known:
/// `3 of 6 conditions, 0.1/s; then points of branches`, and later `240 points of branches, 12/s`.
[[nodiscard]] std::string progress_line(const Pace& pace, const Counted& counted, bool is_short);

/// Progress on standard error: amount done, rate, estimated time to go, and text of the caller. On a terminal a bar
/// precedes it, and the line is cut to the width of the terminal. A thread prints it also while nothing is finished.
class Progress {
 public:
  /// As Counted.
  Progress(ProgressStyle style, std::string noun, std::string then = {});
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
  [[nodiscard]] Pace pace() const;
  [[nodiscard]] bool is_due() const { return style_ != ProgressStyle::none && Clock::now() >= next_; }
  void print();
  void keep_printing();

  ProgressStyle style_;
  Counted counted_;
  Clock::time_point start_;
  std::mutex mutex_;  ///< of what follows
  Clock::time_point next_;
  std::uint64_t done_ = 0, all_ = 0;
  std::string more_;
  std::optional<std::uint64_t> done_at_first_;
  double first_ = 0.0;  ///< when `show` was first called for what is counted now [s]
  bool line_open_ = false;
  bool has_ended_ = false;
  std::condition_variable ended_;
  std::thread printer_;  ///< none without a style
};

/// How a study of the library is carried out: on the threads that are asked for, with a line of progress, until Ctrl-C.
[[nodiscard]] Execution watched(const ExecutionOptions& options, Progress& progress);

/// Keeps a file with the progress of a run for `rocking run --status`, rewritten every few seconds and removed by the
/// destructor. If it cannot be written, the run continues without it.
class ProgressFile {
 public:
  explicit ProgressFile(std::filesystem::path path);
  ProgressFile(const ProgressFile&) = delete;
  ProgressFile& operator=(const ProgressFile&) = delete;
  ~ProgressFile();

  /// Of `all` realisations `done` are done.
  void note(std::uint64_t done, std::uint64_t all);

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path path_;
  Clock::time_point start_;
  Clock::time_point next_;
  std::optional<std::uint64_t> done_before_;
};

}  // namespace rocking::program

#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "rocking/output/progress_note.hpp"

namespace rocking::program {

/// Keeps a file with the progress of a run for `rocking status`, rewritten every few seconds and removed by the
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

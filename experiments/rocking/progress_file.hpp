#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "rocking/report/progress_note.hpp"

namespace rocking::program {

/// Keeps a note of how far a run has come in a file, rewritten every few seconds, for `rocking status`; gone with the object.
/// A note that cannot be written is left out: it is not worth a run.
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

#pragma once

#include <filesystem>

namespace rocking {

/// Names of a run's files within a folder.
struct RunFiles {
  std::filesystem::path folder;

  [[nodiscard]] std::filesystem::path store() const { return folder / "realisations.sqlite"; }
  [[nodiscard]] std::filesystem::path report() const { return folder / "report.json"; }
  [[nodiscard]] std::filesystem::path page() const { return folder / "report.html"; }
  [[nodiscard]] std::filesystem::path progress() const { return folder / "progress.json"; }
};

/// A run that will replace the one in a folder. It is written into the subfolder `replacement`; the earlier run stays
/// unchanged until the new one is complete. A kill at any moment leaves the earlier run, the new one, or a subfolder
/// `replacement-complete` from which finish_installing() continues. The caller has claimed the folder.
class Replacement {
 public:
  explicit Replacement(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] std::filesystem::path path() const { return folder_ / "replacement"; }
  /// Whether a new run was begun and is not complete.
  [[nodiscard]] bool has_begun() const;
  /// Whether a process was killed between the first and the last step of install().
  [[nodiscard]] bool is_half_installed() const;

  /// Makes the subfolder, empty.
  void begin() const;
  void discard() const;
  /// Discards the subfolder if it has no store. Returns whether there was such a subfolder.
  [[nodiscard]] bool discard_unless_begun() const;
  /// Replaces the files of the earlier run by those of the new one. A page or report that the new run does not have is
  /// removed.
  void install() const;
  /// Completes an install() that was killed.
  void finish_installing() const;

 private:
  [[nodiscard]] std::filesystem::path complete() const { return folder_ / "replacement-complete"; }

  std::filesystem::path folder_;
};

}  // namespace rocking

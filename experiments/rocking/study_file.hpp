#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "output.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking::program {

/// The file in which a study leaves its numbers: `-o` names its folder, `--overwrite` permits to replace it.
class StudyFile {
 public:
  /// `label` precedes the path where it is printed.
  explicit StudyFile(std::string name, std::string label = "numbers")
      : name_(std::move(name)), label_(std::move(label)) {}

  void add_to(CLI::App& command, bool is_required);

  [[nodiscard]] bool is_asked() const { return !folder_.empty(); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / name_; }
  /// It may be replaced from now on.
  void permit_replacing() { overwrite_ = true; }
  /// Throws InTheWay if it, or another file of the study, exists and may not be replaced.
  void expect_free() const { expect_free(path()); }
  void expect_free(const std::filesystem::path& other) const { program::expect_free(other, overwrite_); }
  /// Before the work: expects that the file can be written, and creates the folder. No effect if no file is asked for.
  void prepare() const;
  /// Writes the file and gives the line that says so; empty if no file is asked for.
  [[nodiscard]] std::string write(std::string_view text) const;

 private:
  std::string name_;
  std::string label_;
  std::filesystem::path folder_;  ///< empty: nothing is written
  bool overwrite_ = false;
};

/// The title of an experiment over what is printed of it; empty without one.
[[nodiscard]] std::string heading(const Experiment& experiment);

/// Prints the result of a study: its JSON text, or what a reader gets.
void print_study(const Loudness& loudness, std::string_view json, std::string_view table);

}  // namespace rocking::program

#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "output.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/folder_lock.hpp"
#include "rocking/text/json.hpp"

namespace rocking::program {

/// The file in which a study leaves its numbers: `-o` names its folder, `--overwrite` permits to replace it.
class StudyFile {
 public:
  /// `label` precedes the path where it is printed.
  explicit StudyFile(std::string name, std::string label = "numbers")
      : name_(std::move(name)), label_(std::move(label)) {}

  void add_to(CLI::App& command, bool is_required);
  /// Adds `--resume`; `kept` is what the study goes on from.
  void add_resume(CLI::App& command, std::string_view kept);

  [[nodiscard]] bool is_asked() const { return !folder_.empty(); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / name_; }
  /// Whether the study goes on from the file, which is then replaced.
  [[nodiscard]] bool resumes() const { return resumes_; }
  /// Calls use(json) with what it holds. Problems get its name and the line, and how to begin anew.
  void read_earlier(const std::function<void(const Json&)>& use) const;
  /// Throws InTheWay if it, or another file of the study, exists and may not be replaced.
  void expect_free() const { expect_free(path()); }
  void expect_free(const std::filesystem::path& other) const;
  /// Before the work: expects that the file can be written, creates the folder, and excludes other processes that would
  /// write the file until the end of this object. Throws InTheWay if there is one. No effect if no file is asked for.
  void prepare();
  /// During the work: writes what is finished, at most every ten seconds. A file that an earlier call has left is not
  /// replaced by less. Errors are ignored: the work goes on, and the result may fit.
  void keep(const std::function<std::string()>& text);
  /// Writes the file and gives the line that says so; empty if no file is asked for.
  [[nodiscard]] std::string write(std::string_view text) const;

 private:
  std::string name_;
  std::string label_;
  std::filesystem::path folder_;  ///< empty: nothing is written
  bool overwrite_ = false;
  bool can_resume_ = false;
  bool resumes_ = false;
  bool keeps_ = false;
  std::chrono::steady_clock::time_point next_keep_;
  std::optional<FolderLock> lock_;
};

/// The title of an experiment over what is printed of it; empty without one.
[[nodiscard]] std::string heading(const Experiment& experiment);

/// Prints the result of a study: its JSON text, or what a reader gets.
void print_study(const Loudness& loudness, std::string_view json, std::string_view table);

/// Writes the result of a study to its files, and prints it with the lines that `write` gives. If `write` fails, the JSON
/// text is printed in any case, and then the error is thrown: what was computed is not lost.
void deliver_study(const Loudness& loudness, std::string_view json, std::string table,
                   const std::function<std::string()>& write);

}  // namespace rocking::program

#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// A run as one zip, which is an RO-Crate 1.1 (https://w3id.org/ro/crate/1.1): the files of its folder, its experiment, and
/// `ro-crate-metadata.json`, which tells what each file is, with its SHA-256.
namespace rocking::program {

/// Folder of the records in an archive.
inline constexpr const char* archived_records = "records";

/// Writes the archive of a finished run. The same folder gives the same bytes. Returns the names of the files in it, in
/// their order. An earlier archive is replaced. Throws MissingInput if there is no finished run or a record cannot be read,
/// UsageError if the name does not end with .zip or a record lies outside of the folder of the experiment, InTheWay if
/// another file has this name, and std::system_error with the path if the archive cannot be written.
std::vector<std::string> write_archive(const std::filesystem::path& folder, const std::filesystem::path& archive,
                                       bool with_records);

/// An archive, unpacked into a folder that is removed at the end.
class UnpackedArchive {
 public:
  /// Throws MissingInput if there is no such file, base::InputError if it is no archive of a run.
  explicit UnpackedArchive(const std::filesystem::path& archive);
  ~UnpackedArchive();
  UnpackedArchive(const UnpackedArchive&) = delete;
  UnpackedArchive& operator=(const UnpackedArchive&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Files that are not as the metadata state: changed, missing or added. If there are any, the run may be anything.
  [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> faults_;
};

}  // namespace rocking::program

#include "folder_check.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "progress.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

/// The studies in a folder that can be verified, beside the run or without one.
std::vector<const Study*> studies_in(const std::filesystem::path& folder) {
  std::vector<const Study*> found;
  for (const Study* study : studies()) {
    if (study->verification.verify != nullptr && std::filesystem::exists(folder / study->file)) found.push_back(study);
  }
  return found;
}

/// `rare.json or infer.json`.
std::string verified_files() {
  std::vector<std::string_view> files;
  for (const Study* study : studies()) {
    if (study->verification.verify != nullptr) files.push_back(study->file);
  }
  return fmt::format("{}", fmt::join(files, " or "));
}

void expect_finished_run(const RunFolder& folder, const VerifyRequest& request) {
  folder.expect_installed();
  if (!folder.has_report()) {
    throw MissingInput(fmt::format("{}: is missing, and there is no {}, so there is nothing to verify",
                                   folder.report_path().string(), verified_files()));
  }
  if (folder.has_store() || !request.sample) return;
  throw UsageError(folder.store_path().string() +
                   ": is missing, so there are no realisations for --sample; omit --sample");
}

}  // namespace

FolderCheck check_of(const VerifyRequest& request) {
  const std::filesystem::path path = request.folder;
  const RunFolder folder(path);
  FolderCheck all;
  const auto checked = [&](std::string_view units, const auto& verify) {
    Progress progress(suitable_progress_style(request.execution.loudness), std::string(units));
    return input_of([&] { return verify(path, request.sample, watched(request.execution, progress)); });
  };
  const std::vector<const Study*> found = studies_in(path);
  if (folder.has_report() || folder.has_store() || found.empty()) {
    expect_finished_run(folder, request);
    const auto verify_run = [](const auto&... asked) { return rocking::verify(asked...); };
    const RunCheck check = checked("realisations", verify_run);
    all.add(check, "realisations_run_again",
            fmt::format("{}: {} run again, all with the same bits; the report follows from them\n", request.name,
                        counted(check.checked, "realisation")));
  }
  for (const Study* study : found) {
    const StudyVerification& how = study->verification;
    RunCheck check = checked(how.progress, how.verify);
    for (std::string& finding : check.findings) finding.insert(0, std::string(study->file) + ": ");
    const std::string right = check.checked == 0
                                  ? fmt::format("has no {} yet, so there is nothing to verify in it", how.unit)
                                  : fmt::format("{}{} run again, all with the same bits; the rest follows from them",
                                                counted(check.checked, how.unit), how.and_more);
    all.add(check, how.units_key, fmt::format("{}/{}: {}\n", request.name, study->file, right));
  }
  return all;
}

}  // namespace rocking::program

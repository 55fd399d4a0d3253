#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "machine.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/number_text.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct VerifyRequest {
  std::string folder;
  std::optional<std::uint64_t> sample;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

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

/// What was checked of a folder.
struct FolderCheck {
  std::vector<Fact> facts;  ///< how much was made again
  std::string table;        ///< of what is right
  std::vector<std::string> findings;

  void add(const RunCheck& check, std::string_view key, const std::string& right) {
    facts.push_back({std::string(key), check.checked});
    table += right;
    findings.insert(findings.end(), check.findings.begin(), check.findings.end());
  }
};

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
            fmt::format("{}: {} run again, all with the same bits; the report follows from them\n", request.folder,
                        counted(check.checked, "realisation")));
  }
  for (const Study* study : found) {
    const StudyVerification& how = study->verification;
    const RunCheck check = checked(how.progress, how.verify);
    all.add(check, how.units_key,
            fmt::format("{}/{}: {}{} run again, all with the same bits; the rest follows from them\n", request.folder,
                        study->file, counted(check.checked, how.unit), how.and_more));
  }
  return all;
}

ExitCode verify(const VerifyRequest& request) {
  FolderCheck check = check_of(request);
  const bool right = check.findings.empty();
  std::vector<Fact> facts{{"verified", right}};
  facts.insert(facts.end(), check.facts.begin(), check.facts.end());
  facts.push_back({"findings", check.findings});
  if (!right) check.table = fmt::format("{}: not verified\n  {}\n", request.folder, fmt::join(check.findings, "\n  "));
  print_study(request.execution.loudness, facts_text(facts), check.table);
  return right ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  const auto request = std::make_shared<VerifyRequest>();
  CLI::App* command = app.add_subcommand("verify", "Run a finished run again and compare the bits");
  command->footer(
      "Example: rocking verify out --sample 100\n"
      "checks that out/report.json follows from out/realisations.sqlite, and that about a hundred of its realisations "
      "give the same bits when they are run again. Without --sample all of them are run. Without the store, the report "
      "is compared with a new run. An out/rare.json is checked, too: by its pilot runs and some of its repetitions; an "
      "out/infer.json by some points of "
      "its design.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command
      ->add_option(
          "--sample", request->sample,
          "Run about N realisations again, N repetitions of rare.json and N points of infer.json, evenly spaced; "
          "default: all realisations, 4 repetitions of each condition, 8 points")
      ->check(whole_number(1, random::realisation_limit))
      ->type_name("N");
  add_threads(*command, request->execution);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return verify(*request); }; });
}

}  // namespace rocking::program

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "machine.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/text/number_text.hpp"
#include "run_folder.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct VerifyRequest {
  std::string folder;
  std::optional<std::uint64_t> sample;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

constexpr const char* rare_name = "rare.json";

void expect_finished_run(const RunFolder& folder, const VerifyRequest& request) {
  folder.expect_installed();
  if (!folder.has_report()) {
    throw MissingInput(fmt::format("{}: is missing, and there is no {}, so there is nothing to verify",
                                   folder.report_path().string(), rare_name));
  }
  if (folder.has_store() || !request.sample) return;
  throw UsageError(folder.store_path().string() +
                   ": is missing, so there are no realisations for --sample; omit --sample");
}

/// What was checked of a folder: its run, its `rare.json`, or both.
struct FolderCheck {
  std::optional<RunCheck> run;
  std::optional<RunCheck> rare;

  [[nodiscard]] std::vector<std::string> findings() const {
    std::vector<std::string> all;
    for (const auto* check : {&run, &rare}) {
      if (check->has_value()) all.insert(all.end(), (*check)->findings.begin(), (*check)->findings.end());
    }
    return all;
  }
};

FolderCheck check_of(const VerifyRequest& request) {
  const std::filesystem::path path = request.folder;
  const RunFolder folder(path);
  FolderCheck check;
  const bool has_rare = std::filesystem::exists(path / rare_name);
  if (folder.has_report() || folder.has_store() || !has_rare) {
    expect_finished_run(folder, request);
    Progress progress(suitable_progress_style(request.execution.loudness), "realisations");
    check.run = input_of([&] { return rocking::verify(path, request.sample, watched(request.execution, progress)); });
  }
  if (has_rare) {
    Progress progress(suitable_progress_style(request.execution.loudness), "repetitions");
    check.rare =
        input_of([&] { return rocking::verify_rare(path, request.sample, watched(request.execution, progress)); });
  }
  return check;
}

ExitCode verify(const VerifyRequest& request) {
  const FolderCheck check = check_of(request);
  const std::vector<std::string> findings = check.findings();
  const bool right = findings.empty();
  std::vector<Fact> facts{{"verified", right}};
  std::string table;
  if (check.run) {
    facts.push_back({"realisations_run_again", check.run->checked});
    table += fmt::format("{}: {} run again, all with the same bits; the report follows from them\n", request.folder,
                         counted(check.run->checked, "realisation"));
  }
  if (check.rare) {
    facts.push_back({"repetitions_run_again", check.rare->checked});
    table += fmt::format("{}/{}: {} and the pilot runs run again, all with the same bits; the rest follows from them\n",
                         request.folder, rare_name, counted(check.rare->checked, "repetition"));
  }
  facts.push_back({"findings", findings});
  if (!right) table = fmt::format("{}: not verified\n  {}\n", request.folder, fmt::join(findings, "\n  "));
  print_study(request.execution.loudness, facts_text(facts), table);
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
      "is compared with a new run. An out/rare.json is checked, too: by its pilot runs and some of its repetitions.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command
      ->add_option("--sample", request->sample,
                   "Run about N realisations again, and N repetitions of rare.json, evenly spaced; default: all "
                   "realisations, and 4 repetitions of each condition")
      ->check(whole_number(1, random::realisation_limit))
      ->type_name("N");
  add_threads(*command, request->execution);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return verify(*request); }; });
}

}  // namespace rocking::program

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

void expect_finished_run(const RunFolder& folder, const VerifyRequest& request) {
  folder.expect_installed();
  if (!folder.has_report())
    throw MissingInput(folder.report_path().string() + ": is missing, so there is nothing to verify");
  if (folder.has_store() || !request.sample) return;
  throw UsageError(folder.store_path().string() +
                   ": is missing, so there are no realisations for --sample; omit --sample");
}

ExitCode verify(const VerifyRequest& request) {
  expect_finished_run(RunFolder(request.folder), request);
  Progress progress(suitable_progress_style(request.execution.loudness), "realisations");
  const RunCheck check = input_of([&] {
    return rocking::verify(std::filesystem::path(request.folder), request.sample, watched(request.execution, progress));
  });
  const bool right = check.findings.empty();
  const std::string json = facts_text(
      std::vector<Fact>{{"verified", right}, {"realisations_run_again", check.checked}, {"findings", check.findings}});
  print_study(request.execution.loudness, json,
              right ? fmt::format("{}: {} run again, all with the same bits; the report follows from them\n",
                                  request.folder, counted(check.checked, "realisation"))
                    : fmt::format("{}: not verified\n  {}\n", request.folder, fmt::join(check.findings, "\n  ")));
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
      "is compared with a new run.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command->add_option("--sample", request->sample, "Run about N realisations again, evenly spaced; default: all")
      ->check(whole_number(1, random::realisation_limit))
      ->type_name("N");
  add_threads(*command, request->execution);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return verify(*request); }; });
}

}  // namespace rocking::program

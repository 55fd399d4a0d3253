#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "progress.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/report_rerun.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/studies/verification.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "rocking/text/number_text.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct VerifyRequest {
  std::string folder;
  std::optional<std::uint64_t> sample;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// Findings of a check of a run.
struct Findings {
  std::vector<std::string> wrong;  ///< empty: no finding
  std::uint64_t checked = 0;       ///< realisations that were run again
};

std::string text_of(const std::filesystem::path& path) {
  try {
    return read_file(path);
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

ReportClaims claims_in(const std::string& text, const std::filesystem::path& path) {
  try {
    return claims_of_report(text);
  } catch (const base::InputError& error) {
    throw located(error, text, path.string());
  }
}

class Verifier {
 public:
  explicit Verifier(const VerifyRequest& request)
      : request_(&request),
        folder_(request.folder),
        report_(text_of(folder_.report_path())),
        claims_(claims_in(report_, folder_.report_path())) {}

  Findings check() {
    folder_.expect_installed();
    check_input();
    if (!findings_.wrong.empty()) return findings_;  // the experiment itself may be wrong, so nothing is run
    if (folder_.has_store()) {
      check_with_store(folder_.open_valid_store());
    } else if (request_->sample) {
      throw UsageError(folder_.store_path().string() +
                       ": is missing, so there are no realisations for --sample; omit --sample");
    } else {
      check_without_store();
    }
    if (!findings_.wrong.empty() && claims_.code != code_identity()) {
      findings_.wrong.push_back(
          fmt::format("the run was made by rocking {}, this is {}: another version may give different results",
                      claims_.code, code_identity()));
    }
    return findings_;
  }

 private:
  void check_input() {
    if (has_stated_digest(claims_)) return;
    findings_.wrong.push_back("report.json: " + std::string(wrong_digest_of_experiment));
  }

  void check_with_store(const Store& store) {
    const Identity& identity = store.identity();
    for (const std::string& difference : experiment_differences(claims_.experiment, identity.experiment)) {
      findings_.wrong.push_back("report.json and realisations.sqlite have different experiments: " + difference);
    }
    if (!findings_.wrong.empty()) return;
    const Experiment experiment = experiment_of(identity);
    const auto result = result_of(experiment, store);
    if (!result) {
      findings_.wrong.push_back("realisations.sqlite lacks realisations that report.json counts");
    } else {
      compare_report(experiment, *result);
    }
    const auto again = verify(experiment, store, request_->sample, options());
    findings_.checked = again.checked;
    for (const auto& [key, fields] : again.differences) {
      findings_.wrong.push_back(
          fmt::format("condition {}, realisation {}: the new result differs from realisations.sqlite in {}",
                      key.condition, key.realisation, fmt::join(fields, ", ")));
    }
    if (again.different > again.differences.size()) {
      findings_.wrong.push_back(fmt::format("{} realisations differ in all", again.different));
    }
  }

  void check_without_store() {
    const Experiment experiment =
        experiment_of({.experiment = claims_.experiment, .code = claims_.code, .files = request_->folder, .shard = {}});
    const ReportRerun again = rerun_report(report_, experiment, options());
    if (again.was_stopped) return;
    findings_.checked = again.checked;
    for (const std::string& difference : again.differences) findings_.wrong.push_back("report.json: " + difference);
  }

  void compare_report(const Experiment& experiment, const ExperimentResult& result) {
    const std::string right = report_text(experiment, result, system_facts(1));
    for (const std::string& difference : report_differences(report_, right)) {
      findings_.wrong.push_back("report.json: " + difference);
    }
  }

  RunOptions options() {
    RunOptions options;
    options.threads = request_->execution.threads;
    options.stop_requested = &stop_on_interrupt();
    options.on_progress = [this](std::uint64_t done, std::uint64_t all) { progress_.show(done, all); };
    return options;
  }

  const VerifyRequest* request_;
  RunFolder folder_;
  std::string report_;
  ReportClaims claims_;
  Findings findings_;
  Progress progress_{suitable_progress_style(request_->execution.loudness), "realisations"};
};

ExitCode verify(const VerifyRequest& request) {
  const Findings findings = Verifier(request).check();
  if (why_stopped() != StopReason::none) {
    print_notice("interrupted before the check was complete");
    return ExitCode::interrupted;
  }
  const bool right = findings.wrong.empty();
  if (request.execution.loudness.json) {
    print_result(facts_text(std::vector<Fact>{
        {"verified", right}, {"realisations_run_again", findings.checked}, {"findings", findings.wrong}}));
  } else if (right) {
    print_result(base::printable(fmt::format("{}: {} run again, all with the same bits; the report follows from them\n",
                                             request.folder, counted(findings.checked, "realisation"))));
  } else {
    print_result(
        base::printable(fmt::format("{}: not verified\n  {}\n", request.folder, fmt::join(findings.wrong, "\n  "))));
  }
  return right ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  const auto request = std::make_shared<VerifyRequest>();
  CLI::App* command = app.add_subcommand("verify", "Run a finished run again and compare the bits");
  command->footer(
      "Example: rocking verify out --sample 100\n"
      "checks that out/report.json follows from out/realisations.sqlite, and that about a hundred of its realisations "
      "give the\n"
      "same bits when they are run again. Without --sample all of them are run. Without the store, the report is "
      "compared with\n"
      "a new run.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command->add_option("--sample", request->sample, "Run about N realisations again, evenly spaced; default: all")
      ->check(whole_number(1, random::realisation_limit))
      ->type_name("N");
  add_threads(*command, request->execution);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return verify(*request); }; });
}

}  // namespace rocking::program

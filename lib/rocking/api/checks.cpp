#include "rocking/api/checks.hpp"

#include <cstdint>
#include <string>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

std::string text_of(const Difference& difference) {
  std::string fields;
  for (const std::string& field : difference.fields) fields += (fields.empty() ? "" : ", ") + field;
  return text_of(difference.key) + ": the new result differs from the stored one in " + fields;
}

/// The claims of a report in a file; an error tells the file and the line.
ReportClaims claims_in(const std::string& text, const std::filesystem::path& file) {
  try {
    return claims_of_report(text);
  } catch (const base::InputError& error) {
    throw located(error, text, file.string());
  }
}

/// Checks a run beside its report. If the experiments differ, nothing is run.
RunCheck verify_both(const std::string& text, const ReportClaims& claims, const StoredRun& stored,
                     const std::optional<std::uint64_t>& sample, const Execution& execution) {
  std::vector<std::string> faults = experiment_differences(claims.experiment, stored.experiment.canonical_text);
  for (std::string& fault : faults) fault.insert(0, "another experiment than that of the realisations: ");
  if (!has_stated_digest(claims)) faults = {std::string(wrong_digest_of_experiment)};
  RunCheck check = faults.empty() ? verify(stored, sample, execution) : RunCheck{};
  if (faults.empty() && !stored.run.is_complete()) faults = {"counts realisations that realisations.sqlite lacks"};
  if (faults.empty()) faults = report_differences(text, report(stored.experiment, stored.run));
  for (std::string& fault : faults) fault.insert(0, "report.json: ");
  check.findings.insert(check.findings.begin(), faults.begin(), faults.end());
  return check;
}

RunCheck verify_alone(const std::string& text, const std::filesystem::path& folder,
                      const std::optional<std::uint64_t>& sample, const Execution& execution) {
  if (sample) {
    refuse("sample", std::to_string(*sample),
           "asks for realisations of " + RunFolder(folder).store_path().string() + ", which is missing; omit it");
  }
  RunCheck check = verify_report(text, folder, execution);
  for (std::string& finding : check.findings) finding.insert(0, "report.json: ");
  return check;
}

RealisationKey key_of(const TrajectoryRequest& request) {
  return {.condition = request.condition, .realisation = request.realisation};
}

std::optional<Summary> row_of(const Store& store, const Experiment& experiment, const TrajectoryRequest& request) {
  return request.condition < experiment.conditions.size() ? store.find(key_of(request)) : std::optional<Summary>{};
}

/// A row of a store, and where it comes from.
struct StoredRow {
  Summary row;
  std::string code;   ///< version that computed it
  std::string where;  ///< `stored in out`
};

/// The trajectory of a realisation that has the digest of its row.
Trajectory checked_trajectory(const Experiment& experiment, const TrajectoryRequest& request, const StoredRow& stored,
                              const Execution& execution) {
  const RealisationResult again =
      realise(experiment.conditions[request.condition], experiment.seed, request.realisation, execution.stop);
  if (digest_of(again, request.realisation) != stored.row.digest) {
    throw DifferentBits(text_of(key_of(request)) + ": this program gives a result different from the one " +
                        stored.where + ", which rocking " + stored.code + " computed; this is " +
                        base::code_identity());
  }
  return trajectory(experiment, request, execution);
}

stats::Proportion checked(std::uint64_t successes, std::uint64_t trials, double confidence) {
  // Boost.Math finds the ends up to here.
  constexpr double least_confidence = 1e-6;
  constexpr std::uint64_t most_trials = 1'000'000'000;
  if (!(confidence >= least_confidence && confidence < 1.0)) {
    refuse("confidence", base::shortest(confidence), "must be at least 1e-6 and below 1");
  }
  if (trials > most_trials) refuse("trials", std::to_string(trials), "must be at most 1000000000");
  if (successes > trials) {
    refuse("successes", std::to_string(successes), "are more than the trials, " + std::to_string(trials));
  }
  return {.successes = successes, .trials = trials};
}

}  // namespace

RunCheck verify(const StoredRun& stored, std::optional<std::uint64_t> sample, const Execution& execution) {
  if (sample == 0) refuse("sample", "0", "must be at least 1");
  const OptionsOfExecution asked(execution);
  const Verification found = verify(stored.experiment, store_of(stored.run), sample, asked.options());
  asked.stop().check();
  RunCheck check{.checked = found.checked, .different = found.different, .findings = {}};
  for (const Difference& difference : found.differences) check.findings.push_back(text_of(difference));
  if (found.different > found.differences.size()) {
    check.findings.push_back(std::to_string(found.different) + " realisations differ in all");
  }
  return check;
}

RunCheck verify_report(std::string_view text, const std::filesystem::path& files, const Execution& execution) {
  const ReportClaims claims = claims_of_report(text);
  if (!has_stated_digest(claims)) return {.findings = {std::string(wrong_digest_of_experiment)}};
  const Experiment experiment = experiment_in(claims.experiment, Overrides{}, {.files = files_seen_from(files)});
  const OptionsOfExecution asked(execution);
  const ReportRerun again = rerun_report(text, experiment, asked.options());
  if (again.was_stopped) throw base::Stopped();
  return {.checked = again.checked, .findings = again.differences};
}

RunCheck verify(const std::filesystem::path& folder, std::optional<std::uint64_t> sample, const Execution& execution) {
  const std::filesystem::path file = folder / "report.json";
  if (!std::filesystem::exists(file)) return verify(open_run(folder), sample, execution);
  const std::string text = read_file(file);
  const ReportClaims claims = claims_in(text, file);
  const RunFolder run(folder);
  RunCheck check = run.has_store() ? verify_both(text, claims, stored_run(run.open_valid_store_beside_any_report()),
                                                 sample, execution)
                                   : verify_alone(text, folder, sample, execution);
  if (!check.findings.empty() && claims.code != base::code_identity()) {
    check.findings.push_back("the run was made by rocking " + claims.code + ", this is " + base::code_identity() +
                             ": another version may give different results");
  }
  return check;
}

Trajectory replay(const StoredRun& stored, const TrajectoryRequest& request, const Execution& execution) {
  const Store& store = store_of(stored.run);
  const auto row = row_of(store, stored.experiment, request);
  if (!row) {
    refuse("realisation", std::to_string(request.realisation),
           "is not in the run: it has no " + text_of(key_of(request)));
  }
  return checked_trajectory(stored.experiment, request, {*row, store.identity().code, "stored"}, execution);
}

Trajectory replay(const std::filesystem::path& path, const TrajectoryRequest& request, const Execution& execution) {
  const RunFolder folder(path);
  const Store store = folder.open_store(sqlite::Access::read);
  const Experiment experiment = experiment_of(store.identity());
  const auto row = row_of(store, experiment, request);
  if (!row) {
    static_cast<void>(folder.open_valid_store());  // in a damaged store a row may be there and not be found
    throw base::FolderError(base::FolderError::Kind::contradiction, "",
                            folder.name() + " contains no realisation " + std::to_string(request.realisation) +
                                " of condition " + std::to_string(request.condition) + "; both numbers start at 0");
  }
  return checked_trajectory(experiment, request, {*row, store.identity().code, "stored in " + folder.name()},
                            execution);
}

base::BuildInfo build_info() { return base::build_info(); }

std::string lanes_in_use() {
  const auto used = RunOptions().lanes;
  return std::to_string(used.lanes) + ", " + std::string(used.name);
}

std::vector<base::ArithmeticCheck> check_arithmetic() { return base::arithmetic_checks(); }

stats::Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  return stats::clopper_pearson(checked(successes, trials, confidence), confidence);
}

stats::Interval wilson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  return stats::wilson(checked(successes, trials, confidence), confidence);
}

}  // namespace rocking

#include "rocking/api/checks.hpp"

#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/verification.hpp"
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

std::string text_of(const RealisationKey& key) {
  return "condition " + std::to_string(key.condition) + ", realisation " + std::to_string(key.realisation);
}

std::string text_of(const Difference& difference) {
  std::string fields;
  for (const std::string& field : difference.fields) fields += (fields.empty() ? "" : ", ") + field;
  return text_of(difference.key) + ": the new result differs from the stored one in " + fields;
}

/// What makes the other numbers of a report say nothing about the run.
std::vector<std::string> faults_of_experiment(const ReportClaims& claims, const StoredRun& stored) {
  if (!has_stated_digest(claims)) return {std::string(wrong_digest_of_experiment)};
  std::vector<std::string> faults = experiment_differences(claims.experiment, stored.experiment.canonical_text);
  for (std::string& fault : faults) fault.insert(0, "another experiment than that of the realisations: ");
  return faults;
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
  std::vector<std::string> faults = faults_of_experiment(claims, stored);
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

std::vector<std::string> report_faults(std::string_view text, const StoredRun& stored) {
  std::vector<std::string> faults = faults_of_experiment(claims_of_report(text), stored);
  return faults.empty() ? report_differences(text, report(stored.experiment, stored.run)) : faults;
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
  const Experiment& experiment = stored.experiment;
  const RealisationKey key{.condition = request.condition, .realisation = request.realisation};
  const auto row =
      key.condition < experiment.conditions.size() ? store_of(stored.run).find(key) : std::optional<Summary>{};
  if (!row) refuse("realisation", std::to_string(key.realisation), "is not in the run: it has no " + text_of(key));
  const RealisationResult again =
      realise(experiment.conditions[key.condition], experiment.seed, key.realisation, execution.stop);
  if (digest_of(again, key.realisation) != row->digest) {
    throw DifferentBits(text_of(key) + ": this version gives a result different from the stored one, which rocking " +
                        store_of(stored.run).identity().code + " computed");
  }
  return trajectory(experiment, request, execution);
}

base::BuildInfo build_info() { return base::build_info(); }

std::vector<base::ArithmeticCheck> check_arithmetic() { return base::arithmetic_checks(); }

}  // namespace rocking

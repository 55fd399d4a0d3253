#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "rocking/api/checks.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/study_check.hpp"
#include "rocking/base/error.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/studies/rare/progress.hpp"
#include "rocking/studies/rare/result.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

RareReport rare_report_in(const std::string& text, const std::filesystem::path& file) {
  try {
    return rare_document().read_unchecked(parse_json(text));
  } catch (const base::InputError& error) {
    throw located(error, text, file.string());
  }
}

std::vector<RareEstimate> estimates_in(const RareReport& report) {
  std::vector<RareEstimate> estimates;
  for (const ReportedRare& condition : report.conditions) estimates.push_back(condition.estimate);
  return estimates;
}

std::uint64_t differing_repetitions(const std::vector<RareEstimate>& first, const std::vector<RareEstimate>& second) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < first[i].repetitions.size(); ++k) {
      const rare::Repetition& a = first[i].repetitions[k];
      const rare::Repetition& b = second[i].repetitions[k];
      count += a.estimate != b.estimate || a.work != b.work ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

RunCheck verify_rare(const std::filesystem::path& folder, std::optional<std::uint64_t> sample,
                     const Execution& execution) {
  if (sample == 0) refuse("sample", "0", "must be at least 1");
  constexpr std::size_t of_each = 4;
  const std::filesystem::path file = folder / "rare.json";
  const std::string text = read_file(file);
  const RareReport claimed = rare_report_in(text, file);
  RunCheck check;
  const std::optional<Experiment> experiment = stated_experiment(claimed.input, seen_near(folder));
  if (!experiment) {
    check.findings = {"rare.json: " + std::string(wrong_digest_of_experiment)};
    return check;
  }
  const std::size_t conditions = experiment->conditions.size();
  if (claimed.conditions.size() != conditions) {
    check.findings = {"rare.json: does not have one estimate for each condition of its experiment"};
    return check;
  }
  const std::vector<RareEstimate> earlier = estimates_in(claimed);
  const OptionsOfExecution asked(execution);
  RareSettings settings{.particles = claimed.particles, .threads = asked.options().threads, .stop = asked.stop()};
  TotalProgress progress(asked.options(), conditions);
  settings.on_progress = [&progress](std::size_t condition, double done, double expected) {
    progress.tell(condition, done, expected);
  };
  const RareRerun again =
      rare_probabilities_again(*experiment, claimed.question, settings, earlier, sample.value_or(of_each * conditions));
  check.checked = again.repetitions;
  check.different = differing_repetitions(earlier, again.estimates);
  const RareReport right =
      rare_report(*experiment, {.question = claimed.question, .particles = claimed.particles}, again.estimates);
  check.findings = report_differences(text, rare_document().text(right));
  for (std::string& finding : check.findings) finding.insert(0, "rare.json: ");
  return check;
}

}  // namespace rocking

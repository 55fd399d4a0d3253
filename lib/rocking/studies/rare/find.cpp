#include <algorithm>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/rare/estimator.hpp"
#include "rocking/studies/rare/rare.hpp"
#include "rocking/studies/rare/study.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

/// Progress by condition as progress of all. A condition that has not told how much it expects is expected to take as
/// much as the mean of those before it; likewise those to come.
class TotalProgress {
 public:
  TotalProgress(const RunOptions& options, std::size_t conditions) : options_(&options), conditions_(conditions) {}

  [[nodiscard]] RareSettings settings() {
    return {.threads = options_->threads,
            .stop = options_->stop_requested,
            .on_progress = [this](std::size_t condition, double done, double expected) {
              tell(condition, done, expected);
            }};
  }

 private:
  void tell(std::size_t condition, double done, double expected) {
    if (condition != condition_) earlier_ += last_;
    condition_ = condition;
    last_ = done;
    if (!options_->on_progress) return;
    double begun = earlier_ + expected;
    if (expected == 0.0 && condition > 0) {
      begun = earlier_ + std::max(done, earlier_ / static_cast<double>(condition));
    }
    const double all = begun * static_cast<double>(conditions_) / static_cast<double>(condition + 1);
    const auto whole = static_cast<std::uint64_t>(earlier_ + done);
    options_->on_progress(whole, all > 0.0 ? std::max(whole, static_cast<std::uint64_t>(all)) : 0);
  }

  const RunOptions* options_;
  std::size_t conditions_;
  std::size_t condition_ = 0;
  double last_ = 0.0;
  double earlier_ = 0.0;
};

/// Throws where slip is asked of a block that cannot slide, or of one whose slip no strobe point foretells.
void check_slip(const Experiment& experiment, const ResponseEvent& event) {
  if (!event.is_of_slip()) return;
  for (const Condition& condition : experiment.conditions) {
    check_friction(event, condition);
    if (rare::method_of(condition.scene) != RareMethod::importance_sampling) {
      throw base::InputError({"event", event_text(event),
                              "is estimated only where all numbers are drawn once: the slip up to a strobe point is "
                              "not part of what steers a particle run",
                              "use `rocking run` and `rocking fragility`, or leave out `fluctuation`"});
    }
  }
}

}  // namespace

void check_question(const Experiment& experiment, const RareQuestion& question) {
  check_has_conditions(experiment);
  QuestionCheck check(question);
  check.expect(question.earlier.size() <= experiment.conditions.size(), "earlier",
               std::to_string(question.earlier.size()) + " entries", "must be at most one for each condition");
  for (std::size_t i = 0; i < question.earlier.size(); ++i) {
    const std::size_t size = question.earlier[i].repetitions.size();
    check.expect(size < rare::most_repetitions, "earlier/" + std::to_string(i), std::to_string(size) + " repetitions",
                 "must be fewer than " + std::to_string(rare::most_repetitions));
  }
  check.finish();
  check_rare(experiment);
  check_slip(experiment, question.event);
}

std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                             const Execution& execution, const KeepRare& keep) {
  check_question(experiment, question);
  if (question.seconds && !execution.elapsed_seconds) refuse("seconds", "", "needs a clock: `elapsed_seconds`");
  const OptionsOfExecution asked(execution);
  TotalProgress progress(asked.options(), experiment.conditions.size());
  RareSettings settings = progress.settings();
  settings.elapsed_seconds = execution.elapsed_seconds;
  settings.keep = keep;
  std::vector<RareEstimate> found = rare_estimates(experiment, question, settings);
  const bool is_stopped = std::ranges::any_of(found, [](const auto& one) { return one.end == RareEnd::stopped; });
  if (is_stopped && !keep) throw base::Stopped();
  return found;
}

std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                             const Execution& execution) {
  return rare_probabilities(experiment, question, execution, {});
}

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
    check.findings = {std::string(wrong_digest_of_experiment)};
    return check;
  }
  const std::size_t conditions = experiment->conditions.size();
  if (claimed.conditions.size() != conditions) {
    check.findings = {"does not have one estimate for each condition of its experiment"};
    return check;
  }
  RareQuestion question = claimed.question;
  question.earlier = estimates_in(claimed);
  const OptionsOfExecution asked(execution);
  TotalProgress progress(asked.options(), conditions);
  const RareRerun again =
      rare_estimates_again(*experiment, question, progress.settings(), sample.value_or(of_each * conditions));
  check.checked = again.repetitions;
  check.different = differing_repetitions(question.earlier, again.estimates);
  check.findings = report_differences(text, rare_document().text(rare_report(*experiment, question, again.estimates)));
  return check;
}

}  // namespace rocking

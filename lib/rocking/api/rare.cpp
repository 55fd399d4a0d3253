#include "rocking/api/studies.hpp"

#include <algorithm>
#include <cstdint>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/output/rare_report.hpp"
#include "rocking/studies/rare/rare.hpp"

namespace rocking {
void check_request(const Experiment& experiment, const RareRequest& request) {
  if (request.particles < 20 || request.particles > 100'000) {
    refuse("particles", std::to_string(request.particles), "must be a whole number from 20 to 100000");
  }
  const double error = request.question.relative_error;
  if (!(error >= 1e-3 && error <= 1.0)) refuse("relative_error", base::shortest(error), "must be from 1e-3 to 1");
  if (request.seconds && !(*request.seconds > 0.0 && request.elapsed_seconds)) {
    refuse("seconds", base::shortest(*request.seconds), "must be positive, and needs a clock");
  }
  const auto tilt = request.question.event.peak_tilt;
  if (tilt && !(*tilt >= 0.0 && *tilt <= 100.0)) refuse("peak_tilt", base::shortest(*tilt), "must be from 0 to 100");
  check_rare(experiment);
}

namespace {

/// Progress by condition as progress of all.
class TotalProgress {
 public:
  explicit TotalProgress(const RunOptions& options) : options_(&options) {}

  void tell(std::size_t condition, std::size_t done, std::size_t planned) {
    if (condition != condition_) earlier_ += last_;
    condition_ = condition;
    last_ = done;
    if (options_->on_progress) options_->on_progress(earlier_ + done, earlier_ + planned);
  }

 private:
  const RunOptions* options_;
  std::size_t condition_ = 0;
  std::uint64_t last_ = 0;
  std::uint64_t earlier_ = 0;
};

}  // namespace

std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareRequest& request,
                                             const Execution& execution) {
  check_request(experiment, request);
  const OptionsOfExecution asked(execution);
  TotalProgress progress(asked.options());
  RareSettings settings{.particles = request.particles, .threads = asked.options().threads, .stop = asked.stop()};
  settings.seconds = request.seconds;
  settings.elapsed_seconds = request.elapsed_seconds;
  settings.on_progress = [&progress](std::size_t condition, std::size_t done, std::size_t planned) {
    progress.tell(condition, done, planned);
  };
  settings.earlier = request.earlier;
  std::vector<RareEstimate> found = rare_probabilities(experiment, request.question, settings);
  const bool is_stopped = std::ranges::any_of(found, [](const auto& one) { return one.end == RareEnd::stopped; });
  if (is_stopped && !request.keeps_when_stopped) throw base::Stopped();
  return found;
}

std::string rare_probabilities_text(const Experiment& experiment, const RareRequest& request,
                                    const std::vector<RareEstimate>& found) {
  return rare_document().text(
      rare_report(experiment, {.question = request.question, .particles = request.particles}, found));
}

}  // namespace rocking

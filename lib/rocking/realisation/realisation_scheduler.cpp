#include "rocking/realisation/realisation_scheduler.hpp"

#include <optional>
#include <utility>

#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {
namespace {

struct RealisationInProgress;

/// The window of a realisation, run again with tangent vectors.
struct TangentsInProgress {
  [[nodiscard]] TangentRun::Motion& motion() const { return tangent_run->motion(); }
  [[nodiscard]] integrate::LoopCounts& counts() { return own_counts; }
  [[nodiscard]] bool go_on() const;

  RealisationInProgress* run;
  TangentRun* tangent_run;
  integrate::LoopCounts own_counts{};  ///< not reported
};

/// A realisation in the scheduler, with the caller's id.
struct RealisationInProgress : HorizonRun {
  template <class MakeMotion>
  RealisationInProgress(const Condition& condition, const Beginning& beginning, std::size_t its_id,
                        MakeMotion&& make_motion)
      : HorizonRun(condition, beginning, make_motion), id(its_id) {}

  std::size_t id;
  std::optional<TangentsInProgress> tangents;  ///< while the exponent of the newest window is computed
};

bool TangentsInProgress::go_on() const { return tangent_run->go_on(run->pending()); }

}  // namespace

class RealisationScheduler::Implementation {
 public:
  Implementation(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop)
      : seed_(seed), kernels_(kernels), stop_(stop), scheduler_(kernels, stop) {}
  ~Implementation() = default;

  // A block that never moves ends in start() and needs no lane. Its result is to be taken before more are started.
  [[nodiscard]] bool wants_more() const { return !scheduler_.has_finished() && size() < scheduler_.wanted_size(); }
  [[nodiscard]] bool is_idle() const { return runs_.empty() && finished_.empty(); }

  void start(const RequestedRun& run, std::size_t id) {
    const Condition& condition = *run.condition;
    const random::Draws draws(seed_of(condition, seed_), run.realisation);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning =
        begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_window(condition));
    runs_.push_back(
        std::make_unique<RealisationInProgress>(condition, beginning, id, [&](dynamics::Observer& observer) {
          return motion_of(beginning, observer, excitation_.of(condition.scene, beginning));
        }));
    if (has_long_run(condition, run.realisation)) runs_.back()->observe_long_run();
    scheduler_.add(*runs_.back());
  }

  [[nodiscard]] std::vector<Finished> work() {
    constexpr int most_steps = 4096;
    for (int i = 0; i < most_steps && is_under_way(); ++i) {
      if (tangents_ && tangents_->largest_size() > scheduler_.largest_size()) {
        tangents_->step();
      } else {
        scheduler_.step();
      }
    }
    return std::exchange(finished_, {});
  }

 private:
  /// Whether a step must be made before a realisation is finished.
  [[nodiscard]] bool is_under_way() {
    while (RealisationInProgress* run = scheduler_.take_finished()) classify(*run);
    while (tangents_ && tangents_->has_finished()) end_window(*tangents_->take_finished()->run);
    return finished_.empty() && size() > 0;
  }

  /// Number of motions that have not ended.
  [[nodiscard]] std::size_t size() const { return scheduler_.size() + (tangents_ ? tangents_->size() : 0); }

  /// Continues after the motion of a realisation has ended.
  void classify(RealisationInProgress& run) {
    TangentRun* tangent_run = run.classify();
    if (tangent_run == nullptr) return end_window(run);
    if (!tangents_) tangents_.emplace(kernels_, stop_);
    tangents_->add(run.tangents.emplace(TangentsInProgress{.run = &run, .tangent_run = tangent_run}));
  }

  void end_window(RealisationInProgress& run) {
    if (!run.begin_next_window()) return finish(run);
    scheduler_.add(run);
  }

  void finish(RealisationInProgress& run) {
    finished_.push_back({run.id, run.finish()});
    std::erase_if(runs_, [&run](const auto& owned) { return owned.get() == &run; });
  }

  std::uint64_t seed_;
  const lanes::Kernels& kernels_;
  base::StopRequest stop_;
  SharedExcitation excitation_;
  lanes::LaneScheduler<RealisationInProgress> scheduler_;
  std::optional<lanes::LaneScheduler<TangentsInProgress>> tangents_;  ///< once an exponent was needed
  std::vector<std::unique_ptr<RealisationInProgress>> runs_;
  std::vector<Finished> finished_;
};

RealisationScheduler::RealisationScheduler(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop)
    : implementation_(std::make_unique<Implementation>(seed, kernels, stop)) {}
RealisationScheduler::~RealisationScheduler() = default;
bool RealisationScheduler::wants_more() const { return implementation_->wants_more(); }
bool RealisationScheduler::is_idle() const { return implementation_->is_idle(); }
void RealisationScheduler::start(const RequestedRun& run, std::size_t id) { implementation_->start(run, id); }
std::vector<RealisationScheduler::Finished> RealisationScheduler::work() { return implementation_->work(); }

}  // namespace rocking

#include "rocking/realisation/realisation_scheduler.hpp"

#include <optional>
#include <unordered_map>
#include <utility>

#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {
namespace {

struct RealisationInProgress;

/// How many windows of a condition were classified, and how many of them needed the exponent.
///
/// Where most do, a window is run with tangent vectors at once: those of the others are then in vain, but no window is run
/// twice. With vectors a period takes 1.7 times as long as without; so this pays from 0.42 of the windows on. The results
/// are the same.
class ExponentNeed {
 public:
  void count(bool needed) {
    ++windows_;
    needed_ += needed ? 1 : 0;
  }
  [[nodiscard]] bool is_usual() const { return windows_ >= enough && 2 * needed_ > windows_; }

 private:
  static constexpr std::uint64_t enough = 8;
  std::uint64_t windows_ = 0;
  std::uint64_t needed_ = 0;
};

/// The window of a realisation with tangent vectors: from its beginning, or run again.
struct TangentsInProgress {
  [[nodiscard]] TangentRun::Motion& motion() const { return tangent_run->motion(); }
  [[nodiscard]] integrate::LoopCounts& counts() { return own_counts; }
  [[nodiscard]] bool go_on();

  RealisationInProgress* run;
  TangentRun* tangent_run;
  bool is_first_run;                   ///< of the window
  integrate::LoopCounts own_counts{};  ///< reported if it is
};

/// A realisation in the scheduler, with the caller's id.
struct RealisationInProgress : HorizonRun {
  template <class MakeMotion>
  RealisationInProgress(const Condition& condition, const random::Draws& draws, const Beginning& beginning,
                        std::size_t its_id, ExponentNeed& of_condition, MakeMotion&& make_motion)
      : HorizonRun(condition, draws, beginning, make_motion), id(its_id), need(of_condition) {}

  /// As that of HorizonRun; also false, with `tangents`, where the window is run with tangent vectors.
  [[nodiscard]] bool go_on() {
    if (!HorizonRun::go_on()) return false;
    if (!need.is_usual() || !may_begin_with_tangents()) return true;
    run_tangents(begin_with_tangents(), true);
    return false;
  }

  void run_tangents(TangentRun& tangent_run, bool is_first_run) {
    tangents.emplace(TangentsInProgress{.run = this, .tangent_run = &tangent_run, .is_first_run = is_first_run});
  }

  /// HorizonRun::classify, counted.
  [[nodiscard]] TangentRun* classify() {
    TangentRun* tangent_run = HorizonRun::classify();
    need.count(tangent_run != nullptr);
    return tangent_run;
  }

  std::size_t id;
  ExponentNeed& need;
  std::optional<TangentsInProgress> tangents;  ///< while the newest window is run with tangent vectors
};

bool TangentsInProgress::go_on() {
  if (is_first_run) {
    is_first_run = false;
    run->take_window(own_counts);
    if (run->classify() == nullptr) return false;
  }
  return tangent_run->go_on(run->pending());
}

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
    runs_.push_back(std::make_unique<RealisationInProgress>(
        condition, draws, beginning, id, needs_[&condition], [&](dynamics::Observer& observer) {
          return motion_of(beginning, observer, excitation_.of(condition.scene, beginning));
        }));
    if (has_long_run(condition, run.realisation)) runs_.back()->observe_long_run();
    scheduler_.add(*runs_.back());
  }

  [[nodiscard]] std::vector<Finished> work() {
    constexpr int steps_at_a_time = 4096;
    for (int i = 0; i < steps_at_a_time && is_under_way(); ++i) {
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

  /// Continues after the motion of a realisation has ended, or begins its window with tangent vectors.
  void classify(RealisationInProgress& run) {
    if (!run.tangents) {
      TangentRun* tangent_run = run.classify();
      if (tangent_run == nullptr) return end_window(run);
      run.run_tangents(*tangent_run, false);
    }
    if (!tangents_) tangents_.emplace(kernels_, stop_);
    tangents_->add(*run.tangents);
  }

  void end_window(RealisationInProgress& run) {
    run.tangents.reset();
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
  std::unordered_map<const Condition*, ExponentNeed> needs_;
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

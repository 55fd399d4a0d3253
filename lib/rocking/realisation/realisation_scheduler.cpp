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

/// The same shaking with another size; kinds that hold none stay as they are.
dynamics::Excitation with_size(const dynamics::Excitation& excitation, double size) {
  return excitation.visit([size](const auto& kind) -> dynamics::Excitation {
    if constexpr (requires { kind.scaled(size); }) {
      return kind.scaled(size);
    } else {
      return kind;
    }
  });
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
    const random::Draws draws(seed_, run.realisation);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning =
        begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_window(condition));
    runs_.push_back(
        std::make_unique<RealisationInProgress>(condition, beginning, id, [&](dynamics::Observer& observer) {
          return motion_of(beginning, observer, shared_excitation(condition.scene, beginning));
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
  /// The last computed excitation. Realisations with equal blocks share the knots of a ground motion.
  struct LastExcitation {
    Excitation asked;
    double frequency_parameter;  ///< p
    double frequency;            ///< of the clock [-]
    double start;                ///< of the clock, tau
    double size;                 ///< that was drawn
    dynamics::Excitation excitation;
  };

  const dynamics::Excitation& shared_excitation(const Scene& scene, const Beginning& beginning) {
    const double p = beginning.setting.block.frequency_parameter;
    const double frequency = beginning.clock.frequency();
    const double start = beginning.clock.start();
    const double size = beginning.excitation_size;
    const bool is_known = last_ && last_->asked == scene.excitation && last_->frequency_parameter == p &&
                          last_->frequency == frequency && last_->start == start;
    if (!is_known) {
      last_ = LastExcitation{scene.excitation, p, frequency, start, size, excitation_of(scene, beginning)};
    } else if (last_->size != size) {
      last_->size = size;
      last_->excitation = with_size(last_->excitation, size);
    }
    return last_->excitation;
  }

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
  std::optional<LastExcitation> last_;
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

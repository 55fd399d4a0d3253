#include "rocking/realisation/realisation_scheduler.hpp"

#include <optional>
#include <utility>

#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {
namespace {

/// A realisation in the scheduler, with the caller's id.
struct RealisationInProgress : HorizonRun {
  template <class MakeMotion>
  RealisationInProgress(const Condition& condition, const Beginning& beginning, std::size_t its_id,
                        MakeMotion&& make_motion)
      : HorizonRun(condition, beginning, make_motion), id(its_id) {}

  std::size_t id;
};

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
      : seed_(seed), stop_(stop), scheduler_(kernels, stop) {}
  ~Implementation() = default;

  // A block that never moves ends in start() and needs no lane. Its result is to be taken before more are started.
  [[nodiscard]] bool wants_more() const {
    return !scheduler_.has_finished() && scheduler_.size() < scheduler_.wanted_size();
  }
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
    for (int i = 0; i < most_steps && is_under_way(); ++i) scheduler_.step();
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
    while (RealisationInProgress* run = scheduler_.take_finished()) end_window(*run);
    return finished_.empty() && scheduler_.size() > 0;
  }

  /// Continues after the motion of a realisation has ended.
  void end_window(RealisationInProgress& run) {
    if (TangentRun* tangents = run.classify()) run_alone(*tangents, run.pending(), stop_);
    if (!run.begin_next_window()) return finish(run);
    scheduler_.add(run);
  }

  void finish(RealisationInProgress& run) {
    finished_.push_back({run.id, run.finish()});
    std::erase_if(runs_, [&run](const auto& owned) { return owned.get() == &run; });
  }

  std::uint64_t seed_;
  base::StopRequest stop_;
  std::optional<LastExcitation> last_;
  lanes::LaneScheduler<RealisationInProgress> scheduler_;
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

#include "rocking/experiment/realisation_crew.hpp"

#include <array>
#include <optional>
#include <utility>

#include "rocking/experiment/horizon_run.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/lanes/crew.hpp"

namespace rocking::experiment {
namespace {

struct TicketedRun;

/// A motion in the crew: that of a realisation, or one of its companions.
struct Passenger {
  [[nodiscard]] Motion& motion() const { return *its_motion; }
  [[nodiscard]] integrate::LoopCounts& counts() { return *its_counts; }
  [[nodiscard]] bool go_on() const;

  TicketedRun* run;
  Motion* its_motion;
  integrate::LoopCounts* its_counts;
};

/// A realisation in the crew, and who asked for it.
struct TicketedRun : HorizonRun {
  template <class MakeMotion>
  TicketedRun(const Condition& condition, std::size_t its_ticket, std::uint64_t draws, MakeMotion&& make_motion)
      : HorizonRun(condition, make_motion), ticket(its_ticket), initial_draws(draws) {}

  std::size_t ticket;
  std::uint64_t initial_draws;
  Passenger itself{.run = this, .its_motion = &motion(), .its_counts = &counts()};
  CompanionPair* companions = nullptr;  ///< once they are on their way
  std::array<Passenger, 2> pair{};
  integrate::LoopCounts companion_counts;  ///< nobody asks for them
  int under_way = 0;                       ///< of the pair
};

bool Passenger::go_on() const { return this == &run->itself && run->go_on(); }

}  // namespace

class RealisationCrew::Implementation {
 public:
  Implementation(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop)
      : seed_(seed), stop_(stop), crew_(kernels, stop) {}
  ~Implementation() = default;

  [[nodiscard]] bool wants_more() const { return crew_.size() < crew_.wanted_size(); }
  [[nodiscard]] bool is_idle() const { return runs_.empty() && finished_.empty(); }

  void start(const Task& task, std::size_t ticket) {
    const Condition& condition = *task.condition;
    const random::Draws draws(seed_, task.realisation);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning =
        begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_copy(condition));
    runs_.push_back(std::make_unique<TicketedRun>(condition, ticket, start.draws, [&](dynamics::Observer& observer) {
      return motion_of(beginning, observer, shared_excitation(condition.scene, beginning));
    }));
    crew_.add(runs_.back()->itself);
  }

  [[nodiscard]] std::vector<Finished> work() {
    constexpr int most_steps = 4096;
    for (int i = 0; i < most_steps && is_under_way(); ++i) crew_.step();
    return std::exchange(finished_, {});
  }

 private:
  /// What was last worked out of an excitation. Realisations of a condition share its record's knots.
  struct LastExcitation {
    Excitation asked;
    double frequency_parameter;  ///< p
    double start;                ///< of the clock
    dynamics::Excitation excitation;
  };

  const dynamics::Excitation& shared_excitation(const Scene& scene, const Beginning& beginning) {
    const double p = beginning.setting.block.frequency_parameter;
    const double start = beginning.clock.start();
    const bool is_known =
        last_ && last_->asked == scene.excitation && last_->frequency_parameter == p && last_->start == start;
    if (!is_known) last_ = LastExcitation{scene.excitation, p, start, excitation_of(scene, beginning)};
    return last_->excitation;
  }

  /// Whether there is a step to be made before something is finished.
  [[nodiscard]] bool is_under_way() {
    while (const Passenger* passenger = crew_.take_finished()) go_on(*passenger);
    return finished_.empty() && crew_.size() > 0;
  }

  /// With what comes after a motion that has finished.
  void go_on(const Passenger& passenger) {
    TicketedRun& run = *passenger.run;
    if (&passenger == &run.itself) {
      run.companions = run.name();
      if (run.companions == nullptr) return finish(run);
      run.pair = {Passenger{&run, &run.companions->leader(), &run.companion_counts},
                  Passenger{&run, &run.companions->companion(), &run.companion_counts}};
    } else {
      if (--run.under_way > 0) return;
      if (!run.companions->go_on()) return finish(run);
    }
    run.under_way = 2;
    for (Passenger& companion : run.pair) crew_.add(companion);
  }

  void finish(TicketedRun& run) {
    Record record = run.finish();
    record.effort.initial_draws = run.initial_draws;
    finished_.push_back({run.ticket, std::move(record)});
    std::erase_if(runs_, [&run](const auto& owned) { return owned.get() == &run; });
  }

  std::uint64_t seed_;
  base::StopRequest stop_;
  std::optional<LastExcitation> last_;
  lanes::Crew<Passenger> crew_;
  std::vector<std::unique_ptr<TicketedRun>> runs_;
  std::vector<Finished> finished_;
};

RealisationCrew::RealisationCrew(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop)
    : implementation_(std::make_unique<Implementation>(seed, kernels, stop)) {}
RealisationCrew::~RealisationCrew() = default;
bool RealisationCrew::wants_more() const { return implementation_->wants_more(); }
bool RealisationCrew::is_idle() const { return implementation_->is_idle(); }
void RealisationCrew::start(const Task& task, std::size_t ticket) { implementation_->start(task, ticket); }
std::vector<RealisationCrew::Finished> RealisationCrew::work() { return implementation_->work(); }

}  // namespace rocking::experiment

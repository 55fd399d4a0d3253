#include "rocking/experiment/realisation_crew.hpp"

#include <utility>

#include "rocking/experiment/horizon_run.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/lanes/crew.hpp"

namespace rocking::experiment {
namespace {

using dynamics::HarmonicExcitation;

/// A realisation in the crew, and who asked for it.
struct TicketedRun : HorizonRun<HarmonicExcitation> {
  template <class MakeMotion>
  TicketedRun(const Condition& condition, std::size_t its_ticket, std::uint64_t draws, MakeMotion&& make_motion)
      : HorizonRun(condition, make_motion), ticket(its_ticket), initial_draws(draws) {}

  std::size_t ticket;
  std::uint64_t initial_draws;
};

}  // namespace

class RealisationCrew::Implementation {
 public:
  Implementation(std::uint64_t seed, const lanes::Kernels& kernels) : seed_(seed), crew_(kernels) {}
  ~Implementation() = default;

  [[nodiscard]] bool wants_more() const { return crew_.size() < crew_.wanted_size(); }
  [[nodiscard]] bool is_idle() const { return runs_.empty() && finished_.empty(); }

  void start(const Task& task, std::size_t ticket) {
    const Condition& condition = *task.condition;
    if (condition.scene.excitation.record != nullptr) {
      finished_.push_back({ticket, realise(condition, seed_, task.realisation)});
      return;
    }
    const random::Draws draws(seed_, task.realisation);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning =
        begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_copy(condition));
    runs_.push_back(std::make_unique<TicketedRun>(condition, ticket, start.draws, [&](dynamics::Observer& observer) {
      return motion_of(beginning, observer, HarmonicExcitation{});
    }));
    crew_.add(*runs_.back());
  }

  [[nodiscard]] std::vector<Finished> work() {
    constexpr int most_steps = 4096;
    for (int i = 0; i < most_steps && crew_.size() > 0 && !crew_.has_finished(); ++i) crew_.step();
    for (TicketedRun* run : crew_.take_finished()) {
      Record record = run->finish();
      record.effort.initial_draws = run->initial_draws;
      finished_.push_back({run->ticket, std::move(record)});
      std::erase_if(runs_, [run](const auto& owned) { return owned.get() == run; });
    }
    return std::exchange(finished_, {});
  }

 private:
  std::uint64_t seed_;
  lanes::Crew<TicketedRun> crew_;
  std::vector<std::unique_ptr<TicketedRun>> runs_;
  std::vector<Finished> finished_;
};

RealisationCrew::RealisationCrew(std::uint64_t seed, const lanes::Kernels& kernels)
    : implementation_(std::make_unique<Implementation>(seed, kernels)) {}
RealisationCrew::~RealisationCrew() = default;
bool RealisationCrew::wants_more() const { return implementation_->wants_more(); }
bool RealisationCrew::is_idle() const { return implementation_->is_idle(); }
void RealisationCrew::start(const Task& task, std::size_t ticket) { implementation_->start(task, ticket); }
std::vector<RealisationCrew::Finished> RealisationCrew::work() { return implementation_->work(); }

}  // namespace rocking::experiment

#include "rocking/realisation/lockstep.hpp"

#include "rocking/lanes/lane_scheduler.hpp"

namespace rocking {

class Lockstep::Implementation {
 public:
  Implementation(const lanes::Kernels& kernels, base::StopRequest stop) : scheduler_(kernels, stop) {}

  void run(std::span<StrobedMotion* const> motions, const std::function<void()>& look) {
    constexpr int steps_per_look = 512;
    if (look) look();
    for (StrobedMotion* motion : motions) scheduler_.add(*motion);
    for (int steps = 1; scheduler_.size() > 0; ++steps) {
      scheduler_.step();
      if (look && steps % steps_per_look == 0) look();
    }
    while (scheduler_.take_finished() != nullptr) {
    }
  }

 private:
  lanes::LaneScheduler<StrobedMotion> scheduler_;
};

Lockstep::Lockstep(const lanes::Kernels& kernels, base::StopRequest stop)
    : implementation_(std::make_unique<Implementation>(kernels, stop)) {}
Lockstep::~Lockstep() = default;
void Lockstep::run(std::span<StrobedMotion* const> motions, const std::function<void()>& look) {
  implementation_->run(motions, look);
}

}  // namespace rocking

#include "benchmarks/arkode_flow.hpp"

#include <algorithm>
#include <stdexcept>

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include "differential/peer/sundials.hpp"

namespace rocking::benchmarks {

using peer::Equations;
using peer::Stretch;
using peer::Vector;
using peer::sundials::require;
using peer::sundials::vector_of;
namespace sundials = peer::sundials;

struct ArkodeFlow::Solver {
  SUNContext context = nullptr;
  N_Vector state = nullptr;
  void* memory = nullptr;

  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    ERKStepFree(&memory);
    N_VDestroy(state);
    SUNContext_Free(&context);
  }
};

ArkodeFlow::ArkodeFlow(const peer::FlowAccuracy& accuracy)
    : accuracy_(accuracy), solver_(std::make_unique<Solver>()), last_step_(accuracy.longest_step) {
  Solver& s = *solver_;
  require(SUNContext_Create(nullptr, &s.context), "SUNContext_Create");
  s.state = N_VNew_Serial(static_cast<sunindextype>(Vector{}.size()), s.context);
  N_VConst(0.0, s.state);
  s.memory = ERKStepCreate(sundials::rates, 0.0, s.state, s.context);
  if (s.memory == nullptr) throw std::runtime_error("ARKODE: ERKStepCreate");
  require(ERKStepSetErrHandlerFn(s.memory, sundials::be_silent, nullptr), "ERKStepSetErrHandlerFn");
  require(ERKStepSetTableNum(s.memory, ARKODE_DORMAND_PRINCE_7_4_5), "ERKStepSetTableNum");
  require(ERKStepSetInterpolantDegree(s.memory, 5), "ERKStepSetInterpolantDegree");
  require(ERKStepSetMaxNumSteps(s.memory, 1'000'000), "ERKStepSetMaxNumSteps");
  require(ERKStepSetMaxStep(s.memory, accuracy.longest_step), "ERKStepSetMaxStep");
  require(ERKStepRootInit(s.memory, static_cast<int>(peer::guard_count), sundials::guards), "ERKStepRootInit");
  std::array<int, peer::guard_count> directions = sundials::falling();
  require(ERKStepSetRootDirection(s.memory, directions.data()), "ERKStepSetRootDirection");
  require(ERKStepSetNoInactiveRootWarn(s.memory), "ERKStepSetNoInactiveRootWarn");
}

ArkodeFlow::~ArkodeFlow() = default;

Stretch ArkodeFlow::follow(const Vector& start, double duration, double smallness, const Equations& equations) {
  Solver& s = *solver_;
  std::copy(start.begin(), start.end(), N_VGetArrayPointer(s.state));
  require(ERKStepReInit(s.memory, sundials::rates, 0.0, s.state), "ERKStepReInit");
  require(ERKStepSStolerances(s.memory, accuracy_.relative, accuracy_.absolute * smallness), "ERKStepSStolerances");
  require(ERKStepSetUserData(s.memory, const_cast<Equations*>(&equations)), "ERKStepSetUserData");
  require(ERKStepSetInitStep(s.memory, std::min(last_step_, duration)), "ERKStepSetInitStep");
  require(ERKStepSetStopTime(s.memory, duration), "ERKStepSetStopTime");
  Stretch stretch{duration, {}, {}};
  const int flag = ERKStepEvolve(s.memory, duration, s.state, &stretch.duration, ARK_NORMAL);
  require(flag, "ERKStepEvolve");
  require(ERKStepGetCurrentStep(s.memory, &last_step_), "ERKStepGetCurrentStep");
  stretch.state = vector_of(s.state);
  if (flag == ARK_ROOT_RETURN) {
    std::array<int, peer::guard_count> found{};
    require(ERKStepGetRootInfo(s.memory, found.data()), "ERKStepGetRootInfo");
    for (std::size_t i = 0; i < found.size(); ++i) stretch.fired[i] = found[i] != 0;
  }
  return stretch;
}

}  // namespace rocking::benchmarks

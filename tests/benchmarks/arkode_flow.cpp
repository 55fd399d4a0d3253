#include "benchmarks/arkode_flow.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

namespace rocking::benchmarks {

using peer::Equations;
using peer::Guards;
using peer::Stretch;
using peer::Vector;

namespace {

Vector vector_of(N_Vector vector) {
  Vector values{};
  std::copy_n(N_VGetArrayPointer(vector), values.size(), values.begin());
  return values;
}

void require(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(std::string("ARKODE: ") + what + " returned " + std::to_string(flag));
}

/// Called by ARKODE. `user` points to the Equations.
int rates(realtype time, N_Vector state, N_Vector result, void* user) {
  const Vector values = static_cast<const Equations*>(user)->rates(time, vector_of(state));
  std::copy(values.begin(), values.end(), N_VGetArrayPointer(result));
  return 0;
}

int guards(realtype time, N_Vector state, realtype* result, void* user) {
  const Guards values = static_cast<const Equations*>(user)->guards(time, vector_of(state));
  std::copy(values.begin(), values.end(), result);
  return 0;
}

void be_silent(int, const char*, const char*, char*, void*) {}  // `require` reports

}  // namespace

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
  s.memory = ERKStepCreate(rates, 0.0, s.state, s.context);
  if (s.memory == nullptr) throw std::runtime_error("ARKODE: ERKStepCreate");
  require(ERKStepSetErrHandlerFn(s.memory, be_silent, nullptr), "ERKStepSetErrHandlerFn");
  require(ERKStepSetTableNum(s.memory, ARKODE_DORMAND_PRINCE_7_4_5), "ERKStepSetTableNum");
  require(ERKStepSetInterpolantDegree(s.memory, 5), "ERKStepSetInterpolantDegree");
  require(ERKStepSetMaxNumSteps(s.memory, 1'000'000), "ERKStepSetMaxNumSteps");
  require(ERKStepSetMaxStep(s.memory, accuracy.longest_step), "ERKStepSetMaxStep");
  require(ERKStepRootInit(s.memory, static_cast<int>(peer::guard_count), guards), "ERKStepRootInit");
  std::array<int, peer::guard_count> falling;
  falling.fill(-1);
  require(ERKStepSetRootDirection(s.memory, falling.data()), "ERKStepSetRootDirection");
  require(ERKStepSetNoInactiveRootWarn(s.memory), "ERKStepSetNoInactiveRootWarn");
}

ArkodeFlow::~ArkodeFlow() = default;

Stretch ArkodeFlow::follow(const Vector& start, double duration, double smallness, const Equations& equations) {
  Solver& s = *solver_;
  std::copy(start.begin(), start.end(), N_VGetArrayPointer(s.state));
  require(ERKStepReInit(s.memory, rates, 0.0, s.state), "ERKStepReInit");
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

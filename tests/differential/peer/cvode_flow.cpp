#include "differential/peer/cvode_flow.hpp"

#include <algorithm>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "differential/peer/sundials.hpp"

namespace rocking::peer {

using sundials::require;
using sundials::vector_of;

struct CvodeFlow::Solver {
  SUNContext context = nullptr;
  N_Vector state = nullptr;
  SUNNonlinearSolver corrector = nullptr;
  void* memory = nullptr;

  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    CVodeFree(&memory);
    SUNNonlinSolFree(corrector);
    N_VDestroy(state);
    SUNContext_Free(&context);
  }
};

CvodeFlow::CvodeFlow(const FlowAccuracy& accuracy) : accuracy_(accuracy), solver_(std::make_unique<Solver>()) {
  Solver& s = *solver_;
  require(SUNContext_Create(nullptr, &s.context), "SUNContext_Create");
  s.state = N_VNew_Serial(static_cast<sunindextype>(Vector{}.size()), s.context);
  N_VConst(0.0, s.state);
  s.memory = CVodeCreate(CV_ADAMS, s.context);
  require(CVodeSetErrHandlerFn(s.memory, sundials::be_silent, nullptr), "CVodeSetErrHandlerFn");
  require(CVodeInit(s.memory, sundials::rates, 0.0, s.state), "CVodeInit");
  s.corrector = SUNNonlinSol_FixedPoint(s.state, 0, s.context);
  require(CVodeSetNonlinearSolver(s.memory, s.corrector), "CVodeSetNonlinearSolver");
  require(CVodeSetMaxNumSteps(s.memory, 1'000'000), "CVodeSetMaxNumSteps");
  require(CVodeSetMaxStep(s.memory, accuracy.longest_step), "CVodeSetMaxStep");
  require(CVodeRootInit(s.memory, static_cast<int>(guard_count), sundials::guards), "CVodeRootInit");
  std::array<int, guard_count> directions = sundials::falling();
  require(CVodeSetRootDirection(s.memory, directions.data()), "CVodeSetRootDirection");
  require(CVodeSetNoInactiveRootWarn(s.memory), "CVodeSetNoInactiveRootWarn");
}

CvodeFlow::~CvodeFlow() = default;

Stretch CvodeFlow::follow(const Vector& start, double duration, double smallness, const Equations& equations) {
  Solver& s = *solver_;
  std::copy(start.begin(), start.end(), N_VGetArrayPointer(s.state));
  require(CVodeReInit(s.memory, 0.0, s.state), "CVodeReInit");
  require(CVodeSStolerances(s.memory, accuracy_.relative, accuracy_.absolute * smallness), "CVodeSStolerances");
  require(CVodeSetUserData(s.memory, const_cast<Equations*>(&equations)), "CVodeSetUserData");
  require(CVodeSetStopTime(s.memory, duration), "CVodeSetStopTime");
  Stretch stretch{duration, {}, {}};
  const int flag = CVode(s.memory, duration, s.state, &stretch.duration, CV_NORMAL);
  require(flag, "CVode");
  stretch.state = vector_of(s.state);
  if (flag == CV_ROOT_RETURN) {
    std::array<int, guard_count> found{};
    require(CVodeGetRootInfo(s.memory, found.data()), "CVodeGetRootInfo");
    for (std::size_t i = 0; i < guard_count; ++i) stretch.fired[i] = found[i] != 0;
  }
  return stretch;
}

}  // namespace rocking::peer

#include "differential/peer/cvode_flow.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace rocking::peer {
namespace {

Vector vector_of(N_Vector vector) {
  Vector values{};
  std::copy_n(N_VGetArrayPointer(vector), values.size(), values.begin());
  return values;
}

void require(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(std::string("CVODE: ") + what + " returned " + std::to_string(flag));
}

/// Called by CVODE. `user` points to the Equations.
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
  require(CVodeSetErrHandlerFn(s.memory, be_silent, nullptr), "CVodeSetErrHandlerFn");
  require(CVodeInit(s.memory, rates, 0.0, s.state), "CVodeInit");
  s.corrector = SUNNonlinSol_FixedPoint(s.state, 0, s.context);
  require(CVodeSetNonlinearSolver(s.memory, s.corrector), "CVodeSetNonlinearSolver");
  require(CVodeSetMaxNumSteps(s.memory, 1'000'000), "CVodeSetMaxNumSteps");
  require(CVodeSetMaxStep(s.memory, accuracy.longest_step), "CVodeSetMaxStep");
  require(CVodeRootInit(s.memory, static_cast<int>(guard_count), guards), "CVodeRootInit");
  std::array<int, guard_count> falling;
  falling.fill(-1);
  require(CVodeSetRootDirection(s.memory, falling.data()), "CVodeSetRootDirection");
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

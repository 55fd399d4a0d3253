#pragma once

#include <array>

#include <nvector/nvector_serial.h>
#include <sundials/sundials_types.h>

#include "differential/peer/flow.hpp"

/// What CVODE and ARKODE have in common: functions that they call, and what is made of their answers.
namespace rocking::peer::sundials {

[[nodiscard]] Vector vector_of(N_Vector vector);

/// Throws std::runtime_error where the answer of `what` says that it failed.
void require(int flag, const char* what);

/// Called by SUNDIALS. `user` points to the Equations.
int rates(realtype time, N_Vector state, N_Vector result, void* user);
int guards(realtype time, N_Vector state, realtype* result, void* user);

/// An error handler; `require` reports.
void be_silent(int code, const char* module, const char* function, char* message, void* user);

/// Directions of roots: a guard fires where it falls through 0.
[[nodiscard]] std::array<int, guard_count> falling();

}  // namespace rocking::peer::sundials

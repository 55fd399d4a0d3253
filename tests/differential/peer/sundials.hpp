#pragma once

#include <array>

#include <nvector/nvector_serial.h>
#include <sundials/sundials_types.h>

#include "differential/peer/flow.hpp"

/// The functions that CVODE calls, and the handling of its return values.
namespace rocking::peer::sundials {

[[nodiscard]] Vector vector_of(N_Vector vector);

/// Throws std::runtime_error if the return value of `what` is a failure.
void require(int flag, const char* what);

/// Called by SUNDIALS. `user` points to the Equations.
int rates(realtype time, N_Vector state, N_Vector result, void* user);
int guards(realtype time, N_Vector state, realtype* result, void* user);

/// An error handler that prints nothing; `require` reports.
void be_silent(int code, const char* module, const char* function, char* message, void* user);

/// Directions of roots: a guard fires when it falls through 0.
[[nodiscard]] std::array<int, guard_count> falling();

}  // namespace rocking::peer::sundials

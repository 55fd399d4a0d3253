#pragma once

#include "process_pool.hpp"
#include "session.hpp"

namespace rocking::program::mpi {

/// Runs pairs as the first process. Only this process has the store. It sends blocks of pairs, each of about a quarter
/// of a second, to idle helpers, receives the results, and runs pairs itself at the same time.
[[nodiscard]] ProcessPool pool_of(const Session& session);

}  // namespace rocking::program::mpi

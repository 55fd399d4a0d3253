#pragma once

#include "session.hpp"

namespace rocking::program::mpi {

/// The loop of every process but the first: runs the blocks that it receives until it is told to quit.
void help(const Session& session);

}  // namespace rocking::program::mpi

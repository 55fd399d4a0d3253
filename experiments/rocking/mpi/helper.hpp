#pragma once

#include "session.hpp"

namespace rocking::program::mpi {

/// What every process but the first does: runs the blocks that it is given, until it is told to quit.
void help(const Session& session);

}  // namespace rocking::program::mpi

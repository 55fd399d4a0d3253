#pragma once

#include "crew.hpp"
#include "session.hpp"

namespace rocking::program::mpi {

/// The first process and its helpers. It alone has the store; it hands out blocks of pairs, each of about a quarter of a
/// second, to whoever is free, takes in what came of them, and runs pairs itself beside that.
[[nodiscard]] Crew crew_of(const Session& session);

}  // namespace rocking::program::mpi

#pragma once

namespace rocking::program::mpi {

/// Where mpirun started this process as one of several, becomes `rocking-mpi`, which stands beside it; returns where there is
/// nothing of that kind to do. Throws UsageError where that program is not there.
void become_one_of_several(char** argv);

}  // namespace rocking::program::mpi

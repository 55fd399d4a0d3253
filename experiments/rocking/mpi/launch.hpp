#pragma once

namespace rocking::program::mpi {

/// If mpirun started this process as one of several, replaces it by the program `rocking-mpi` in the same folder;
/// otherwise returns. Throws UsageError if that program is missing.
void become_one_of_several(char** argv);

}  // namespace rocking::program::mpi

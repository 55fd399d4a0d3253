#include "launch.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "exit_code.hpp"

namespace rocking::program::mpi {

// Loading the MPI libraries takes longer than most commands, so only processes started by mpirun load them.
void become_one_of_several(char** argv) {
  const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (size == nullptr || std::string(size) == "1") return;
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "rocking-mpi";
  ::execv(program.c_str(), argv);
  throw UsageError(
      fmt::format("mpirun started {} processes, but {} is not there: this `rocking` was built without MPI (Debian: "
                  "libopenmpi-dev). Build it with MPI, or divide the run with --shard",
                  size, program.string()));
}

}  // namespace rocking::program::mpi

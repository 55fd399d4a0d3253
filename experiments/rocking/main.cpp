#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "exit_code.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "program.hpp"

namespace {

using namespace rocking::program;

/// If mpirun started this process as one of several, replaces it by the program `rocking-mpi` in the same folder, since
/// loading the MPI libraries takes longer than most commands; otherwise returns. Throws UsageError if that program is
/// missing.
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

}  // namespace

int main(int argc, char** argv) {
  try {
    become_one_of_several(argv);
  } catch (const UsageError& error) {
    print_notice(error.what());
    return static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(carry_out_command_line(argc, argv, {.threads = available_threads()}));
}

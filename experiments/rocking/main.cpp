#include "exit_code.hpp"
#include "machine.hpp"
#include "mpi/launch.hpp"
#include "output.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  using namespace rocking::program;
  try {
    mpi::become_one_of_several(argv);
  } catch (const UsageError& error) {
    print_notice(error.what());
    return static_cast<int>(ExitCode::usage);
  }
  return static_cast<int>(carry_out_command_line(argc, argv, {.threads = available_threads()}));
}

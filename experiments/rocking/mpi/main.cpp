// `rocking` as started by mpirun: the same commands; `run` and `resume` distribute the work over the processes.

#include "interrupt.hpp"
#include "program.hpp"
#include "session.hpp"

int main(int argc, char** argv) {
  using namespace rocking::program;
  const mpi::Session session(argc, argv);
  if (session.rank() != 0) {
    static_cast<void>(stop_on_interrupt());
    mpi::help(session);
    return 0;
  }
  const ExitCode code = carry_out_command_line(argc, argv, mpi::pool_of(session));
  session.send_to_others(mpi::Tag::quit, {});
  return static_cast<int>(code);
}

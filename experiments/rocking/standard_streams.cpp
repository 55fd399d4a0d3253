#include "standard_streams.hpp"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace rocking::program {
namespace {

// The lowest free number is the one that open gives; those below were filled before.
void hold(int number, int mode) {
  if (::fcntl(number, F_GETFD) >= 0 || errno != EBADF) return;
  static_cast<void>(::open("/dev/null", mode));
}

}  // namespace

void hold_standard_streams() {
  hold(STDIN_FILENO, O_RDONLY);
  hold(STDOUT_FILENO, O_RDONLY);  // a write fails with EBADF, as it would on one that is closed
  hold(STDERR_FILENO, O_WRONLY);
}

}  // namespace rocking::program

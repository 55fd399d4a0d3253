#include "standard_streams.hpp"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace rocking::program {
namespace {

// open returns the lowest free number; the lower ones are in use already.
void hold(int number, int mode) {
  if (::fcntl(number, F_GETFD) >= 0 || errno != EBADF) return;
  static_cast<void>(::open("/dev/null", mode));
}

}  // namespace

void hold_standard_streams() {
  hold(STDIN_FILENO, O_RDONLY);
  hold(STDOUT_FILENO, O_RDONLY);  // a write fails with EBADF, as on a closed descriptor
  hold(STDERR_FILENO, O_WRONLY);
}

}  // namespace rocking::program

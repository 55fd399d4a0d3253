#pragma once

#include <stdexcept>

namespace rocking::program {

/// What the program tells the shell. Where BSD's sysexits.h has a number for it, that one.
enum class ExitCode : int {
  done = 0,
  check_failed = 1,
  usage = 64,
  bad_input = 65,
  missing_input = 66,
  our_bug = 70,
  input_output = 74,
  stopped_early = 75,
  interrupted = 130,
};

/// An input file that is not there or cannot be read.
class MissingInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A command line that cannot be followed.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something on the disk stands in the way.
class InTheWay : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rocking::program

#pragma once

#include <stdexcept>
#include <system_error>

#include "rocking/base/error.hpp"

namespace rocking::program {

/// Exit codes of the program; those of BSD's sysexits.h where it has one.
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

/// An input file is missing or cannot be read.
class MissingInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What `read` gives. A file that it cannot read is missing input.
template <class Read>
auto input_of(Read read) {
  try {
    return read();
  } catch (const base::FolderError&) {
    throw;
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

/// The command line is invalid.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or folder prevents the command, for example a run that must not be overwritten.
class InTheWay : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rocking::program

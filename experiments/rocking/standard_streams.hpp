#pragma once

namespace rocking::program {

/// Opens standard input, output and error where this process was started without them, so that no other file gets their
/// numbers. Writing to an output that was closed stays an error; what is said on a standard error that was closed is dropped.
void hold_standard_streams();

}  // namespace rocking::program

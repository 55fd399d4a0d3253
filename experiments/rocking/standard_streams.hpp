#pragma once

namespace rocking::program {

/// Opens standard input, output and error if this process was started without them, so that no other file gets their
/// numbers. Writing to a closed standard output remains an error; text for a closed standard error is dropped.
void hold_standard_streams();

}  // namespace rocking::program

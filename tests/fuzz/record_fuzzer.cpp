// A libFuzzer target; how to run it: lib/docs/fuzzing.md.

#include <cstddef>
#include <cstdint>

#include "fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  rocking::fuzz::try_record({reinterpret_cast<const char*>(bytes), size});
  return 0;
}

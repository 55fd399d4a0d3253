// A libFuzzer target for the function ROCKING_FUZZED of fuzz/targets.hpp or fuzz/question_target.hpp; how to run it: reports/evidence/fuzzing.md.

#include <cstddef>
#include <cstdint>

#include "fuzz/question_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  rocking::fuzz::ROCKING_FUZZED({reinterpret_cast<const char*>(bytes), size});
  return 0;
}

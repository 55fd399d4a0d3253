#include "rocking/random/philox.hpp"

#include <Random123/philox.h>

namespace rocking::random {

Words philox(const Words& counter, std::uint64_t key) {
  const r123::Philox4x32::ctr_type input{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type words{{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U)}};
  const auto output = r123::Philox4x32{}(input, words);  // ten rounds is the default of Random123 for this width
  return {output[0], output[1], output[2], output[3]};
}

}  // namespace rocking::random

#include "rocking/random/draws.hpp"

#include "rocking/random/uniform.hpp"

namespace rocking::random {

std::uint64_t Draws::bits(Source source, std::uint64_t index) const {
  return half_of(block_at(source, index / 2), index % 2);
}

double Draws::uniform(Source source, std::uint64_t index) const { return uniform_from_zero(bits(source, index)); }

double Draws::standard_normal(Source source, std::uint64_t index) const {
  return standard_normal_pair(source, index / 2)[index];
}

NormalPair Draws::standard_normal_pair(Source source, std::uint64_t block) const {
  return box_muller(block_at(source, block));
}

Words Draws::block_at(Source source, std::uint64_t block) const {
  const auto low = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  const auto high = [](std::uint64_t number) { return static_cast<std::uint32_t>(number >> 32U); };
  const std::uint32_t purpose = std::uint32_t{static_cast<std::uint8_t>(source)} << 24U;
  return philox({low(block), high(block), low(realisation_), purpose | high(realisation_)}, seed_);
}

}  // namespace rocking::random

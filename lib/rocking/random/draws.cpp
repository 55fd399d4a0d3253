#include "rocking/random/draws.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "rocking/random/normal_kernels.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

/// Number of blocks to compute next if `numbers` draws are wanted: enough for all of them, at most one batch, with few
/// unused.
std::size_t blocks_for(std::size_t numbers) {
  constexpr std::size_t step = 2 * BlockBatch::step;
  return std::min(BlockBatch::largest, (numbers + step - 1) / step * BlockBatch::step);
}

}  // namespace

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

void Draws::standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const {
  static const NormalKernels best = available_normal_kernels().back();
  standard_normals(source, first_index, numbers, best);
}

void Draws::standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers,
                             const NormalKernels& kernels) const {
  // The neighbours of the last counter are computed in the same batch and may wrap round; they are never returned.
  ROCKING_EXPECT(numbers.empty() || numbers.size() - 1 <= std::numeric_limits<std::uint64_t>::max() - first_index);
  std::uint64_t block = first_index / 2;
  std::size_t skipped = first_index % 2;
  BlockBatch blocks;
  std::array<double, 2 * BlockBatch::largest> spare;
  while (!numbers.empty()) {
    blocks.size = blocks_for(skipped + numbers.size());
    kernels.make_blocks(counter_of(source, block), seed_, blocks);
    const std::size_t taken = std::min(numbers.size(), 2 * blocks.size - skipped);
    if (taken == 2 * blocks.size) {
      kernels.make_normals(blocks, numbers.first(taken));
    } else {
      kernels.make_normals(blocks, std::span(spare).first(2 * blocks.size));
      std::copy_n(spare.begin() + static_cast<std::ptrdiff_t>(skipped), taken, numbers.begin());
    }
    numbers = numbers.subspan(taken);
    block += blocks.size;
    skipped = 0;
  }
}

Words Draws::counter_of(Source source, std::uint64_t block) const {
  const auto low = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  const auto high = [](std::uint64_t number) { return static_cast<std::uint32_t>(number >> 32U); };
  const std::uint32_t purpose = std::uint32_t{static_cast<std::uint8_t>(source)} << 24U;
  return {low(block), high(block), low(realisation_), purpose | high(realisation_)};
}

Words Draws::block_at(Source source, std::uint64_t block) const { return philox(counter_of(source, block), seed_); }

}  // namespace rocking::random

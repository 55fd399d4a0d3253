#include "rocking/studies/cost/sample.hpp"

#include <bit>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

std::size_t reversed_bits(std::size_t number, std::size_t bits) {
  std::size_t reversed = 0;
  for (std::size_t i = 0; i < bits; ++i) reversed |= ((number >> i) & 1U) << (bits - 1 - i);
  return reversed;
}

}  // namespace

CostSample::CostSample(const Experiment& experiment) {
  const std::size_t conditions = experiment.conditions.size();
  const auto bits = static_cast<std::size_t>(std::bit_width(conditions - 1));
  for (std::size_t i = 0; i < std::bit_ceil(conditions); ++i) {
    const std::size_t condition = reversed_bits(i, bits);
    if (condition >= conditions) continue;
    all_.push_back(condition);
    if (is_random(experiment.conditions[condition].scene)) random_.push_back(condition);
  }
}

std::optional<std::uint64_t> CostSample::size() const {
  if (random_.empty()) return all_.size();
  return std::nullopt;
}

RealisationKey CostSample::at(std::uint64_t index) const {
  if (index < all_.size()) return {.condition = all_[index], .realisation = index};
  ROCKING_EXPECT(!random_.empty());
  return {.condition = random_[(index - all_.size()) % random_.size()], .realisation = index};
}

}  // namespace rocking

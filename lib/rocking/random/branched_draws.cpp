#include "rocking/random/branched_draws.hpp"

#include <algorithm>
#include <cstddef>

namespace rocking::random {
namespace {

std::size_t place_of(Source source) { return static_cast<std::size_t>(source) - 1; }

}  // namespace

double BranchedDraws::uniform(Source source, std::uint64_t index) const {
  if (history_ == nullptr) return draws_.uniform(source, index);
  if (const double* number = given(source, index)) return *number;
  return after(branches_until(source, index)).uniform(source, index);
}

double BranchedDraws::standard_normal(Source source, std::uint64_t index) const {
  if (history_ == nullptr) return draws_.standard_normal(source, index);
  if (const double* number = given(source, index)) return *number;
  return after(branches_until(source, index)).standard_normal(source, index);
}

void BranchedDraws::standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const {
  if (history_ == nullptr) return draws_.standard_normals(source, first_index, numbers);
  const std::size_t made = branches_until(source, first_index);
  after(made).standard_normals(source, first_index, numbers);
  for (std::size_t i = made; i < history_->branches.size(); ++i) {
    const std::uint64_t from = history_->branches[i].from[place_of(source)];
    if (from - first_index >= numbers.size()) continue;
    after(i + 1).standard_normals(source, from, numbers.subspan(static_cast<std::size_t>(from - first_index)));
  }
}

const double* BranchedDraws::given(Source source, std::uint64_t index) const {
  if (index != 0) return nullptr;
  const auto found =
      std::ranges::find_if(history_->given, [source](const GivenDraw& draw) { return draw.source == source; });
  return found == history_->given.end() ? nullptr : &found->number;
}

std::size_t BranchedDraws::branches_until(Source source, std::uint64_t index) const {
  if (place_of(source) >= sources_along_the_way) return 0;
  std::size_t count = history_->branches.size();
  while (count > 0 && history_->branches[count - 1].from[place_of(source)] > index) --count;
  return count;
}

Draws BranchedDraws::after(std::size_t branches) const {
  return branches == 0 ? draws_ : draws_.of(history_->branches[branches - 1].number);
}

}  // namespace rocking::random

#include "rocking/random/branched_draws.hpp"

#include <algorithm>
#include <cstddef>

namespace rocking::random {
namespace {

/// The index from which on the branch has draws of its own; `source` is drawn along the way.
std::uint64_t start_of(const Branch& branch, Source source) { return branch.from[static_cast<std::size_t>(source)]; }

}  // namespace

double BranchedDraws::uniform(Source source, std::uint64_t index) const {
  const double* number = history_ == nullptr ? nullptr : given(source, index);
  return number == nullptr ? draws_.uniform(source, index) : *number;
}

double BranchedDraws::standard_normal(Source source, std::uint64_t index) const {
  if (history_ == nullptr) return draws_.standard_normal(source, index);
  const double* number = given(source, index);
  return number != nullptr ? *number : origin(source, index).standard_normal(source, index);
}

void BranchedDraws::standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const {
  if (history_ == nullptr) return draws_.standard_normals(source, first_index, numbers);
  origin(source, first_index).standard_normals(source, first_index, numbers);
  if (!is_drawn_along_the_way(source)) return;
  for (std::size_t i = last_branch(source, first_index); i < history_->branches.size(); ++i) {
    const Branch& later = history_->branches[i];
    const std::uint64_t skipped = start_of(later, source) - first_index;
    if (skipped >= numbers.size()) continue;
    draws_.of(later.number)
        .standard_normals(source, first_index + skipped, numbers.subspan(static_cast<std::size_t>(skipped)));
  }
}

const double* BranchedDraws::given(Source source, std::uint64_t index) const {
  // The last ones are asked for most.
  const auto found = std::find_if(history_->given.rbegin(), history_->given.rend(),
                                  [&](const GivenDraw& draw) { return draw.source == source && draw.index == index; });
  return found == history_->given.rend() ? nullptr : &found->number;
}

std::size_t BranchedDraws::last_branch(Source source, std::uint64_t index) const {
  std::size_t count = is_drawn_along_the_way(source) ? history_->branches.size() : 0;
  while (count > 0 && start_of(history_->branches[count - 1], source) > index) --count;
  return count;
}

Draws BranchedDraws::origin(Source source, std::uint64_t index) const {
  const std::size_t last = last_branch(source, index);
  return last == 0 ? draws_ : draws_.of(history_->branches[last - 1].number);
}

}  // namespace rocking::random

#include "rocking/random/branched_draws.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rocking::random {
namespace {

/// The index from which on the branch has draws of its own; `source` is drawn along the way.
std::uint64_t start_of(const Branch& branch, Source source) { return branch.from[static_cast<std::size_t>(source)]; }

double blended(double number, double other, double size) {
  return size == 1.0 ? other : std::sqrt(1.0 - size * size) * number + size * other;
}

}  // namespace

double BranchedDraws::uniform(Source source, std::uint64_t index) const {
  const double* number = history_ == nullptr ? nullptr : given(source, index);
  return number == nullptr ? draws_.uniform(source, index) : *number;
}

double BranchedDraws::standard_normal(Source source, std::uint64_t index) const {
  if (history_ == nullptr) return draws_.standard_normal(source, index);
  if (const double* number = given(source, index)) return *number;
  const std::size_t first = origin(source, index);
  double number = after(first).standard_normal(source, index);
  if (!is_drawn_along_the_way(source)) return number;
  for (std::size_t i = first; i < history_->branches.size(); ++i) {
    const Branch& branch = history_->branches[i];
    if (start_of(branch, source) > index) continue;
    number = blended(number, draws_.of(branch.number).standard_normal(source, index), branch.size);
  }
  return number;
}

void BranchedDraws::standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const {
  if (history_ == nullptr) return draws_.standard_normals(source, first_index, numbers);
  const std::size_t first = origin(source, first_index);
  after(first).standard_normals(source, first_index, numbers);
  if (!is_drawn_along_the_way(source)) return;
  std::vector<double> others(numbers.size());
  for (std::size_t i = first; i < history_->branches.size(); ++i) {
    const Branch& branch = history_->branches[i];
    const std::uint64_t from = std::max(start_of(branch, source), first_index);
    if (from - first_index >= numbers.size()) continue;
    const std::span<double> changed = numbers.subspan(static_cast<std::size_t>(from - first_index));
    draws_.of(branch.number).standard_normals(source, from, std::span(others).first(changed.size()));
    for (std::size_t k = 0; k < changed.size(); ++k) changed[k] = blended(changed[k], others[k], branch.size);
  }
}

const double* BranchedDraws::given(Source source, std::uint64_t index) const {
  if (index != 0) return nullptr;
  const auto found =
      std::ranges::find_if(history_->given, [source](const GivenDraw& draw) { return draw.source == source; });
  return found == history_->given.end() ? nullptr : &found->number;
}

std::size_t BranchedDraws::origin(Source source, std::uint64_t index) const {
  if (!is_drawn_along_the_way(source)) return 0;
  std::size_t count = history_->branches.size();
  const auto draws_anew = [&](const Branch& b) { return b.size == 1.0 && start_of(b, source) <= index; };
  while (count > 0 && !draws_anew(history_->branches[count - 1])) --count;
  return count;
}

Draws BranchedDraws::after(std::size_t branches) const {
  return branches == 0 ? draws_ : draws_.of(history_->branches[branches - 1].number);
}

}  // namespace rocking::random

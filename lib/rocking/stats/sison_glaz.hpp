#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Simultaneous intervals k/n - c/n ... k/n + (c + 2 gamma)/n for all categories of a multinomial sample, cut to [0,
/// 1].
///
/// c is the first whole number with nu(c) <= confidence < nu(c + 1), where nu(c) is the probability that every count of
/// a sample with the observed proportions lies within c of the observed one; gamma interpolates. nu is approximated as
/// the authors do: truncated Poisson laws, conditioned on their sum by an Edgeworth expansion; nu(0) is exact.
///
/// For seven categories of like size or more; the same width for all, rare ones included. For few it covers less often
/// than promised: all of three, at 95 % and n = 30, with 89 % on the average. Absent where no c will do: if one
/// category took all trials, nu(0) = 1; if it took all but a few, the expansion stays below a high confidence for every
/// c.
/// Source: Sison & Glaz (1995), J. Am. Stat. Assoc. 90, 366-369. Cost: about n Poisson terms for each category that occurs,
/// for c is about sqrt(n); some hundred times that where no c will do.
[[nodiscard]] std::optional<std::vector<Interval>> sison_glaz(std::span<const std::uint64_t> counts, double confidence);

}  // namespace rocking::stats

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Simultaneous intervals k/n - c/n ... k/n + (c + 2 gamma)/n for all categories of a multinomial sample, limited to
/// [0, 1].
///
/// c is the first integer with nu(c) <= confidence < nu(c + 1); gamma interpolates. nu(c) is the probability that every
/// count of a sample with the observed proportions lies within c of the observed count. It is approximated as by the
/// authors: truncated Poisson laws, conditioned on their sum by an Edgeworth expansion. nu(0) is exact.
///
/// Suitable for seven or more categories of similar size; the width is the same for all, also for rare ones. For few
/// categories the coverage is lower than promised: for three at 95 % and n = 30 it is 89 % on average. Absent if no c
/// satisfies the condition: if one category has all trials, nu(0) = 1; if it has nearly all, the expansion stays below
/// a high confidence for every c. Cost: about n Poisson terms for each category that occurs, since c is about sqrt(n);
/// some hundred times as much if no c exists. Source: Sison & Glaz (1995), J. Am. Stat. Assoc. 90, 366-369.
[[nodiscard]] std::optional<std::vector<Interval>> sison_glaz(std::span<const std::uint64_t> counts, double confidence);

}  // namespace rocking::stats

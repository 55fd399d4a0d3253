#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/stats/suite_bootstrap.hpp"

namespace rocking::stats {

/// Two independent uniform numbers in [0, 1) that belong to trial `number` of bootstrap sample `sample`. A pure
/// function of both, so that the test repeats to the bit; called by several threads.
using BootstrapNumbers = std::function<std::array<double, 2>(std::uint64_t sample, std::uint64_t number)>;

/// Tests the law by its deviance. `levels` are those to which it was fitted.
///
/// Trials with one number depend on each other across the levels in an unknown way, so the deviance has no chi-squared
/// distribution. Its distribution under the law is found by a bootstrap whose probabilities are those of the law and
/// whose dependence is that of the data: a sample draws trial numbers with replacement. The outcomes of a drawn number
/// correspond to a uniform number at each level, in [0, k/n) if the event happened and in [k/n, 1) if not; its place
/// within that range is one more random number for all levels. The event happens in the sample where this number is
/// less than the probability by the law. The law is fitted to each sample anew. Source: Davison & Hinkley (1997),
/// Bootstrap Methods and their Application, section 4.4 (tests by parametric bootstrap); Rueschendorf (2009), J. Stat.
/// Plan. Inference 139, 3921-3927 (distributional transform).
///
/// Cost: samples x (trials + one fit). A sample is a part.
[[nodiscard]] LackOfFit lack_of_fit(const std::vector<IntensityLevel>& levels, const LognormalFragility& law,
                                    std::uint64_t samples, const BootstrapNumbers& numbers,
                                    const base::ManyParts& how = {});

/// Distance of the shares of a suite from its law, over the intensities k, with the mean share s_k over the n_k records
/// there and the probability P_k by the law:
///
///     sum over k of 2 n_k [s_k ln(s_k/P_k) + (1 - s_k) ln((1 - s_k)/(1 - P_k))]
///
/// It is the deviance that n_k independent records with one trial each would have.
[[nodiscard]] double suite_deviance(const SuiteLevels& suite, const SuiteLaw& law);

/// Tests the law of a suite by this deviance. `law` is that of fit_suite(suite).
///
/// A parametric bootstrap over records: a sample has as many records, levels and trials as the suite, each record with a
/// capacity by the law and with independent trials around it. The law is fitted to each sample anew, so that a sample has
/// its own distance from its own law. Samples without a law are not counted; absent where more than a tenth has none.
/// Source: Davison & Hinkley (1997), Bootstrap Methods and their Application, section 4.4. Its size and power are
/// measured (reports/evidence/intervals.md).
///
/// Cost: one fit each sample, which is a part.
[[nodiscard]] std::optional<LackOfFit> suite_lack_of_fit(const SuiteLevels& suite, const SuiteLaw& law,
                                                         std::uint64_t samples, const RecordDraws& draws,
                                                         const base::ManyParts& how = {});

}  // namespace rocking::stats

#pragma once

#include <cstdint>
#include <optional>

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/fragility.hpp"

namespace rocking::stats {

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

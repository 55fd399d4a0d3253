#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/stats/histogram.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/normal_tails.hpp"
#include "rocking/stats/normality.hpp"

namespace rocking::report {

/// Value of `format` in what `rocking check-normal --json` prints.
inline constexpr std::string_view check_normal_format = "rocking.check_normal/1";

/// A sampler's sample beside the law that it promises.
struct NormalCheck {
  std::string sampler;  ///< `box-muller`, ...
  std::uint64_t seed = 0;
  stats::NormalLaw law;
  stats::SampleMoments moments;
  stats::Moment pair_correlation;  ///< within the pairs of one transformation
  stats::Moment lag_correlation;   ///< of neighbours
  stats::TestOfFit jarque_bera;
  stats::TestOfFit dagostino_pearson;
  stats::TestOfFit anderson_darling;
  stats::TestOfFit kolmogorov_smirnov;
  std::array<stats::TailCount, 3> tails;
  stats::Histogram histogram;
};

[[nodiscard]] std::string check_normal_text(const NormalCheck& check);

/// The same for a reader at a terminal.
[[nodiscard]] std::string check_normal_summary(const NormalCheck& check);

}  // namespace rocking::report

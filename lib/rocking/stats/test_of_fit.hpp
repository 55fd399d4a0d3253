#pragma once

namespace rocking::stats {

/// A test of fit: how far the sample is from the law, and how probable that or more is under the law.
struct TestOfFit {
  double statistic = 0.0;
  double p_value = 1.0;
};

}  // namespace rocking::stats

#pragma once

#include <optional>
#include <vector>

#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/mixed_probit.hpp"

namespace rocking::stats {

/// The counts of a suite with u = ln intensity - centre.
struct CentredSuite {
  double centre = 0.0;
  std::vector<RecordCounts> records;
  bool is_unresolved = false;  ///< the outcome of some trial is not known
};

[[nodiscard]] CentredSuite centred(const SuiteLevels& suite);

/// `start`: of the search where not every record is a step; null: several.
[[nodiscard]] SuiteFit fit_centred(const CentredSuite& suite, const MixedProbitStart* start = nullptr);

/// At the law of the whole suite, from which a search over a bootstrap sample starts. Absent where its records are steps.
[[nodiscard]] std::optional<MixedProbitStart> start_at(const CentredSuite& suite, const SuiteLaw& law);

}  // namespace rocking::stats

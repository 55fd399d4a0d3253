#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/write_suite.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/annual_rate.hpp"
#include "rocking/studies/fragility.hpp"

namespace rocking {

inline constexpr std::string_view fragility_format = "rocking.fragility/1";

/// The curve of one motion; with the annual rate where a hazard curve is given.
struct ShownCurve {
  FragilityCurve curve;
  std::optional<AnnualRate> rate = std::nullopt;
};

/// The curve of a suite.
struct ShownSuite {
  SuiteCurve curve;
  bool has_hazard = false;                        ///< whether a hazard curve is given
  std::optional<AnnualRate> rate = std::nullopt;  ///< absent also where the suite has no law
};

/// The curves of a run.
struct RunFragility {
  Experiment experiment;
  std::vector<ShownCurve> curves = {};
  std::vector<ShownSuite> suites = {};
  std::vector<IncrementalAnalysis> incremental = {};
};

/// `rocking.fragility/1` (lib/docs/formats.md).
[[nodiscard]] std::string fragility_text(const std::vector<RunFragility>& runs);

/// The curves as text: a table for each curve, and the fitted function.
[[nodiscard]] std::string fragility_table(const std::vector<RunFragility>& runs,
                                          RecordTable records = RecordTable::omitted);

}  // namespace rocking

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rocking/base/build_info.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/report/json_writer.hpp"

namespace rocking::report {

/// Value of `format` in a report.
inline constexpr std::string_view report_format = "rocking.report/1";

/// What may differ between two equal runs. The caller reads it from its surroundings; this library never does.
struct SystemFacts {
  base::BuildInfo build;
  std::string machine;      ///< processor and operating system
  std::string start;        ///< ISO 8601 in UTC, as `2012-02-01T12:00:00Z`
  double duration_s = 0.0;  ///< wall-clock time of the run [s]
  unsigned threads = 1;
};

/// Writes the report of a run as JSON text, piece by piece. All but `system` are the same bytes for equal input. Its memory does
/// not grow with the number of conditions.
void write_report(const TextSink& sink, const experiment::Experiment& experiment,
                  const experiment::ExperimentResult& result, const SystemFacts& system);

/// The same without `result.conditions` and `internal`, which grow with the number of conditions.
[[nodiscard]] Json report_frame(const experiment::Experiment& experiment, const experiment::ExperimentResult& result,
                                const SystemFacts& system);

/// The text as a whole.
[[nodiscard]] std::string report_text(const experiment::Experiment& experiment,
                                      const experiment::ExperimentResult& result, const SystemFacts& system);

}  // namespace rocking::report

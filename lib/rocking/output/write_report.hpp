#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json_writer.hpp"

namespace rocking {

/// Facts that may differ between two equal runs. The caller provides them; the library does not read them itself.
struct SystemFacts {
  base::BuildInfo build;
  std::string machine;      ///< processor and operating system
  std::string start;        ///< ISO 8601 in UTC, as `2012-02-01T12:00:00Z`
  double duration_s = 0.0;  ///< wall-clock time of the run [s]
  unsigned threads = 1;
};

/// Writes the report of a run as JSON text, piece by piece. All but `system` has the same bytes for equal input. Its
/// memory does not grow with the number of conditions.
void write_report(const TextSink& sink, const Experiment& experiment, const ExperimentResult& result,
                  const SystemFacts& system);

/// The same without `result.conditions` and `internal`, which grow with the number of conditions.
[[nodiscard]] Json report_frame(const Experiment& experiment, const ExperimentResult& result,
                                const SystemFacts& system);

/// The text as a whole.
[[nodiscard]] std::string report_text(const Experiment& experiment, const ExperimentResult& result,
                                      const SystemFacts& system);

}  // namespace rocking

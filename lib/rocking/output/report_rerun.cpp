#include "rocking/output/report_rerun.hpp"

#include "rocking/base/build_info.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/report_differences.hpp"

namespace rocking {

ReportRerun rerun_report(std::string_view report, const Experiment& experiment, const RunOptions& options) {
  ReportRerun again;
  const auto result = run(experiment, options);
  again.was_stopped = !result.has_value();
  if (again.was_stopped) return again;
  for (const auto& condition : result->conditions) again.checked += condition.realisations;
  // Machine and time are not compared.
  const SystemFacts facts{.build = base::build_info(), .machine = "", .start = "", .threads = 1};
  again.differences = report_differences(report, report_text(experiment, *result, facts));
  return again;
}

}  // namespace rocking

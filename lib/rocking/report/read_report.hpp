#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rocking::report {

/// What a report says of itself.
struct ReportClaims {
  std::string experiment;  ///< text of `input.experiment`, canonical if nobody changed it
  std::string sha256;      ///< `input.sha256`
  std::string code;        ///< `system.version` and `system.revision`
};

/// Throws InputError where the text is no report.
[[nodiscard]] ReportClaims read_report(std::string_view text);

/// Where two reports differ in what must be the same for equal input (`input`, `result`, `internal`), each as `/place is
/// this, not that`; of many the first ten. `claimed` is the one in doubt.
[[nodiscard]] std::vector<std::string> report_differences(std::string_view claimed, std::string_view right);

/// The same of two experiments.
[[nodiscard]] std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right);

}  // namespace rocking::report

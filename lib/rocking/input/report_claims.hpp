#pragma once

#include <string>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Value of `format` in a report.
inline constexpr std::string_view report_format = "rocking.report/1";

/// What a report says of itself.
struct ReportClaims {
  std::string experiment;  ///< text of `input.experiment`, canonical if nobody changed it
  std::string sha256;      ///< `input.sha256`
  std::string code;        ///< `system.version` and `system.revision`
};

/// Throws InputError where the text is no report.
[[nodiscard]] ReportClaims claims_of_report(std::string_view text);

/// Whether the experiment has the digest that the report states.
[[nodiscard]] bool has_stated_digest(const ReportClaims& claims);
inline constexpr std::string_view wrong_digest_of_experiment =
    "input.experiment does not have the digest of input.sha256: one of them was changed";

/// Checks the experiment in a report of the right form: against what an experiment file may hold and the digest that the
/// report states, and that the report has one condition for each point of the sweep, with the parameters of that point.
[[nodiscard]] Problems problems_of_report(const Json& report);

}  // namespace rocking

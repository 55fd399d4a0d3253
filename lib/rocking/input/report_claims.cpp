#include "rocking/input/report_claims.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

std::string text_at(const Json& report, const char* pointer) {
  const Json::json_pointer place(pointer);
  if (report.contains(place) && report.at(place).is_string()) return report.at(place).get<std::string>();
  throw base::InputError(
      {.place = pointer, .value = "", .reason = "is missing, or is not text: this is not a report", .remedy = ""});
}

}  // namespace

ReportClaims claims_of_report(std::string_view text) {
  const Json report = parse_json(text);
  if (text_at(report, "/format") != report_format) {
    throw base::InputError({.place = "/format",
                            .value = brief(report["format"]),
                            .reason = "is not the format of a report",
                            .remedy = "give a report in format " + std::string(report_format)});
  }
  if (!report.contains("input") || !report["input"].contains("experiment")) {
    throw base::InputError({.place = "/input/experiment", .value = "", .reason = "is missing", .remedy = ""});
  }
  return {.experiment = report["input"]["experiment"].dump(),
          .sha256 = text_at(report, "/input/sha256"),
          .code = text_at(report, "/system/version") + ' ' + text_at(report, "/system/revision")};
}

bool has_stated_digest(const ReportClaims& claims) {
  return base::to_hex(base::sha256(claims.experiment)) == claims.sha256;
}

}  // namespace rocking

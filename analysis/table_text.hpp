#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/report.hpp"

/// Pieces of tables in CSV and LaTeX.
namespace rocking::analysis {

/// A field of CSV (RFC 4180).
[[nodiscard]] std::string csv_field(const std::string& text);

/// A number with all its digits; empty if there is none.
[[nodiscard]] std::string csv_number(const std::optional<double>& number);

/// The first columns of a CSV: the swept parameters; both forms of the shaking without those that are swept, whether
/// they differ between conditions or not; n.
class CsvStart {
 public:
  explicit CsvStart(const Report& report);

  [[nodiscard]] const std::string& head() const { return head_; }
  [[nodiscard]] std::string of(const ReportedCondition& condition) const;

 private:
  std::vector<std::string_view> shaking_;
  std::string head_;
};

/// Text for LaTeX, for the fonts (OT1) and the encoding (UTF-8) that it has without packages: other characters than those
/// of ASCII, accented Latin letters, Greek letters and common signs are written as `[U+1F30A]`.
[[nodiscard]] std::string latex_text(std::string text);

/// The symbol of a parameter in mathematics mode, or its name.
[[nodiscard]] std::string latex_symbol(const std::string& pointer);

}  // namespace rocking::analysis

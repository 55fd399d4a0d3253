#include "analysis/table_files.hpp"

#include "analysis/settling_tables.hpp"
#include "analysis/tables.hpp"

namespace rocking::analysis {
namespace {

using Files = std::map<std::string, std::string>;

void add_csv(Files& files, const Report& report) {
  files["modes.csv"] = modes_csv(report);
  files["non_recurrence.csv"] = non_recurrence_csv(report);
  files["quantiles.csv"] = quantiles_csv(report);
  if (!report.has_settling()) return;
  files["settling.csv"] = settling_csv(report);
  files["incidence.csv"] = incidence_csv(report);
  files["leaving.csv"] = leaving_csv(report);
  files["long_run_shares.csv"] = long_run_csv(report);
}

void add_latex(Files& files, const Report& report) {
  files["modes.tex"] = modes_latex(report);
  if (report.has_settling()) files["settling.tex"] = settling_latex(report);
  files["long_run_shares.tex"] = long_run_latex(report);
}

}  // namespace

std::map<std::string, std::string> table_files(const Report& report, const std::set<std::string>& formats) {
  Files files;
  if (formats.contains("csv")) add_csv(files, report);
  if (formats.contains("latex")) add_latex(files, report);
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  return files;
}

}  // namespace rocking::analysis

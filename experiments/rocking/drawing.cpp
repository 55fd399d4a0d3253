#include "drawing.hpp"

#include <set>

#include "analysis/draw.hpp"
#include "analysis/run_figures.hpp"
#include "output.hpp"
#include "rocking/report/files.hpp"

namespace rocking::program {

std::vector<analysis::Figure> figures_of(const RunFolder& folder, const analysis::RunReport& report) {
  if (!folder.has_store()) return analysis::run_figures(report);
  const experiment::Store store = folder.open_sound_store();
  return analysis::run_figures(report, &store);
}

std::vector<std::string> write_figures(const std::vector<analysis::Figure>& figures,
                                       const std::filesystem::path& folder) {
  report::ensure_writable(folder);
  std::vector<std::string> written;
  std::set<std::string> reasons;
  for (const analysis::Figure& figure : figures) {
    const analysis::Drawing drawing = analysis::write_figure(figure, folder);
    if (!drawing.drawn) reasons.insert(drawing.reason);
    const std::string stem = (folder / figure.name).string();
    for (const char* ending : {".tsv", ".gp"}) written.push_back(stem + ending);
    if (!drawing.drawn) continue;
    for (const std::string& format : analysis::picture_formats()) written.push_back(stem + '.' + format);
  }
  for (const std::string& reason : reasons) print_notice(reason);
  return written;
}

}  // namespace rocking::program

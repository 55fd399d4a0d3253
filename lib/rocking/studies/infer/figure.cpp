#include "rocking/studies/infer/figure.hpp"

#include <utility>

#include "rocking/studies/infer/counted_tests_figures.hpp"
#include "rocking/studies/infer/likelihood_figures.hpp"

namespace rocking::analysis {

std::vector<Figure> infer_figures(const InferReport& report) {
  std::vector<Figure> figures;
  if (!report.fit) return figures;
  figures.push_back(profile_figure(report));
  if (report.unknowns.size() > 1) figures.push_back(region_figure(report));
  figures.push_back(fit_figure(report));
  if (auto candidates = candidates_figure(report)) figures.push_back(std::move(*candidates));
  return figures;
}

}  // namespace rocking::analysis

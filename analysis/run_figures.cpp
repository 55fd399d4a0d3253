#include "analysis/run_figures.hpp"

#include "analysis/mode_figures.hpp"

namespace rocking::analysis {

std::vector<Figure> run_figures(const RunReport& report) { return {mode_bands(report), mode_probabilities(report)}; }

}  // namespace rocking::analysis

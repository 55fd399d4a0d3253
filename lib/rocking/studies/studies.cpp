#include "rocking/studies/studies.hpp"

#include <array>
#include <utility>

#include "rocking/studies/bifurcation/study.hpp"
#include "rocking/studies/check_normal/study.hpp"
#include "rocking/studies/comparison/study.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/studies/motion/study.hpp"
#include "rocking/studies/orbits/study.hpp"
#include "rocking/studies/rare/study.hpp"

namespace rocking {

std::span<const Study* const> studies() {
  static const std::array all{&comparison_study(), &bifurcation_study(), &orbits_study(),
                              &rare_study(),       &infer_study(),       &cost_study(),
                              &fragility_study(),  &motion_study(),      &check_normal_study()};
  return all;
}

std::vector<analysis::Figure> figures_of_studies(const RunShown& run) {
  std::vector<analysis::Figure> figures;
  for (const Study* study : studies()) {
    if (study->figures_of_run == nullptr) continue;
    for (analysis::Figure& figure : study->figures_of_run(run)) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace rocking

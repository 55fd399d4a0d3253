#include "rocking/experiment/mode_family.hpp"

#include <algorithm>
#include <array>

namespace rocking::experiment {
namespace {

using section::ResponseKind;

constexpr std::array foreseen_modes{section::periodic(1, 1),
                                    section::periodic(1, 3),
                                    section::ResponseMode{.kind = ResponseKind::chaotic},
                                    section::ResponseMode{.kind = ResponseKind::overturned},
                                    section::ResponseMode{.kind = ResponseKind::rest},
                                    section::ResponseMode{.kind = ResponseKind::unresolved}};

}  // namespace

bool is_foreseen(const section::ResponseMode& mode) {
  return std::find(foreseen_modes.begin(), foreseen_modes.end(), mode) != foreseen_modes.end();
}

stats::Family mode_family(double confidence) { return {.foreseen = foreseen_modes.size(), .confidence = confidence}; }

stats::CategoryCounts category_counts(const ModeTally& tally) {
  stats::CategoryCounts counts;
  for (const section::ResponseMode& mode : foreseen_modes) {
    const auto found = tally.find(mode);
    counts.foreseen.push_back(found == tally.end() ? 0 : found->second);
  }
  for (const auto& [mode, count] : tally) {
    counts.trials += count;
    if (!is_foreseen(mode)) counts.unforeseen.push_back(count);
  }
  return counts;
}

}  // namespace rocking::experiment

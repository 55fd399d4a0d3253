#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// Realisations by which an experiment's cost is measured, in an order of which every beginning is spread over the
/// conditions: round after round of all conditions, each time in the order of their reversed bits (0, 1/2, 1/4, 3/4, ... of
/// the way along the grid).
///
/// Each has a number of its own, so that no two share their draws and the sample is one of independent trials. A condition
/// in which nothing is drawn takes part in the first round alone, for one realisation says all.
class CostSample {
 public:
  explicit CostSample(const Experiment& experiment);

  /// How many there are; absent: no end.
  [[nodiscard]] std::optional<std::uint64_t> size() const;

  /// `index` below size().
  [[nodiscard]] RealisationKey at(std::uint64_t index) const;

 private:
  std::vector<std::size_t> all_;     ///< conditions in the order of a round
  std::vector<std::size_t> random_;  ///< of them, those in which something is drawn
};

}  // namespace rocking::experiment

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Realisations with which the cost of an experiment is measured, in an order whose every initial part covers the
/// conditions evenly: rounds of all conditions, each in the order of their reversed bits (0, 1/2, 1/4, 3/4, ... of the
/// way along the grid).
///
/// Each has a different number, so that they use independent random numbers and are independent trials. A condition in
/// which nothing is random takes part in the first round only, because all its realisations are equal.
class CostSample {
 public:
  explicit CostSample(const Experiment& experiment);

  /// Number of realisations; absent: infinite.
  [[nodiscard]] std::optional<std::uint64_t> size() const;

  /// `index` below size().
  [[nodiscard]] RealisationKey at(std::uint64_t index) const;

 private:
  std::vector<std::size_t> all_;     ///< conditions in the order of a round
  std::vector<std::size_t> random_;  ///< those of them in which something is random
};

}  // namespace rocking

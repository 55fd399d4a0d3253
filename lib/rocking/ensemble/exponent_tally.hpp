#pragma once

#include <optional>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Collects the Lyapunov exponents of the realisations of a condition: 16 bytes for each that has one.
class ExponentTally {
 public:
  void add(const Summary& summary);

  /// Absent where no realisation has one.
  [[nodiscard]] std::optional<Exponents> exponents(double confidence) const;

 private:
  std::vector<double> exponents_, errors_;
};

}  // namespace rocking

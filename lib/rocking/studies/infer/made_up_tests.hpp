#pragma once

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

/// All conditions have the same random numbers, and the errors of their shares may be alike. How they are made up:
enum class ErrorsOfConditions : std::uint8_t {
  bounded,  ///< independent, each larger by the root of the number of conditions: no sum of errors that are alike has a
            ///< larger variance (Cauchy and Schwarz)
  independent,  ///< as large as they are: the mean of a sum of squares does not depend on how alike they are
};

/// Which data sets are made up. Their numbers stand for those of realisations.
struct MadeUpSets {
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::size_t sets = 0;
  ErrorsOfConditions errors = ErrorsOfConditions::bounded;
};

/// Data sets as they would be counted if the unknowns were at a point of the unit cube, one in each column: as many
/// tests of each condition as there were. Each set has shares of its own, within the error of the realisations.
///
/// Random numbers: sources `inference_shares` and `inference_counts` (lib/docs/draws.md). The time does not grow with the
/// tests. A set is a part of `how`. Throws base::Stopped if it is asked to stop.
[[nodiscard]] Eigen::MatrixXd made_up_tests(std::span<const ShareModel> models, const std::vector<std::uint64_t>& tests,
                                            const Eigen::VectorXd& point, const MadeUpSets& asked,
                                            const base::ManyParts& how = {});

}  // namespace rocking::infer

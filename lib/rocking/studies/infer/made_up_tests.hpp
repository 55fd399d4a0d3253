#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

/// Data sets as they would be counted if the unknowns were at a point of the unit cube, one in each column: as many
/// tests of each condition as there were. Each set has shares of its own, within the error of the realisations.
///
/// All conditions have the same random numbers, and their errors may be alike. Independent errors, each larger by the
/// root of the number of conditions, have no smaller variance in any sum (Cauchy and Schwarz).
///
/// Random numbers: set number `first` + column of the sources `inference_shares` and `inference_counts`.
[[nodiscard]] Eigen::MatrixXd made_up_tests(std::span<const ShareModel> models, const std::vector<std::uint64_t>& tests,
                                            const Eigen::VectorXd& point, std::uint64_t seed, std::uint64_t first,
                                            std::size_t sets);

}  // namespace rocking::infer

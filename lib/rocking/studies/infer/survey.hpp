#pragma once

#include <cmath>

#include "rocking/studies/infer/infer.hpp"
#include "rocking/studies/infer/likelihood.hpp"
#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

/// The unknowns in the unit cube.
class Scale {
 public:
  explicit Scale(const std::vector<Unknown>& unknowns) : unknowns_(&unknowns) {}

  [[nodiscard]] double value(std::size_t unknown, double coordinate) const {
    const Unknown& range = (*unknowns_)[unknown];
    return std::lerp(range.from, range.to, coordinate);
  }
  [[nodiscard]] std::vector<double> values(const Eigen::VectorXd& point) const;
  /// The same with six significant digits, within the range.
  [[nodiscard]] std::vector<double> short_values(const Eigen::VectorXd& point) const;
  [[nodiscard]] Eigen::VectorXd point(const std::vector<double>& values) const;

 private:
  const std::vector<Unknown>* unknowns_;
};

/// The likelihood of the counts on the smallest lattice around all points of any likelihood.
struct Survey {
  Likelihood likelihood;
  Eigen::VectorXd logarithms;  ///< by point of the lattice
  Eigen::VectorXd deviances;
};

/// `models`: of the tested conditions. Throws base::Stopped if it is asked to stop. Of `how` the threads count.
[[nodiscard]] Survey survey(const std::vector<ShareModel>& models, const Counts& counts,
                            const base::ManyParts& how = {});

/// Whether a smaller window is worth another lattice.
[[nodiscard]] bool is_much_smaller(const Window& window, const Window& present);

/// The answer from the models of all conditions, candidates last. A made-up data set is a part of `how`. Throws
/// base::Stopped if it is asked to stop.
[[nodiscard]] InferenceAnswer answer_of(const InferenceSetting& setting, const std::vector<ShareModel>& models,
                                        const Survey& found, const base::ManyParts& how);

/// Data sets that answer_of makes up.
[[nodiscard]] std::uint64_t sets_of_answer(const InferenceSetting& setting);

}  // namespace rocking::infer

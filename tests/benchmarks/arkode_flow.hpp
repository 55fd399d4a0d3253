#pragma once

#include <memory>

#include "differential/peer/flow.hpp"

namespace rocking::benchmarks {

/// SUNDIALS' ARKODE: Dormand and Prince's method of order 5, with its own root finding.
///
/// Source: Reynolds et al. (2023), ARKODE, ACM TOMS 49(2) 19.
class ArkodeFlow final : public peer::Flow {
 public:
  explicit ArkodeFlow(const peer::FlowAccuracy& accuracy);
  ~ArkodeFlow() override;

  [[nodiscard]] peer::Stretch follow(const peer::Vector& start, double duration, double smallness,
                                     const peer::Equations& equations) override;

 private:
  struct Solver;
  peer::FlowAccuracy accuracy_;
  std::unique_ptr<Solver> solver_;
  double last_step_;  ///< chosen by the solver: the next stretch starts with it
};

}  // namespace rocking::benchmarks

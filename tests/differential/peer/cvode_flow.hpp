#pragma once

#include <memory>

#include "differential/peer/flow.hpp"

namespace rocking::peer {

/// CVODE, method of Adams.
///
/// Source: Hindmarsh et al. (2005), SUNDIALS, ACM TOMS 31(3) 363-396.
class CvodeFlow final : public Flow {
 public:
  explicit CvodeFlow(const FlowAccuracy& accuracy);
  ~CvodeFlow() override;

  [[nodiscard]] Stretch follow(const Vector& start, double duration, double smallness,
                               const Equations& equations) override;

 private:
  struct Solver;
  FlowAccuracy accuracy_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace rocking::peer

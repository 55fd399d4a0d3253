#pragma once

#include <functional>
#include <optional>
#include <span>

#include "rocking/section/period.hpp"
#include "rocking/section/thresholds.hpp"
#include "rocking/section/verdict.hpp"

namespace rocking::section {

/// Largest Lyapunov exponent per excitation period, of two copies of a realisation under the same draws.
struct ExponentEstimate {
  double exponent = 0.0;        ///< [1/period]
  double standard_error = 0.0;  ///< [1/period]
};

/// Gives the exponent of the response in question, or nothing where the run could not be made. Expensive.
using ExponentSource = std::function<std::optional<ExponentEstimate>()>;

/// A name, or one that depends on the exponent.
struct Classification {
  std::optional<Verdict> verdict;  ///< absent: `with_exponent` gives it
  std::function<Verdict(const std::optional<ExponentEstimate>&)> with_exponent;
};

struct ClassifierInput {
  std::span<const Period> periods;  ///< the sampled ones, in order, without a gap
  bool random = false;              ///< whether anything in the scene is drawn at random
  double resolution = 1e-7;         ///< about how accurate a strobe point is, in units of Theta; > 0
  Thresholds thresholds = {};
};

/// The response mode of a realisation that did not overturn.
///
/// Noise-free: the smallest n <= 12 at which strobe points repeat. Random: the number of clouds that are visited in
/// cyclic order, from spectral lines that stand out of their neighbourhood. m from the impacts. Where that leaves doubt the
/// exponent decides. A random response that settles within the window is named by the part since then.
/// Conservative: what is not clear is unresolved.
/// The thresholds are derived in lib/docs/methods-classification.md. The same input gives the same bits everywhere.
/// Cost: linear memory; time O(N) with about 200 passes if random, a few times that if it changes its mind.
[[nodiscard]] Classification classify(const ClassifierInput& input);

/// The same with the exponent, which is asked for once at most.
[[nodiscard]] Verdict classify(const ClassifierInput& input, const ExponentSource& exponent);

}  // namespace rocking::section

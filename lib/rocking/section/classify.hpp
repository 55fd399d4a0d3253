#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "rocking/section/classification.hpp"
#include "rocking/section/nearby_orbit.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// Largest Lyapunov exponent per excitation period, of the motion with the random numbers that it drew.
struct ExponentEstimate {
  double exponent = 0.0;        ///< [1/period]
  double standard_error = 0.0;  ///< [1/period]
  std::int64_t periods = 0;     ///< over which it was taken, where those are more than the window; else 0
  int looks = 1;                ///< at its sign up to now, each with more periods than the one before
};

/// Returns the exponent of the response, or nothing if it could not be computed. Expensive.
using ExponentSource = std::function<std::optional<ExponentEstimate>()>;

/// The strobe points of the whole run with tangent vectors, from the beginning of the window on. It may go on beyond the
/// periods whose exponent answers the question of its sign.
struct LongSection {
  std::span<const StrobePoint> points;
  std::optional<ExponentEstimate> exponent;  ///< over all of them
  bool has_ended = false;                    ///< the motion overturned after them
};

/// A classification, or functions that complete it once the exponent is known.
struct PendingClassification {
  std::optional<Classification> classification;  ///< absent if `with_exponent` must be called
  std::function<Classification(const std::optional<ExponentEstimate>&, const LongSection&)> with_exponent;
  /// Whether the exponent of more periods is wanted: this estimate has a sign that would decide, but is not far enough
  /// from zero. A motion may diverge or converge for the length of a window and do the opposite later.
  std::function<bool(const ExponentEstimate&)> may_be_decided_later;
  /// Whether more points are wanted, because these may lie on closed curves, or may be of chaos that ends. May be empty: never.
  std::function<bool(const LongSection&)> wants_more_points;
};

/// Sampled periods without which every response that moves is unresolved: 24, or 48 of a random one.
[[nodiscard]] constexpr int fewest_periods(bool random) { return (random ? 4 : 2) * longest_period; }

struct ClassifierInput {
  std::span<const Period> periods;  ///< the sampled periods, in order and without gaps
  bool random = false;              ///< whether anything is random along the way
  double resolution = 1e-7;         ///< accuracy of a strobe point, in units of Theta; > 0
  Thresholds thresholds = {};
  OrbitSource find_orbit = {};  ///< may be empty: then no label is given that needs an orbit
  std::size_t unfinished = 0;   ///< so many of the last periods have impacts of a chatter that the end may cut
};

/// Classifies a realisation that did not overturn.
///
/// Noise-free: n <= 12 is the period of the stable orbit that the strobe points tend to. Random: n is the number of
/// clouds that are visited in cyclic order; it is found from spectral lines that exceed their neighbourhood, and by the
/// orbit of the motion without noise where the clouds move slowly. m follows from the impacts. If these do not decide,
/// the exponent does. A random response that settles within the window is classified by the part after that. What is not
/// clear is unresolved.
///
/// The thresholds are derived in lib/docs/methods-classification.md. The same input gives the same bits everywhere.
/// Cost: linear memory and O(N) time; some tens of passes if random, a few times as many if the response settles late.
[[nodiscard]] PendingClassification classify(const ClassifierInput& input);

/// As above. `exponent` is called at most once, and only if it is needed.
[[nodiscard]] Classification classify(const ClassifierInput& input, const ExponentSource& exponent);

}  // namespace rocking::section

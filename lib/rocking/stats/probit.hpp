#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// Probit regression on counts: P(event at u) = Phi(a + b u).
namespace rocking::stats {

/// Counts of the trials at one value of the regressor u.
struct ProbitCounts {
  double u = 0.0;
  double happened = 0.0;  ///< trials with the event
  double did_not = 0.0;   ///< trials without it
};

/// Contribution of one trial to the log-likelihood, as a function of eta = a + b u.
struct ProbitTerm {
  double value = 0.0;
  double slope = 0.0;      ///< first derivative
  double curvature = 0.0;  ///< minus the second derivative: >= 0
};

/// ln Phi(eta) and its derivatives; for a trial without the event those of ln(1 - Phi(eta)).
[[nodiscard]] ProbitTerm probit_term(bool happened, double eta);

/// A symmetric 2 x 2 matrix.
struct SymmetricMatrix {
  double aa = 0.0, ab = 0.0, bb = 0.0;

  void add_square(double a, double b, double weight) {
    aa += weight * a * a;
    ab += weight * a * b;
    bb += weight * b * b;
  }
  [[nodiscard]] SymmetricMatrix inverse() const {
    const double determinant = aa * bb - ab * ab;
    return {.aa = bb / determinant, .ab = -ab / determinant, .bb = aa / determinant};
  }
  [[nodiscard]] std::array<double, 2> times(double a, double b) const { return {aa * a + ab * b, ab * a + bb * b}; }
};

struct ProbitLikelihood {
  double value = 0.0;           ///< logarithm of the likelihood
  double a = 0.0, b = 0.0;      ///< its first derivatives
  SymmetricMatrix information;  ///< minus its second derivatives
};

[[nodiscard]] ProbitLikelihood probit_likelihood(const std::vector<ProbitCounts>& counts, double a, double b);

/// Whether the likelihood has a maximum at finite (a, b), and if not, what it approaches.
enum class ProbitShape : std::uint8_t {
  has_maximum,
  never_happened,
  always_happened,
  rising_step,   ///< no trial with the event below some u, none without it above: a step describes the counts exactly
  falling_step,  ///< the same with the two sides exchanged
};

[[nodiscard]] ProbitShape shape_of(const std::vector<ProbitCounts>& counts);

struct ProbitLine {
  double a = 0.0;
  double b = 0.0;
};

/// The (a, b) of the maximum likelihood, by Newton's method on a concave function, to rounding accuracy. Needs two
/// different values of u, and the shape `has_maximum`.
[[nodiscard]] ProbitLine most_likely_line(const std::vector<ProbitCounts>& counts, const ProbitLine& start = {});

/// Twice the difference of the log-likelihood between a probability of its own at each u and the most likely line:
///
///     D = 2 sum [k ln(k/(n P)) + (n - k) ln((n - k)/(n (1 - P)))]
///
/// 0 where the likelihood has no maximum, since it then approaches the counts. `start`: where the search begins.
[[nodiscard]] double probit_deviance(const std::vector<ProbitCounts>& counts, const ProbitLine& start = {});

/// A probability at one intensity.
struct KnownProbability {
  double intensity = 0.0;  ///< > 0
  double probability = 0.0;
};

/// A probability between intensities at which it is known: its probit is interpolated linearly in the logarithm of the
/// intensity, which is exact for a lognormal law. Outside the intensities the nearest piece is continued.
class ProbitInterpolation {
 public:
  /// At least two points, by increasing intensity.
  explicit ProbitInterpolation(const std::vector<KnownProbability>& points);

  [[nodiscard]] double probability(double intensity) const;

 private:
  struct Node {
    double logarithm, probit;
  };
  std::vector<Node> nodes_;
};

}  // namespace rocking::stats

// The 0-1 test for chaos as an independent test, and cases in which noise makes it wrong. The table is for
// reports/evidence/classification-evidence.md.
//
//     zero_one_evidence
//
// Gottwald & Melbourne (2009), SIAM J. Appl. Dyn. Syst. 8, 129-145. From x_1 ... x_N and a frequency c: the translation
// p(n) = sum x_j cos(jc), q(n) = sum x_j sin(jc). D(n) is its mean square displacement M(n) for n <= N/10 minus the
// oscillating part (E x)^2 (1 - cos nc)/(1 - cos c). K is the median over c of the correlation of D(n) with n. 0:
// regular;
// 1: chaotic.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "evidence/long_run.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking::evidence {
namespace {

constexpr int frequencies = 100;

double correlation_with_time(const std::vector<double>& x, double c) {
  const std::size_t longest = x.size() / 10;
  std::vector<double> p(x.size() + 1);
  std::vector<double> q(x.size() + 1);
  double mean = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double angle = static_cast<double>(j + 1) * c;
    p[j + 1] = p[j] + x[j] * std::cos(angle);
    q[j + 1] = q[j] + x[j] * std::sin(angle);
    mean += x[j] / static_cast<double>(x.size());
  }
  std::vector<double> displacement;
  double time_mean = 0.0;
  double displacement_mean = 0.0;
  for (std::size_t n = 1; n <= longest; ++n) {
    double sum = 0.0;
    for (std::size_t j = 0; j + longest <= x.size(); ++j) {
      const double dp = p[j + n] - p[j];
      const double dq = q[j + n] - q[j];
      sum += dp * dp + dq * dq;
    }
    const double turns = (1.0 - std::cos(static_cast<double>(n) * c)) / (1.0 - std::cos(c));
    displacement.push_back(sum / static_cast<double>(x.size() - longest + 1) - mean * mean * turns);
    displacement_mean += displacement.back() / static_cast<double>(longest);
    time_mean += static_cast<double>(n) / static_cast<double>(longest);
  }
  double both = 0.0;
  double of_time = 0.0;
  double of_displacement = 0.0;
  for (std::size_t n = 1; n <= longest; ++n) {
    const double t = static_cast<double>(n) - time_mean;
    const double d = displacement[n - 1] - displacement_mean;
    both += t * d;
    of_time += t * t;
    of_displacement += d * d;
  }
  return both / std::sqrt(of_time * of_displacement);
}

/// K, from seeded frequencies in (pi/5, 4 pi/5): the same in every run.
double zero_one(const std::vector<double>& x) {
  support::SplitMix draw(2009);
  std::vector<double> correlations;
  for (int i = 0; i < frequencies; ++i)
    correlations.push_back(correlation_with_time(x, draw.uniform(0.2 * std::numbers::pi, 0.8 * std::numbers::pi)));
  std::nth_element(correlations.begin(), correlations.begin() + frequencies / 2, correlations.end());
  return correlations[frequencies / 2];
}

struct Scene {
  const char* name;
  double amplitude;
  bool slides;
  double sigma;             ///< of friction, or of restitution where the block cannot slide
  bool as_plotted = false;  ///< with that formulation, and the initial phase of a cosine
};

void print(const Scene& scene) {
  Condition condition;
  condition.scene.block = {.width = 1.0, .height = 4.0, .gravity = 9.81};
  support::harmonic(condition.scene).amplitude = scene.amplitude;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  if (scene.as_plotted) {
    condition.scene.slide_inertia = dynamics::SlideInertia::edge;
    condition.scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
    support::harmonic(condition.scene).phase = 0.5 * std::numbers::pi;
  }
  if (scene.slides) {
    condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = scene.sigma;
  } else {
    condition.scene.fluctuation.restitution = scene.sigma;
  }
  LongRun run(condition, random::Draws(0x2012, 0), 500 + 2400);
  std::printf("| %s | %g |", scene.name, scene.sigma);
  for (const int length : {120, 600, 2400}) {
    std::vector<double> x;
    for (int k = 0; k < length && 500 + static_cast<std::size_t>(k) < run.periods().size(); ++k)
      x.push_back(run.periods()[500 + static_cast<std::size_t>(k)].point.tilt_rate);
    std::printf(" %.2f |", zero_one(x));
  }
  section::PendingClassification longest;
  longest.may_be_decided_later = [](const section::ExponentEstimate&) { return true; };
  const auto exponent = run.exponent(300, longest).exponent;
  if (exponent) std::printf(" %.4f +- %.4f |", exponent->exponent, exponent->standard_error);
  std::printf(" %s |\n", to_string(run.name({500, 2400}, 300).mode).c_str());
}

}  // namespace
}  // namespace rocking::evidence

int main() {
  using rocking::evidence::print;
  std::printf("| response | sigma | K, N = 120 | N = 600 | N = 2400 | exponent | name by N = 2400 |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double sigma : {0.0, 1e-4, 1e-3, 1e-2}) print({"no sliding, A_h 3", 3.0, false, sigma});
  for (const double sigma : {0.0, 1e-4, 1e-3, 1e-2}) print({"no sliding, A_h 4.5", 4.5, false, sigma});
  for (const double sigma : {0.0, 3e-4, 0.003}) print({"as plotted, sliding 0.40/0.35, A_h 9", 9.0, true, sigma, true});
  for (const double sigma : {0.0, 0.003, 0.03}) print({"sliding 0.40/0.35, A_h 7", 7.0, true, sigma});
  for (const double sigma : {0.0, 0.003, 0.03}) print({"sliding 0.40/0.35, A_h 9", 9.0, true, sigma});
  return 0;
}

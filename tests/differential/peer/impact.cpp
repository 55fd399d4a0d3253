#include "differential/peer/impact.hpp"

#include <cmath>

namespace rocking::peer {

Rebound land(const Body& body, const Landing& before) {
  const double e = before.restitution;
  const double c = body.height;
  const double sigma = before.w > 0.0 ? 1.0 : -1.0;
  const double b = body.edge(sigma);       // of the edge that lands
  const double other = body.edge(-sigma);  // of the edge that leaves
  const double inertia = body.inertia;
  const double lambda = before.v / (before.w * c) - 1.0;
  /// P_y over abs(w1).
  const auto upwards = [=](double delta) { return other + e * (b + other) + delta * b; };

  double delta = (inertia - lambda * c * c - b * other - e * b * (b + other)) / (inertia + b * b + c * c);
  const Rebound stuck{delta * before.w, 0.0, false};
  if (!before.friction) return stuck;
  const double p_x = -c * (delta + lambda) * before.w;
  if (before.signed_rule) {
    if (upwards(delta) <= 0.0 || c * (delta + lambda) / upwards(delta) <= before.friction->at_rest) return stuck;
  } else if (std::abs(p_x) <= before.friction->at_rest * upwards(delta) * std::abs(before.w)) {
    return stuck;
  }

  const double s2 = p_x > 0.0 ? -1.0 : 1.0;
  const double mu_k = before.friction->sliding;
  const double q = b * b + sigma * s2 * mu_k * b * c;
  if (inertia + q <= 0.0) return {before.w, before.v, true, false};
  const double rho = other / b;
  delta = (inertia - q * (rho + e * (1.0 + rho))) / (inertia + q);
  const double p_y = upwards(delta) * std::abs(before.w);
  const double w2 = delta * before.w;
  const double v2 = lambda * c * before.w - s2 * mu_k * p_y + c * w2;
  return {w2, s2 * v2 > 0.0 ? v2 : 0.0, true};
}

}  // namespace rocking::peer

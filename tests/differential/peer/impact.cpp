#include "differential/peer/impact.hpp"

#include <cmath>

namespace rocking::peer {

Rebound land(const Body& body, const Landing& before) {
  const double e = before.restitution;
  const double s = body.sine;
  const double c = body.cosine;
  const double sigma = before.w > 0.0 ? 1.0 : -1.0;
  const double lambda = before.v / (before.w * c) - 1.0;

  double delta = 1.0 - 0.75 * (1.0 + lambda) * c * c - 1.5 * (1.0 + e) * s * s;
  const Rebound stuck{delta * before.w, 0.0, false};
  if (!before.friction) return stuck;
  const double p_x = -c * (delta + lambda) * before.w;
  if (before.signed_rule) {
    const double span = 1.0 + delta + 2.0 * e;
    if (span <= 0.0 || body.slenderness * (delta + lambda) / span <= before.friction->at_rest) return stuck;
  } else if (std::abs(p_x) <= before.friction->at_rest * s * (1.0 + 2.0 * e + delta) * std::abs(before.w)) {
    return stuck;
  }

  const double s2 = p_x > 0.0 ? -1.0 : 1.0;
  const double mu_k = before.friction->sliding;
  const double q = s * s + sigma * s2 * mu_k * s * c;
  if (1.0 + 3.0 * q <= 0.0) return {before.w, before.v, true, false};
  delta = (1.0 - 3.0 * (1.0 + 2.0 * e) * q) / (1.0 + 3.0 * q);
  const double p_y = s * (1.0 + 2.0 * e + delta) * std::abs(before.w);
  const double w2 = delta * before.w;
  const double v2 = lambda * c * before.w - s2 * mu_k * p_y + c * w2;
  return {w2, s2 * v2 > 0.0 ? v2 : 0.0, true};
}

}  // namespace rocking::peer

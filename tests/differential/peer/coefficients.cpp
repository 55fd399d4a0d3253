#include "differential/peer/coefficients.hpp"

#include <algorithm>

namespace rocking::peer {

using random::Source;

Coefficients::Coefficients(const Scene& scene) : scene_(scene), draws_(scene.seed, scene.realisation) { draw_static(); }

double Coefficients::drawn(double mean, double sigma, Source source, std::uint64_t index) const {
  return sigma == 0.0 ? mean : mean + sigma * draws_.standard_normal(source, index);
}

void Coefficients::draw_static() {
  if (!scene_.friction) return;
  const std::uint64_t index = (chatters_ << 32U) + stops_;
  mu_s_ = std::max(0.0, drawn(scene_.friction->at_rest, scene_.sigmas.at_rest, Source::static_friction, index));
}

Friction Coefficients::friction(std::int64_t interval) const {
  const double mu_k = drawn(scene_.friction->sliding, scene_.sigmas.sliding, Source::kinetic_friction,
                            static_cast<std::uint64_t>(interval));
  return {mu_s_, std::min(std::max(0.0, mu_k), mu_s_)};
}

double Coefficients::amplitude(std::int64_t period) const {
  return std::max(
      0.0, drawn(scene_.amplitude, scene_.sigmas.amplitude, Source::amplitude, static_cast<std::uint64_t>(period)));
}

double Coefficients::next_restitution() {
  const std::uint64_t index = (chatters_ << 32U) + impacts_++;
  const double e = drawn(scene_.restitution, scene_.sigmas.restitution, Source::restitution, index);
  if (scene_.sigmas.restitution == 0.0) return e;
  return scene_.open_side != 0.0 ? std::clamp(e, 0.0, 0.999) : std::clamp(e, -0.999, 1.0);
}

void Coefficients::stopped() {
  ++stops_;
  draw_static();
}

void Coefficients::chatter_ended() {
  // The draws of earlier stops must have no effect after it. If there were no stops, the friction in force remains.
  const bool redraw = stops_ > 0;
  ++chatters_;
  stops_ = impacts_ = 0;
  if (redraw) draw_static();
}

}  // namespace rocking::peer

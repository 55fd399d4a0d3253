#include "rocking/studies/rare/drawn_numbers.hpp"

#include <algorithm>
#include <cstddef>

#include "rocking/base/normal_law.hpp"
#include "rocking/scene/drawn_quantities.hpp"

namespace rocking::rare {

using random::Source;

DrawnNumbers drawn_numbers(const Scene& scene) {
  DrawnNumbers drawn;
  for_each_quantity(scene, [&drawn](const QuantityPlace& what, const Quantity& quantity) {
    if (is_drawn(quantity)) drawn.once.push_back(what.source);
  });
  const Fluctuation& f = scene.fluctuation;
  const bool amplitude_once = amplitude_draws(scene.excitation) == AmplitudeDraws::once;
  if (f.amplitude > 0.0 && amplitude_once) drawn.once.push_back(Source::amplitude);
  const bool often = f.kinetic_friction > 0.0 || f.restitution > 0.0 || (f.amplitude > 0.0 && !amplitude_once);
  drawn.along_the_way = often || f.static_friction > 0.0;
  // A block that never comes to a stop has the static friction of its start only.
  if (f.static_friction > 0.0 && !often) drawn.once.push_back(Source::static_friction);
  return drawn;
}

random::DrawHistory given_draws(const Scene& scene, const std::vector<Source>& once, const Point& point) {
  random::DrawHistory history;
  for (std::size_t d = 0; d < once.size(); ++d) history.given.push_back({once[d], point[d]});
  for_each_quantity(scene, [&history](const QuantityPlace& what, const Quantity& quantity) {
    if (!is_drawn(quantity) || drawn_from(quantity) != BasicDraw::uniform) return;
    constexpr double below_one = 1.0 - 0x1p-53;
    for (random::GivenDraw& draw : history.given) {
      if (draw.source == what.source) draw.number = std::min(base::normal_upper_tail(-draw.number), below_one);
    }
  });
  return history;
}

}  // namespace rocking::rare

#include "rocking/studies/orbits/critical_orbit.hpp"

#include <cmath>

namespace rocking {
namespace {

/// Orbits that branch off are nearly singular next to the bifurcation, which was found on them up to some 1e-4 away. Over
/// such a distance of the parameter their state changes by its root.
constexpr double near_share = 1e-3;
constexpr double near_orbit = 1e-2;

}  // namespace

std::vector<CriticalOrbits> critical_orbits(BifurcationKind kind, const OrbitFamily& of_branch) {
  const int period = of_branch.period;
  switch (kind) {
    case BifurcationKind::fold: return {{of_branch, CriticalMultiplier::plus_one}};
    case BifurcationKind::symmetry_breaking:
      return {{{.period = period, .is_symmetric = true}, CriticalMultiplier::minus_one}};
    case BifurcationKind::period_doubling: {
      std::vector<CriticalOrbits> found{{{.period = period, .is_symmetric = false}, CriticalMultiplier::minus_one}};
      if (period % 2 == 0) {
        found.push_back({{.period = period / 2, .is_symmetric = false}, CriticalMultiplier::minus_one});
      }
      return found;
    }
    case BifurcationKind::grazing:
    case BifurcationKind::contact_change: break;
  }
  return {};
}

std::optional<CriticalPoint> critical_near(const CriticalFamily& family, const PlaneUnknowns& at,
                                           base::StopRequest stop) {
  const auto image = image_of(family, at);
  if (!image) return std::nullopt;
  auto found = correct(family, border_of(family, *image), {.normal = {0.0, 0.0, 0.0, 0.0, 1.0}, .through = at}, stop);
  if (!found || std::abs(found->at[3] - at[3]) > near_share) return std::nullopt;
  if (norm(plus(found->at, -1.0, at)) > near_orbit) return std::nullopt;
  return found;
}

}  // namespace rocking

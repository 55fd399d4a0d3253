#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/trajectory.hpp"

namespace rocking {

/// How motions near a periodic orbit approach or leave it, by its multipliers.
enum class OrbitKind : std::uint8_t {
  superstable,        ///< every small change is lost within the period: all multipliers are 0, or there is none
  node,               ///< inside the unit circle, the largest one real
  focus,              ///< inside, the largest ones a complex pair
  saddle,             ///< one outside, > 1
  flip_saddle,        ///< one outside, < -1
  unstable_node,      ///< several outside, real
  unstable_focus,     ///< several outside, the largest ones a complex pair
  not_differentiable  ///< the orbit passes a grazing or a coincidence of events, where there are no multipliers
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 8> orbit_kind_names{
    "superstable", "node", "focus", "saddle", "flip_saddle", "unstable_node", "unstable_focus", "not_differentiable"};
[[nodiscard]] constexpr std::string_view to_string(OrbitKind kind) {
  return orbit_kind_names[static_cast<std::size_t>(kind)];
}

/// Multipliers of the map over the period of an orbit.
struct Stability {
  /// Eigenvalues of the derivative within the contact state at the section, by falling modulus; of a pair, the one with
  /// the positive imaginary part first.
  std::vector<std::complex<double>> multipliers;
  OrbitKind kind = OrbitKind::not_differentiable;

  [[nodiscard]] bool is_stable() const {
    return kind == OrbitKind::superstable || kind == OrbitKind::node || kind == OrbitKind::focus;
  }
};

struct PoincareImage;
[[nodiscard]] Stability stability_of(const PoincareImage& image);

/// The kind that belongs to multipliers sorted as in Stability.
[[nodiscard]] OrbitKind kind_of(const std::vector<std::complex<double>>& multipliers);

/// What the search for an orbit started from: the end of the condition's run, a start of the grid, the mirror image of
/// an orbit found, or a branch that passes the condition.
enum class FoundBy : std::uint8_t { run, grid, mirror, continuation };

/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> found_by_names{"run", "grid", "mirror", "continuation"};
[[nodiscard]] constexpr std::string_view to_string(FoundBy found_by) {
  return found_by_names[static_cast<std::size_t>(found_by)];
}

/// A periodic orbit.
struct Orbit {
  int period = 0;                    ///< n: excitation periods until it repeats, the smallest number
  int cycles = 0;                    ///< m: pairs of impacts in them, rounded up
  std::vector<SectionState> points;  ///< at the n instants of the section
  double residual = 0.0;             ///< of the map over n periods, from the first point
  Stability stability;
  FoundBy found_by = FoundBy::run;
  bool is_symmetric = true;                          ///< it is its own mirror image, or none is known
  std::optional<std::size_t> mirror = std::nullopt;  ///< place of its mirror image in a list of all; absent elsewhere
};

/// Orbits that are followed together: their period, and whether they are symmetric.
struct OrbitFamily {
  int period = 1;
  bool is_symmetric = false;
};

struct FixedPoint;
struct PoincareImage;
class PoincareMap;

/// Whether two cycles are the same one, up to a shift by whole periods and the residual.
[[nodiscard]] bool is_same_cycle(const std::vector<SectionState>& a, const std::vector<SectionState>& b);

/// The orbit through a point that the map takes back to itself.
[[nodiscard]] Orbit orbit_through(const section::StrobePoint& point, const PoincareImage& image, double residual,
                                  FoundBy found_by);

/// The orbit of a fixed point, with its smallest period; absent if Newton's method does not find it over that period.
[[nodiscard]] std::optional<Orbit> orbit_of(const PoincareMap& map, FixedPoint fixed, FoundBy found_by,
                                            base::StopRequest stop);

/// Place of a cycle in a list of orbits; absent if it is not there.
[[nodiscard]] std::optional<std::size_t> place_of(const std::vector<SectionState>& cycle,
                                                  const std::vector<Orbit>& orbits);

/// The states of the mirror image of an orbit, its negative half a period later; absent where the motion ends before.
[[nodiscard]] std::optional<std::vector<SectionState>> mirror_image_of(const PoincareMap& map, const Orbit& orbit);

/// Values of a parameter within which orbits are followed: low < high.
struct ParameterRange {
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double value(double q) const { return low + q * (high - low); }
  [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

/// What happens to the orbits of a branch at a value of the parameter.
enum class BifurcationKind : std::uint8_t {
  fold,               ///< the branch turns back: a multiplier passes 1
  period_doubling,    ///< a multiplier passes -1; a branch of twice the period begins
  symmetry_breaking,  ///< symmetric orbits: a multiplier of the mirrored map over half the period passes -1; two
                      ///< branches begin, each the mirror image of the other
  neimark_sacker,     ///< a complex pair of multipliers passes the unit circle; a torus begins
  grazing,            ///< the contact sequence changes by a guard that is reached at a rate of 0
  contact_change      ///< the contact sequence changes otherwise
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 6> bifurcation_kind_names{
    "fold", "period_doubling", "symmetry_breaking", "neimark_sacker", "grazing", "contact_change"};
[[nodiscard]] constexpr std::string_view to_string(BifurcationKind kind) {
  return bifurcation_kind_names[static_cast<std::size_t>(kind)];
}

/// Why a branch ends.
enum class BranchEnd : std::uint8_t {
  range,           ///< the end of the range of the parameter
  joins,           ///< it branches off here: from orbits of half the period, or from symmetric ones
  grazing,         ///< the contact sequence changes by grazing, and no orbit near continues it
  contact_change,  ///< the contact sequence changes otherwise, likewise
  last_point,      ///< no further orbit was found, and why was not located
  closed,          ///< it has come back to its start
  known,           ///< it has come to a branch that is listed
  points           ///< the largest number of points is reached
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 8> branch_end_names{"range",      "joins",  "grazing", "contact_change",
                                                                  "last_point", "closed", "known",   "points"};
[[nodiscard]] constexpr std::string_view to_string(BranchEnd end) {
  return branch_end_names[static_cast<std::size_t>(end)];
}

/// An orbit at a value of the parameter.
struct BranchPoint {
  double value = 0.0;
  Orbit orbit;
};

/// Orbits that are connected over the parameter, by pseudo-arclength.
struct OrbitBranch {
  int period = 1;
  bool is_symmetric = false;                       ///< else its mirror image is a branch, too, which is not listed
  std::vector<BranchPoint> points = {};            ///< by arclength
  std::array<BranchEnd, 2> ends{};                 ///< before the first point and behind the last one
  std::optional<std::size_t> from = std::nullopt;  ///< the bifurcation at which it branches off, if that was followed
};

/// m of its response mode: that of most of its orbits, since one beside a grazing may have an impact more or less.
[[nodiscard]] int cycles_of(const OrbitBranch& branch);

/// A bifurcation on a branch.
struct Bifurcation {
  BifurcationKind kind = BifurcationKind::fold;
  double value = 0.0;                         ///< of the parameter
  double error = 0.0;                         ///< largest error of `value`
  std::size_t branch = 0;                     ///< place of the branch
  std::optional<Orbit> orbit = std::nullopt;  ///< there
};

/// Branches and their bifurcations.
struct BranchStudy {
  std::vector<OrbitBranch> branches;
  std::vector<Bifurcation> bifurcations;
  bool is_complete = true;  ///< every known orbit was followed: `most_branches` was enough
};

}  // namespace rocking

#pragma once

#include "rocking/studies/orbits/orbit.hpp"

namespace rocking {

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

#pragma once

#include <vector>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/corrector.hpp"

namespace rocking {

/// A bifurcation on a curve of orbits.
struct LocatedBifurcation {
  BifurcationKind kind = BifurcationKind::fold;
  CurvePoint point;    ///< an orbit there, or next to it
  double share = 0.0;  ///< of the range, at the bifurcation
  double error = 0.0;  ///< of `share`
};

/// What lies on a curve between two of its points.
struct Passage {
  std::vector<CurvePoint> points;  ///< in order, without the first point; with the last one, unless the curve ends
  std::vector<LocatedBifurcation> bifurcations;
  bool is_broken = false;  ///< a bifurcation could not be located: the two points may not be on one curve
  bool is_joined = false;  ///< it ends where it branches off from the family of the mirror image or of half the period
};

/// Whether two orbits of a family have the same changes of contact.
[[nodiscard]] bool is_same_contact(const OrbitFamily& orbits, const PoincareImage& a, const PoincareImage& b);

/// Locates the bifurcations between two neighbouring points of a curve, and its orbits at the `wanted` values of the
/// parameter between them. Each bifurcation is bracketed to 1e-9 in the parameter by a change of sign of its test
/// function, or by a change of the contact sequence. The error of a bracket is its width and the errors of its two orbits.
/// A grazing in it is located by graze().
class PassageSearch {
 public:
  PassageSearch(const MapFamily& family, const std::vector<double>& wanted, base::StopRequest stop)
      : family_(&family), wanted_(&wanted), stop_(stop) {}

  [[nodiscard]] Passage between(const CurvePoint& a, const CurvePoint& b) const;

 private:
  struct Pair {
    CurvePoint before, after;
  };

  void pass(const CurvePoint& a, const CurvePoint& b, int depth, Passage& passage) const;
  void pass_smoothly(const CurvePoint& a, const CurvePoint& b, Passage& passage) const;
  void add_wanted(const CurvePoint& a, const CurvePoint& b, std::vector<CurvePoint>& points) const;
  [[nodiscard]] Pair change_of_contact(const CurvePoint& a, const CurvePoint& b) const;
  [[nodiscard]] std::optional<LocatedBifurcation> located(const CurvePoint& a, const Pair& pair,
                                                          const CurvePoint& b) const;
  template <class Test>
  [[nodiscard]] std::optional<LocatedBifurcation> locate(const CurvePoint& a, const CurvePoint& b, BifurcationKind kind,
                                                         Test&& test, Passage& passage) const;
  [[nodiscard]] std::optional<CurvePoint> at_share(const CurvePoint& a, const CurvePoint& b, double share) const;
  [[nodiscard]] double width(const CurvePoint& a, const CurvePoint& b) const;
  [[nodiscard]] bool is_near(const CurvePoint& a, const CurvePoint& b, double most_apart) const;

  const MapFamily* family_;
  const std::vector<double>* wanted_;
  base::StopRequest stop_;
};

}  // namespace rocking

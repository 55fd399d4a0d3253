#include "rocking/studies/orbits/trace.hpp"

#include <iterator>
#include <utility>

#include "rocking/studies/orbits/bracket.hpp"

namespace rocking {
namespace {

// The width of a bracket, and in all unknowns: at a fold the parameter changes by the square of the state, 1e-12. Both are
// above what rounding leaves of a residual: 1e-13 over a distance of the multipliers from 1 of 1e-4.
constexpr double parameter_width = 1e-9;
constexpr double state_width = 1e-6;
/// The same where the contacts change. Next to a grazing there are two curves, whose distance is that of the parameter
/// from the grazing times a number of order 1: at 1e-8 the change is not taken for one between them.
constexpr double contact_width = 1e-8;
/// Distance of two points between which orbits cross those from which they branch off. There the equations of the curve are
/// singular, and Newton's method may fail in between; the orbit with the critical multiplier is solved for in any case.
constexpr double joint_width = 1e-3;
/// Between the orbits beside a grazing on both sides: that which reaches the guard is at a rate of 1e-6.
constexpr double same_grazing = 1e-5;
/// Changes of contact between two neighbouring points. A step of 0.02 rarely has more than one; six bound the work next
/// to a chatter.
constexpr int most_changes = 6;

ContactSequence whole_sequence(const OrbitFamily& orbits, const PoincareImage& image) {
  ContactSequence sequence = image.sequence;
  if (!orbits.is_symmetric) return sequence;
  const ContactSequence second = mirrored(image.sequence);
  sequence.insert(sequence.end(), second.begin(), second.end());
  return sequence;
}

double product(const section::StrobePoint& a, const section::StrobePoint& b) {
  return a.tilt * b.tilt + a.tilt_rate * b.tilt_rate + a.slip_rate * b.slip_rate;
}

/// Of the share: the width of a bracket, and the errors of its orbits.
double bracket_error(const CurvePoint& a, const CurvePoint& b) {
  return std::abs(a.at[3] - b.at[3]) + std::max(a.error, b.error);
}

bool is_one(const Grazing& a, const Grazing& b) {
  return std::abs(a.share - b.share) <= a.error + b.error && norm(plus(a.beside.at, -1.0, b.beside.at)) < same_grazing;
}

bool changes_sign(double a, double b) { return (a > 0.0) != (b > 0.0); }

}  // namespace

bool is_same_contact(const OrbitFamily& orbits, const PoincareImage& a, const PoincareImage& b) {
  return is_same_sequence(whole_sequence(orbits, a), whole_sequence(orbits, b));
}

namespace {

class PassageSearch {
 public:
  PassageSearch(const MapFamily& family, const std::vector<double>& wanted, base::StopRequest stop)
      : family_(&family), wanted_(&wanted), stop_(stop) {}

  [[nodiscard]] Passage between(const CurvePoint& a, const CurvePoint& b) const {
    Passage passage;
    pass(a, b, most_changes, passage);
    return passage;
  }

 private:
  struct Pair {
    CurvePoint before, after;
  };

  [[nodiscard]] std::optional<CurvePoint> at_share(const CurvePoint& a, const CurvePoint& b, double share) const {
    const Unknowns along = plus(b.at, -1.0, a.at);
    return correct(*family_, {.normal = plus({}, 1.0 / norm(along), along), .through = plus(a.at, share, along)},
                   stop_);
  }

  [[nodiscard]] double width(const CurvePoint& a, const CurvePoint& b) const {
    return std::abs(a.at[3] - b.at[3]) * (family_->range().high - family_->range().low);
  }

  [[nodiscard]] bool is_near(const CurvePoint& a, const CurvePoint& b, double most_apart) const {
    return width(a, b) <= parameter_width && norm(plus(a.at, -1.0, b.at)) <= most_apart;
  }

  [[nodiscard]] Pair change_of_contact(const CurvePoint& a, const CurvePoint& b) const {
    Pair pair{a, b};
    for (int i = 0; i < 60 && !is_near(pair.before, pair.after, contact_width); ++i) {
      std::optional<CurvePoint> middle;
      for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9}) {
        middle = at_share(pair.before, pair.after, share);
        if (middle) break;
      }
      if (!middle) break;
      (is_same_contact(family_->orbits(), a.image, middle->image) ? pair.before : pair.after) = std::move(*middle);
    }
    return pair;
  }

  template <class Test>
  std::optional<LocatedBifurcation> locate(const CurvePoint& a, const CurvePoint& b, BifurcationKind kind, Test&& test,
                                           Passage& passage) const {
    const std::optional<double> at_a = test(a);
    const std::optional<double> at_b = test(b);
    if (!at_a || !at_b || !changes_sign(*at_a, *at_b)) return std::nullopt;
    CurvePoint low = a;
    CurvePoint high = b;
    double at_low = 0.0;
    double at_high = 1.0;
    const auto value = [&](double share) -> std::optional<double> {
      auto point = at_share(a, b, share);
      if (!point) return std::nullopt;
      const std::optional<double> found = test(*point);
      if (!found) return std::nullopt;
      if (!changes_sign(*found, *at_a)) {
        if (share > at_low) low = std::move(*point), at_low = share;
      } else if (share < at_high) {
        high = std::move(*point), at_high = share;
      }
      return found;
    };
    static_cast<void>(shorten({.low = 0.0, .high = 1.0, .at_low = *at_a, .at_high = *at_b}, value,
                              [&](const Bracket&) { return is_near(low, high, state_width); }));
    if (!is_near(low, high, state_width)) {
      // Newton's method failed in between. From points that are closer together it may not.
      passage.is_broken = passage.is_broken || norm(plus(a.at, -1.0, b.at)) > state_width;
      return std::nullopt;
    }
    const double of_low = std::abs(test(low).value_or(1.0));
    const double of_high = std::abs(test(high).value_or(1.0));
    // Where it jumps or has a pole instead, it does not become small.
    if (!(std::min(of_low, of_high) < std::min(std::abs(*at_a), std::abs(*at_b)) + 1e-9)) return std::nullopt;
    const double error = bracket_error(low, high);
    CurvePoint& nearer = of_low < of_high ? low : high;
    const double share = nearer.at[3];
    return LocatedBifurcation{.kind = kind, .point = std::move(nearer), .share = share, .error = error};
  }

  void add_wanted(const CurvePoint& a, const CurvePoint& b, std::vector<CurvePoint>& points) const {
    std::vector<CurvePoint> found;
    for (const double q : *wanted_) {
      const bool is_between = a.at[3] < b.at[3] ? a.at[3] < q && q < b.at[3] : b.at[3] < q && q < a.at[3];
      if (!is_between) continue;
      const double share = (q - a.at[3]) / (b.at[3] - a.at[3]);
      Unknowns through = plus(a.at, share, plus(b.at, -1.0, a.at));
      through[3] = q;
      auto point =
          correct(*family_, {.normal = {0.0, 0.0, 0.0, b.at[3] > a.at[3] ? 1.0 : -1.0}, .through = through}, stop_);
      if (!point || norm(plus(point->at, -1.0, through)) > norm(plus(b.at, -1.0, a.at))) continue;
      point->at[3] = q;
      found.push_back(std::move(*point));
    }
    const bool is_rising = a.at[3] < b.at[3];
    std::ranges::sort(found, [is_rising](const CurvePoint& x, const CurvePoint& y) {
      return is_rising ? x.at[3] < y.at[3] : x.at[3] > y.at[3];
    });
    std::ranges::move(found, std::back_inserter(points));
  }

  void pass_smoothly(const CurvePoint& a, const CurvePoint& b, Passage& passage) const {
    const bool is_symmetric = family_->orbits().is_symmetric;
    if (a.asymmetry && b.asymmetry && product(*a.asymmetry, *b.asymmetry) < 0.0) {
      const BifurcationKind joins =
          family_->orbits().period % 2 == 0 ? BifurcationKind::period_doubling : BifurcationKind::symmetry_breaking;
      auto joint = locate(
          a, b, joins,
          [&a](const CurvePoint& point) -> std::optional<double> {
            if (!point.asymmetry) return std::nullopt;
            return product(*point.asymmetry, *a.asymmetry);
          },
          passage);
      if (!joint && norm(plus(a.at, -1.0, b.at)) <= joint_width) {
        joint = LocatedBifurcation{.kind = joins, .point = a, .share = a.at[3], .error = bracket_error(a, b)};
        passage.is_broken = false;
      }
      if (passage.is_broken) return;
      if (joint) {
        passage.bifurcations.push_back(std::move(*joint));
        passage.is_joined = true;
        return;
      }
    }
    auto fold = locate(
        a, b, BifurcationKind::fold, [](const CurvePoint& point) { return std::optional(point.fold()); }, passage);
    auto flip = locate(
        a, b, is_symmetric ? BifurcationKind::symmetry_breaking : BifurcationKind::period_doubling,
        [](const CurvePoint& point) { return std::optional(point.flip); }, passage);
    auto pair = locate(
        a, b, BifurcationKind::neimark_sacker, [](const CurvePoint& point) { return point.pair; }, passage);
    if (fold) {
      add_wanted(a, fold->point, passage.points);
      passage.points.push_back(fold->point);
      add_wanted(fold->point, b, passage.points);
      passage.bifurcations.push_back(std::move(*fold));
    } else {
      add_wanted(a, b, passage.points);
    }
    if (flip) passage.bifurcations.push_back(std::move(*flip));
    if (pair) passage.bifurcations.push_back(std::move(*pair));
    passage.points.push_back(b);
  }

  void pass(const CurvePoint& a, const CurvePoint& b, int depth, Passage& passage) const {
    if (depth == 0 || is_same_contact(family_->orbits(), a.image, b.image)) return pass_smoothly(a, b, passage);
    auto [before, after] = change_of_contact(a, b);
    auto change = located(a, {before, after}, b);
    if (!change) {
      passage.is_broken = true;
      return;
    }
    if (norm(plus(before.at, -1.0, a.at)) > 0.0) pass_smoothly(a, before, passage);
    if (passage.is_joined || passage.is_broken) return;
    passage.bifurcations.push_back(std::move(*change));
    passage.points.push_back(after);
    if (norm(plus(after.at, -1.0, b.at)) > 0.0) pass(after, b, depth - 1, passage);
  }

  [[nodiscard]] std::optional<LocatedBifurcation> located(const CurvePoint& a, const Pair& pair,
                                                          const CurvePoint& b) const {
    auto before = graze(*family_, std::array{a, pair.before}, stop_);
    auto after = graze(*family_, std::array{b, pair.after}, stop_);
    const double error = bracket_error(pair.before, pair.after);
    const auto is_in_bracket = [&](const std::optional<Grazing>& one) {
      return one && std::abs(one->share - pair.before.at[3]) <= one->error + error;
    };
    if (!is_near(pair.before, pair.after, contact_width)) {
      if (!before || !after || !is_one(*before, *after)) return std::nullopt;
    } else if (!is_in_bracket(before) && !is_in_bracket(after)) {
      return LocatedBifurcation{
          .kind = BifurcationKind::contact_change, .point = pair.before, .share = pair.before.at[3], .error = error};
    }
    if (!before || (after && after->error < before->error)) before = std::move(after);
    return LocatedBifurcation{.kind = BifurcationKind::grazing,
                              .point = std::move(before->beside),
                              .share = before->share,
                              .error = before->error};
  }

  const MapFamily* family_;
  const std::vector<double>* wanted_;
  base::StopRequest stop_;
};

}  // namespace

Passage passage_between(const CurvePoint& a, const CurvePoint& b, const MapFamily& family,
                        const std::vector<double>& wanted, base::StopRequest stop) {
  return PassageSearch(family, wanted, stop).between(a, b);
}

}  // namespace rocking

#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/fragility/study.hpp"

namespace rocking::analysis {

/// The figure `fragility`: for each run a panel with the overturning probability against the intensity, a marker with its
/// exact interval for each level, and the fitted laws with their bands, or, where a law was rejected, the isotonic
/// estimates as steps with their bands.
[[nodiscard]] Figure fragility_figure(const FragilityReport& report);

/// The figure `surface`: for each fitted surface a panel with its probability over both measures, and one with the width
/// of its interval. Absent without one.
[[nodiscard]] std::optional<Figure> surface_figure(const FragilityReport& report);

/// Points at which a law is drawn, less one.
inline constexpr int points_of_a_law = 120;

/// `overturned`, `peak tilt > 0.5`, `slip > 0.05 m`.
[[nodiscard]] std::string event_in_words(const ResponseEvent& event);
/// Of what a probability is: `overturning`, or the same as event_in_words().
[[nodiscard]] std::string probability_of(const ResponseEvent& event);

/// Adds to the last panel the rare estimates of curve `number`, if it has any, with their intervals; `legend` is what the
/// other marks of the curve are called.
void add_rare(const std::vector<RareLevel>& levels, std::size_t number, const std::string& legend, Figure& figure);

/// Which curve of a panel is drawn.
struct PlaceInPanel {
  std::size_t number = 0;
  bool is_alone = true;  ///< no other curve is in the panel
};

/// Adds the curve of one motion to the last panel.
void add_curve(const ReportedCurve& reported, const PlaceInPanel& place, Figure& figure);

/// Adds a curve to the last panel: the means of the shares of the records of a suite as markers, and the law of the suite,
/// or the isotonic shares where none holds, with their band; if it is alone, also a thin line for each record.
void add_suite(const SuiteCurve& curve, const PlaceInPanel& place, Figure& figure);

}  // namespace rocking::analysis

#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// A point of a hazard curve.
struct HazardPoint {
  double intensity = 0.0;  ///< > 0, in the unit of the fragility function
  double rate = 0.0;       ///< annual rate at which this intensity is exceeded [1/year], >= 0
};

/// Where a hazard curve holds [degrees].
struct HazardSite {
  double longitude = 0.0;
  double latitude = 0.0;
};

/// A hazard curve: the logarithm of the rate is linear in that of the intensity between points. Beyond the last point it
/// continues as on the last piece on which the rate falls; a rate of 0 ends the curve, and up to there it continues in
/// the same way. Nothing is known below the first point. At least two points; intensities rise, rates do not, and the
/// last rate is below the first.
struct HazardCurve {
  std::string name;             ///< of its file
  std::string intensity;        ///< its measure, as a run names its own: `pga_g`, `sa_g[0.5]`, `avgsa_g[0.2-2]`
  std::size_t header_line = 0;  ///< of the file, from 1; 0: it has none
  std::vector<HazardPoint> points;
  /// The file holds probabilities of exceedance in this time [years], from which the rates follow; absent: rates.
  std::optional<double> years = std::nullopt;
  std::string statistic = {};  ///< as the file states it: `mean`, `quantile-0.84`; empty: it does not
  std::optional<HazardSite> site = std::nullopt;
  std::size_t certain = 0;  ///< weaker points of the file with the probability 1, which gives no rate: left out
};

/// The site of `longitude, latitude`; absent if the list is empty. Throws base::InputError unless it has two numbers.
[[nodiscard]] std::optional<HazardSite> hazard_site(const std::vector<double>& numbers);

/// The rate of motions whose two measures lie in a cell.
struct JointCell {
  double x = 0.0, y = 0.0;  ///< of its middle, > 0
  double rate = 0.0;        ///< of occurrence in the cell, not of exceedance [1/year]
};

[[nodiscard]] inline bool is_sensible(const JointCell& cell) {
  const auto is_number = [](double value) { return value >= 0.0 && value <= std::numeric_limits<double>::max(); };
  return cell.x > 0.0 && cell.y > 0.0 && is_number(cell.x) && is_number(cell.y) && is_number(cell.rate);
}

/// A hazard of two measures at once.
struct JointHazard {
  std::string name;  ///< of its file
  std::vector<JointCell> cells;
};

/// What is said of a hazard file beside its text: what it leaves open, and which of its curves is meant.
struct HazardReading {
  std::optional<double> years = std::nullopt;  ///< of its probabilities of exceedance
  bool are_years_spare = false;                ///< rates, and probabilities whose time the file states, do without them
  std::optional<std::string> measure = std::nullopt;    ///< of its intensities: `PGA`, `sa_g[1]`
  std::optional<HazardSite> site = std::nullopt;        ///< to a tenth of a thousandth of a degree
  std::optional<std::string> statistic = std::nullopt;  ///< `mean`, `quantile-0.84`
};

/// What is wrong with a point of a hazard curve.
struct HazardFault {
  double HazardPoint::*number;  ///< of the point
  const char* reason;
  const char* remedy;
};

/// The fault of a point after the one before it, which is null for the first; absent if there is none.
[[nodiscard]] std::optional<HazardFault> fault_of(const HazardPoint& point, const HazardPoint* before);

/// What is wrong with the points of a curve as a whole, which have no fault; absent if nothing is. Its place is the name.
[[nodiscard]] std::optional<base::Problem> problem_of_whole(const HazardCurve& hazard);

/// What is wrong with a curve that was set in C++, at places within `hazard`.
[[nodiscard]] std::vector<base::Problem> problems_of(const HazardCurve& hazard);

/// The level, or the return period, for which a table selects the record of a scene.
[[nodiscard]] std::optional<double> selected_level(const Scene& scene);

/// The one of them that an experiment sweeps, or the level of its records; empty where it has none.
[[nodiscard]] std::string_view intensity_of(const Experiment& experiment);
/// Whether the levels of a table are return periods [years].
[[nodiscard]] bool has_return_periods(const Experiment& experiment);

/// The swept intensity with the periods that the experiment states, as a hazard curve names it: `sa_g[0.5]`; empty if
/// none is swept.
[[nodiscard]] std::string swept_measure(const Experiment& experiment);
/// The periods of the spectral acceleration that is swept [s]; empty: none.
[[nodiscard]] std::vector<double> measure_periods(const Experiment& experiment);

/// Throws base::InputError where the hazard curve is one of another intensity than that of the run, or of one period where
/// its sweep has several.
void check_hazard(const HazardCurve& hazard, const Experiment& experiment);

}  // namespace rocking

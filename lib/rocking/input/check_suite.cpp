#include "rocking/input/suite.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/input/record_unit.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr const char* suite_pointer = "/excitation/suite";
constexpr std::size_t most_reported = 5;
/// A series with fewer changes, such as a constant, may have the shape of another one by chance.
constexpr std::size_t least_changes = 20;
constexpr double equal_peaks = 1e-9;

/// A ground motion over its peak, by numbers that do not depend on its unit.
struct Series {
  std::size_t record = 0;
  const GroundMotion* motion = nullptr;
  double peak = 0.0;
  std::size_t peak_place = 0;
  double sum = 0.0;         ///< of the absolute values over the peak
  std::size_t changes = 0;  ///< samples that differ from the one before

  [[nodiscard]] double value(std::size_t i) const { return motion->samples[i].horizontal / peak; }
  [[nodiscard]] std::size_t size() const { return motion->samples.size(); }
  [[nodiscard]] double duration(std::size_t i) const { return motion->samples[i].time - motion->samples.front().time; }
};

Series series_of(std::size_t record, const GroundMotion& motion) {
  Series series{.record = record, .motion = &motion, .peak = peak_acceleration(motion.samples)};
  for (std::size_t i = 0; i < motion.samples.size(); ++i) {
    const double size = std::abs(motion.samples[i].horizontal);
    if (size == series.peak) series.peak_place = i;
    series.sum += size;
    if (i > 0 && motion.samples[i].horizontal != motion.samples[i - 1].horizontal) ++series.changes;
  }
  if (series.peak > 0.0) series.sum /= series.peak;
  return series;
}

bool is_close(double a, double b) { return std::abs(a - b) <= same_series_tolerance; }

/// Whether the peaks of series with equal shapes, of which `a` is one, are equal if this is their ratio.
bool is_one(double ratio, const Series& a) {
  return std::abs(ratio - 1.0) <= (a.changes < least_changes ? equal_peaks : same_series_tolerance);
}

/// Over the peaks. The longer one must be at rest beyond the end of the shorter one.
bool have_equal_shapes(const Series& a, const Series& b) {
  const std::size_t common = std::min(a.size(), b.size());
  if (a.peak_place >= common || b.peak_place >= common) return false;
  if (!is_close(a.value(a.peak_place), b.value(a.peak_place))) return false;
  const double length = a.duration(common - 1);
  const double step = length / static_cast<double>(common - 1);
  if (!(std::abs(length - b.duration(common - 1)) <= same_series_tolerance * length + step)) return false;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (!is_close(i < a.size() ? a.value(i) : 0.0, i < b.size() ? b.value(i) : 0.0)) return false;
  }
  return true;
}

/// The unit in which the accelerations of `a` would be those of `b`, if its own was assumed; absent if none is.
std::optional<RecordUnit> unit_instead(const Series& a, const Series& b) {
  if (!a.motion->unit_is_assumed) return std::nullopt;
  constexpr double gravity = 9.80665;
  const auto* const own = std::ranges::find(record_unit_names, a.motion->unit);
  if (own == record_unit_names.end()) return std::nullopt;
  const double of_own = in_m_s2(static_cast<RecordUnit>(own - record_unit_names.begin()), gravity);
  for (std::size_t i = 0; i < record_unit_names.size(); ++i) {
    const auto unit = static_cast<RecordUnit>(i);
    if (is_one(in_m_s2(unit, gravity) / of_own * a.peak / b.peak, a)) return unit;
  }
  return std::nullopt;
}

/// Why `later` is `former` once more; empty if it is not.
std::string why_same(const Series& later, const Series& former) {
  const std::string same = "has the same series as " + brief(Json(former.motion->name)) + ", to " +
                           base::significant(100.0 * same_series_tolerance, 2) + " % of its peak";
  if (is_one(later.peak / former.peak, later)) return have_equal_shapes(later, former) ? same : "";
  for (const auto& [one, other] : {std::pair{&later, &former}, std::pair{&former, &later}}) {
    const auto unit = unit_instead(*one, *other);
    if (!unit || !have_equal_shapes(later, former)) continue;
    return same + ", if " + one->motion->name + " is in " + std::string(name_of(*unit)) + "; " + one->motion->unit +
           " was assumed";
  }
  return {};
}

void refuse_vertical(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems) {
  std::size_t found = 0;
  for (const auto& motion : motions) {
    const auto why = why_vertical(*motion);
    if (!why || ++found > most_reported) continue;
    problems.push_back({suite_pointer, brief(Json(motion->name)),
                        "is a vertical component " + *why + "; a suite is of horizontal ones",
                        "leave it out, or give it to its horizontal component: {\"file\": ..., \"vertical_file\": " +
                            brief(Json(motion->name)) + '}'});
  }
  if (found > most_reported) {
    problems.back().reason += ", and so are " + std::to_string(found - most_reported) + " more";
  }
}

void refuse_repeated(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems) {
  std::vector<Series> all;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    all.push_back(series_of(i, *motions[i]));
    if (all.back().peak == 0.0) all.pop_back();
  }
  std::ranges::sort(all, {}, &Series::sum);
  std::size_t found = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // The sums of equal shapes of n samples differ by at most n times the tolerance.
    const double reach = same_series_tolerance * 1.5 * static_cast<double>(all[i].size());
    for (std::size_t k = i + 1; k < all.size() && all[k].sum - all[i].sum <= reach && found < most_reported; ++k) {
      const auto& [former, later] = std::minmax(all[i], all[k], [](auto& a, auto& b) { return a.record < b.record; });
      std::string reason = why_same(later, former);
      if (reason.empty()) continue;
      ++found;
      problems.push_back({suite_pointer, brief(Json(later.motion->name)), std::move(reason),
                          "name each record once; give \"units\" for files that do not state theirs"});
    }
  }
}

/// Sensors in boreholes beside others at the surface, where the motion is another one.
void refuse_boreholes(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems) {
  const auto is_at_surface = [](const auto& motion) { return !is_of_borehole(*motion); };
  const auto surface = std::ranges::find_if(motions, is_at_surface);
  if (surface == motions.end()) return;
  std::size_t found = 0;
  for (const auto& motion : motions) {
    if (!is_of_borehole(*motion) || ++found > most_reported) continue;
    problems.push_back({suite_pointer, brief(Json(motion->name)),
                        "is of a sensor in a borehole, but " + brief(Json((*surface)->name)) + " of one at the surface",
                        "leave one kind out: of KiK-net .NS2 and .EW2 are at the surface"});
  }
}

}  // namespace

void check_suite(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems) {
  refuse_vertical(motions, problems);
  refuse_boreholes(motions, problems);
  refuse_repeated(motions, problems);
}

}  // namespace rocking

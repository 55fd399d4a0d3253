#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

constexpr double site_tolerance = 1e-4;  // degrees: 11 m; OpenQuake writes five digits behind the point
constexpr std::size_t most_listed = 8;
constexpr std::string_view not_stated = "(not stated)";

std::string site_word(const HazardInFile& curve) {
  if (!curve.site) return std::string(not_stated);
  return base::shortest(curve.site->longitude) + ',' + base::shortest(curve.site->latitude);
}

std::string measure_word(const HazardInFile& curve) {
  return curve.measure.empty() ? std::string(not_stated) : curve.measure;
}

std::string statistic_of(const HazardInFile& curve) {
  return curve.statistic.empty() ? std::string(not_stated) : curve.statistic;
}

/// What the curves of a file may differ in.
struct Distinction {
  const char* flag;
  std::string (*word)(const HazardInFile&);
};
constexpr Distinction by_site{"--site", site_word};
constexpr Distinction by_measure{"--imt", measure_word};
constexpr Distinction by_statistic{"--statistic", statistic_of};

/// The different words of the curves in their order: `PGA, SA(0.1), ...`; their number.
std::pair<std::string, std::size_t> words_of(const std::vector<HazardInFile>& curves, const Distinction& by) {
  std::set<std::string> known;
  std::string list;
  for (const HazardInFile& curve : curves) {
    const std::string word = by.word(curve);
    if (!known.insert(word).second || known.size() > most_listed) continue;
    list += (list.empty() ? "" : " or ") + word;
  }
  if (known.size() > most_listed) list += " or " + std::to_string(known.size() - most_listed) + " more";
  return {list, known.size()};
}

template <class Fits>
void keep(std::vector<HazardInFile>& curves, const Distinction& by, const std::string& asked, const std::string& name,
          const Fits& fits) {
  const std::string all = words_of(curves, by).first;
  std::erase_if(curves, [&fits](const HazardInFile& curve) { return !fits(curve); });
  if (curves.empty()) {
    throw base::InputError({by.flag, asked, "is not in " + name, "choose what the file has: " + all});
  }
}

void keep_asked(std::vector<HazardInFile>& curves, const std::string& name, const HazardReading& reading) {
  if (reading.measure) {
    const std::optional<HazardMeasure> asked = hazard_measure(*reading.measure);
    if (!asked) {
      throw base::InputError(
          {"--imt", *reading.measure, "is no known intensity measure", HazardPoints::known_measures});
    }
    keep(curves, by_measure, *reading.measure, name, [&asked](const HazardInFile& curve) {
      if (curve.measure.empty()) return true;  // the flag names it
      const std::optional<HazardMeasure> measure = hazard_measure(curve.measure);
      return measure && measure->name == asked->name;
    });
  }
  if (reading.statistic) {
    const std::string asked = statistic_word(*reading.statistic);
    keep(curves, by_statistic, *reading.statistic, name,
         [&asked](const HazardInFile& curve) { return curve.statistic == asked; });
  }
  if (!reading.site) return;
  const HazardSite& asked = *reading.site;
  keep(curves, by_site, base::shortest(asked.longitude) + ',' + base::shortest(asked.latitude), name,
       [&asked](const HazardInFile& curve) {
         return curve.site && std::abs(curve.site->longitude - asked.longitude) <= site_tolerance &&
                std::abs(curve.site->latitude - asked.latitude) <= site_tolerance;
       });
}

[[noreturn]] void refuse_several(const std::vector<HazardInFile>& curves, const std::string& name) {
  std::string remedy;
  for (const Distinction& by : {by_site, by_measure, by_statistic}) {
    const auto [list, count] = words_of(curves, by);
    if (count > 1) remedy += (remedy.empty() ? "choose " : "; and ") + (by.flag + (' ' + list));
  }
  if (remedy.empty()) {
    remedy =
        "keep one of those with the same site, measure and statistic: " + curves[0].place + " and " + curves[1].place;
  }
  throw base::InputError(
      {name, std::to_string(curves.size()) + " hazard curves", "of which only one can be used", std::move(remedy)});
}

}  // namespace

std::string statistic_word(std::string_view text) {
  std::string word = in_small_letters(std::string(text));
  constexpr std::string_view quantile = "quantile";
  if (!word.starts_with(quantile)) return word;
  const std::size_t place = std::min(word.find_first_not_of("-_ ", quantile.size()), word.size());
  const std::optional<double> share = hazard_number(word.substr(place));
  return share ? std::string(quantile) + '-' + base::shortest(*share) : word;
}

HazardCurve chosen_hazard(std::vector<HazardInFile> curves, const std::string& name, const HazardReading& reading) {
  keep_asked(curves, name, reading);
  if (curves.size() > 1) refuse_several(curves, name);
  const HazardInFile& curve = curves.front();
  HazardPoints points(name, reading);
  points.set_origin(curve.statistic, curve.site);
  const std::optional<HazardMeasure> measure = hazard_measure(curve.measure);
  if (!measure && !curve.measure.empty()) {
    points.reject(curve.place, curve.measure, "is no known intensity measure", HazardPoints::known_measures);
  } else {
    points.set_measure(curve.place, measure);
  }
  points.set_kind(curve.place, curve.kind.is_probability ? "poe" : "annual rate", curve.kind);
  curve.add_points(points);
  return points.finish();
}

}  // namespace rocking

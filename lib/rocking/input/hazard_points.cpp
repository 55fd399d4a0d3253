#include "rocking/input/read_hazard.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/hazard.hpp"

namespace rocking {
namespace {

/// A unit in which the numbers of a file may be instead, by the end of the name of the measure.
struct OtherUnit {
  std::string_view ending;
  double divisor;  ///< of HazardMeasure
  double factor;   ///< of the number in the other unit
  std::string_view name;
};
constexpr std::array<OtherUnit, 7> other_units{{{"_g", 1.0, 9.80665, "m/s2"},
                                                {"_g", 1.0, 980.665, "cm/s2"},
                                                {"_g", 1.0, 1000.0, "mg"},
                                                {"_m_s", 1.0, 100.0, "cm/s"},
                                                {"_m_s", 1.0, 1000.0, "mm/s"},
                                                {"_m_s", 100.0, 10.0, "mm/s"},
                                                {"_m_s2", 1.0, 100.0, "cm/s2"}}};

/// The rate [1/year] at which no place on earth exceeds an intensity, `size` times 1 g of peak acceleration or 1 m/s of
/// velocity, which come together. Ten times the rates of the strongest hazards in use (2 g at 2e-4, 5 g at 3e-6); from there
/// to what a straight line in logarithms is drawn to, somewhat more.
double largest_credible_rate(double size) {
  constexpr double at_two = 2e-3;
  constexpr double exponent = 4.58;  // ln(2e-3/3e-5)/ln(5/2)
  constexpr double end_of_lines = 12.0;
  constexpr double of_lines = 2e-5;
  constexpr double largest_in_any_unit = 1e4;  // beyond it stands no intensity but the end of a line without one
  if (size > largest_in_any_unit) return std::numeric_limits<double>::infinity();
  const double rate = at_two * std::pow(0.5 * size, -exponent);
  return size <= end_of_lines ? std::max(rate, of_lines) : rate;
}

/// Of an intensity of 1: the peak acceleration over 1 g, or the peak velocity over 1 m/s, that comes with it. Spectral
/// accelerations reach three times the peak.
double size_of(std::string_view key) {
  const double of_kind = key.starts_with("sa_") || key.starts_with("avgsa_") ? 1.0 / 3.0 : 1.0;
  return key.ends_with("_m_s2") ? of_kind / 9.80665 : of_kind;
}

/// A hazard curve in cm/s does not end here [cm/s].
constexpr double least_last_velocity = 10.0;
constexpr std::size_t most_problems_of_a_curve = 20;

}  // namespace

std::optional<double> hazard_number(const std::string& field) {
  const char* first = field.data() + (field.starts_with('+') ? 1 : 0);
  const char* last = field.data() + field.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

HazardPoints::HazardPoints(std::string name, HazardReading reading) : reading_(std::move(reading)) {
  curve_.name = std::move(name);
}

void HazardPoints::reject(std::string place, std::string found, std::string reason, std::string remedy) {
  if (problems_.size() == most_problems_of_a_curve) return;
  problems_.push_back({std::move(place), std::move(found), std::move(reason), std::move(remedy)});
}

void HazardPoints::set_origin(const std::string& statistic, const std::optional<HazardSite>& site) {
  curve_.statistic = statistic;
  curve_.site = site;
}

void HazardPoints::set_measure(const std::string& place, const std::optional<HazardMeasure>& named) {
  std::optional<HazardMeasure> asked;
  if (reading_.measure) {
    asked = hazard_measure(*reading_.measure);
    if (!asked) return reject("--imt", *reading_.measure, "is no known intensity measure", known_measures);
  }
  if (!named && !asked) {
    return reject(place, "", "does not name its intensity measure",
                  "begin it with a line such as \"pga_g, annual_rate\", or name it, as --imt pga_g");
  }
  if (named && asked && named->name != asked->name) {
    return reject(place, named->name, "is not the measure that --imt asks for, " + asked->name, "omit --imt");
  }
  measure_ = named ? *named : *asked;
  curve_.intensity = measure_.name;
}

void HazardPoints::set_kind(const std::string& place, const std::string& word, const HazardKind& kind) {
  if (!kind.is_probability) {
    if (reading_.years && !reading_.are_years_spare)
      reject(place, word, "is no probability, so that --years means nothing", "omit --years");
    return;
  }
  curve_.years = kind.years ? kind.years : reading_.years;
  if (!curve_.years) {
    return reject(place, word, "is a probability in a time that is not stated",
                  "state the years, as --years 50, or name the column \"poe[50]\"");
  }
  if (!reading_.are_years_spare && reading_.years && *reading_.years != *curve_.years) {
    reject(place, word, "states another time than --years " + base::shortest(*reading_.years), "omit --years");
  }
}

void HazardPoints::add(const std::string& place, const std::string& intensity, const std::string& value) {
  const std::optional<double> x = hazard_number(intensity);
  const std::optional<double> y = hazard_number(value);
  if (!x) return reject(place, intensity, "is not a number", "give the intensity as a number, 0.25");
  if (!y) return reject(place, value, "is not a number", "give the rate of exceedance as a number, 2.1e-3");
  if (curve_.years && *y > 1.0) {
    return reject(place, value, "is no probability, which is at most 1",
                  "give a number below 1, or name the column annual_rate if it is a rate");
  }
  if (curve_.years && *y == 1.0) {
    if (size() == 0) {
      ++curve_.certain;
      return;
    }
    return reject(place, value, "is a probability that no rate of exceedance gives", "omit the line");
  }
  const double rate = curve_.years ? -std::log1p(-*y) / *curve_.years : *y;
  const HazardPoint point{.intensity = *x / measure_.divisor, .rate = rate};
  if (const auto fault = fault_of(point, size() > 0 ? &curve_.points.back() : nullptr)) {
    return reject(place, fault->number == &HazardPoint::rate ? value : intensity, fault->reason, fault->remedy);
  }
  curve_.points.push_back(point);
}

bool HazardPoints::is_enough() const {
  return size() > most_hazard_points || problems_.size() == most_problems_of_a_curve;
}

HazardCurve HazardPoints::finish() {
  if (size() > most_hazard_points) {
    const std::string most = std::to_string(most_hazard_points);
    problems_ = {{curve_.name, "more than " + most + " points", "is too large for a hazard curve",
                  "give at most " + most +
                      " points: between them the logarithm of the rate is linear in that of the intensity"}};
  }
  if (problems_.empty()) check_whole();
  if (!problems_.empty()) throw base::InputError(std::move(problems_));
  return std::move(curve_);
}

void HazardPoints::check_whole() {
  if (auto problem = problem_of_whole(curve_)) {
    problems_.push_back(*std::move(problem));
    return;
  }
  check_unit();
}

/// Refuses intensities that would occur more often than anywhere on earth, and velocities in cm/s of which none is felt.
void HazardPoints::check_unit() {
  const std::string key = curve_.intensity.substr(0, curve_.intensity.find('['));
  const std::string place =
      curve_.name + (curve_.header_line == 0 ? "" : ", line " + std::to_string(curve_.header_line));
  const auto incredible = [&](double factor) {
    return std::ranges::find_if(curve_.points, [&](const HazardPoint& point) {
      return point.rate > largest_credible_rate(point.intensity * size_of(key) / factor);
    });
  };
  const OtherUnit* likely = nullptr;
  for (const OtherUnit& unit : other_units) {
    if (!key.ends_with(unit.ending) || unit.divisor != measure_.divisor) continue;
    if (likely == nullptr || incredible(likely->factor) != curve_.points.end()) likely = &unit;
  }
  const auto found = incredible(1.0);
  if (likely != nullptr && found != curve_.points.end()) {
    const double written = found->intensity * measure_.divisor;
    return reject(place, curve_.intensity,
                  "does not fit the intensities: " + base::significant(written, 6) + " would be exceeded " +
                      base::significant(found->rate, 3) +
                      " times a year, which no place on earth has; they are likely in " + std::string(likely->name),
                  "divide them by " + base::shortest(likely->factor) + ", so that this is " +
                      base::significant(written / likely->factor, 3));
  }
  const double last = curve_.points.back().intensity * measure_.divisor;
  if (measure_.divisor != 1.0 && last < least_last_velocity) {
    reject(place, curve_.intensity,
           "is read in cm/s and does not fit the intensities, which end at " + base::significant(last, 6) +
               ": they are likely in m/s",
           "name the measure pgv_m_s");
  }
}

}  // namespace rocking

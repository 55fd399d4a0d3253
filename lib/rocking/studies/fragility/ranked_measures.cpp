#include "rocking/studies/fragility/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "rocking/stats/fit_suite.hpp"

namespace rocking {
namespace {

constexpr double parameters_of_a_law = 3.0;

void measure(const stats::SuiteLevels& suite, RankedMeasure& found) {
  const auto law = stats::fit_suite(suite).law;
  if (!law) return;
  found.median = law->median;
  found.dispersion = law->dispersion();
  found.between_records = law->between_records;
  found.within_record = law->within_record;
  found.deviance = -2.0 * law->log_likelihood;
  found.aic = *found.deviance + 2.0 * parameters_of_a_law;
}

}  // namespace

stats::SuiteLevels levels_of_records(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                     std::optional<IntensityMeasure> measure) {
  stats::SuiteLevels suite;
  std::map<std::string, std::size_t> places;
  for (const Stripe& stripe : stripes) {
    const auto [place, is_new] = places.try_emplace(stripe.record, suite.size());
    if (is_new) suite.emplace_back();
    const stats::IntensityLevel level = level_of(stripe, event);
    suite[place->second].push_back({.intensity = measure ? stripe.measure(*measure).value() : stripe.intensity,
                                    .happened = stats::proportion_at(level),
                                    .unresolved = level.unresolved});
  }
  return suite;
}

std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                           const base::ManyParts& how) {
  std::vector<RankedMeasure> ranked;
  for (const IntensityMeasure each : all_intensity_measures) {
    const bool has_measure = std::all_of(stripes.begin(), stripes.end(), [&](const Stripe& stripe) {
      return stripe.measure(each) && *stripe.measure(each) > 0.0;
    });
    if (has_measure) ranked.emplace_back().measure = each;
  }
  base::for_each_part(how, ranked.size(),
                      [&](std::size_t i) { measure(levels_of_records(stripes, event, ranked[i].measure), ranked[i]); });
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedMeasure& a, const RankedMeasure& b) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // Measures that are proportional to each other have equal laws up to rounding; they keep their order.
    const auto key = [](const RankedMeasure& found) {
      return std::tuple(found.dispersion ? std::round(1e6 * *found.dispersion) : infinity,
                        std::round(1e3 * found.deviance.value_or(0.0)));
    };
    return key(a) < key(b);
  });
  return ranked;
}

}  // namespace rocking

#include "rocking/studies/fragility/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "rocking/base/error.hpp"
#include "rocking/stats/fit_suite.hpp"

namespace rocking {
namespace {

constexpr double parameters_of_a_law = 3.0;

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::vector<std::string> names_of(const std::vector<Stripe>& stripes) {
  std::vector<std::string> names;
  for (const Stripe& stripe : stripes) {
    if (names.empty() || names.back() != stripe.record) names.push_back(stripe.record);
  }
  return names;
}

/// Dependence on the numbers that all records have; absent where one of them has none.
template <class Number>
std::optional<stats::SuiteCovariate> dependence(const stats::SuiteLevels& suite,
                                                const std::vector<RecordMetadata>& metadata, Number&& number_of) {
  std::vector<double> numbers;
  for (const RecordMetadata& record : metadata) {
    const std::optional<double> number = number_of(record);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.empty()) return std::nullopt;
  return stats::suite_covariate(suite, numbers);
}

void measure(const stats::SuiteLevels& suite, const std::vector<RecordMetadata>& metadata, RankedMeasure& found) {
  const auto law = stats::fit_suite(suite).law;
  if (!law) return;
  found.median = law->median;
  found.dispersion = law->dispersion();
  found.between_records = law->between_records;
  found.within_record = law->within_record;
  found.deviance = -2.0 * law->log_likelihood;
  found.aic = *found.deviance + 2.0 * parameters_of_a_law;
  found.by_magnitude = dependence(suite, metadata, [](const RecordMetadata& record) { return record.magnitude; });
  found.by_distance = dependence(suite, metadata, [](const RecordMetadata& record) {
    return record.distance_km ? std::optional(std::log(*record.distance_km)) : std::nullopt;
  });
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

/// The metadata of the records of a suite, in their order. Throws base::InputError where a record has none or several.
static std::vector<RecordMetadata> metadata_of(const std::vector<std::string>& records,
                                               const std::vector<RecordMetadata>& metadata) {
  std::vector<RecordMetadata> ordered;
  std::vector<base::Problem> problems;
  for (const std::string& name : records) {
    const auto fits =
        [&name](const RecordMetadata& record) {  // behind its file a record may name a component or a level
          const auto is_of = [&record](std::string_view own) {
            return own == record.file || own.starts_with(record.file + ", ");
          };
          return is_of(name) || is_of(last_part(name));
        };
    const auto count = std::ranges::count_if(metadata, fits);
    if (count == 1) {
      ordered.push_back(*std::ranges::find_if(metadata, fits));
    } else {
      problems.push_back({"metadata", name, count == 0 ? "has no line" : "has several lines",
                          "give one line for each record of the suite"});
    }
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return ordered;
}

std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes, const ResponseEvent& event,
                                           const std::vector<RecordMetadata>& metadata, const base::ManyParts& how) {
  std::vector<RankedMeasure> ranked;
  for (const IntensityMeasure each : all_intensity_measures) {
    const bool has_measure = std::all_of(stripes.begin(), stripes.end(), [&](const Stripe& stripe) {
      return stripe.measure(each) && *stripe.measure(each) > 0.0;
    });
    if (has_measure) ranked.emplace_back().measure = each;
  }
  const auto ordered = metadata.empty() ? metadata : metadata_of(names_of(stripes), metadata);
  base::for_each_part(how, ranked.size(), [&](std::size_t i) {
    measure(levels_of_records(stripes, event, ranked[i].measure), ordered, ranked[i]);
  });
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

#include "rocking/stats/suite_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/centred_suite.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

/// Order statistic number p (n + 1), counted from 1, between neighbours linearly.
double percentile(const std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  const double place = std::clamp(share * static_cast<double>(sorted.size() + 1) - 1.0, 0.0, last);
  const auto index = static_cast<std::size_t>(place);
  const std::size_t next = std::min(index + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(index);
  // Beside an infinite value the difference may be none.
  if (part == 0.0 || sorted[next] == sorted[index]) return sorted[index];
  return sorted[index] + part * (sorted[next] - sorted[index]);
}

bool are_enough(const std::vector<double>& values, std::uint64_t samples) {
  return samples > 0 && static_cast<double>(values.size()) >= least_share_with_law * static_cast<double>(samples);
}

/// For each record those with the same intensities, in the order of the suite.
std::vector<std::vector<std::size_t>> exchangeable_records(const SuiteLevels& suite) {
  const auto have_equal_levels = [](const std::vector<RecordLevel>& a, const std::vector<RecordLevel>& b) {
    return std::ranges::equal(a, b, {}, &RecordLevel::intensity, &RecordLevel::intensity);
  };
  std::vector<std::vector<std::size_t>> others(suite.size());
  for (std::size_t r = 0; r < suite.size(); ++r) {
    for (std::size_t k = 0; k < suite.size(); ++k) {
      if (have_equal_levels(suite[r], suite[k])) others[r].push_back(k);
    }
  }
  return others;
}

}  // namespace

RecordBootstrap bootstrap_records(const SuiteLevels& suite, std::uint64_t samples, const RecordDraws& draws,
                                  const base::ManyParts& how) {
  const CentredSuite data = centred(suite);
  const SuiteFit whole = fit_centred(data);
  const std::optional<MixedProbitStart> start = whole.law ? start_at(data, *whole.law) : std::nullopt;
  const std::size_t records = data.records.size();
  const std::vector<std::vector<std::size_t>> exchangeable = exchangeable_records(suite);
  std::vector<std::optional<SuiteLaw>> laws(samples);
  std::vector<std::vector<double>> weights(samples), with_unseen(samples);
  base::for_each_part(how, samples, [&](std::size_t sample) {
    CentredSuite drawn = data;
    for (RecordCounts& record : drawn.records) record.weight = 0.0;
    for (std::size_t number = 0; number < records; ++number) {
      const std::vector<std::size_t>& among = exchangeable[number];
      const double place = draws(sample, number) * static_cast<double>(among.size());
      drawn.records[among[std::min(among.size() - 1, static_cast<std::size_t>(place))]].weight += 1.0;
    }
    for (const RecordCounts& record : drawn.records) weights[sample].push_back(record.weight);
    with_unseen[sample] = shares_with_unseen(records, sample, draws);
    if (whole.law) laws[sample] = fit_centred(drawn, start ? &*start : nullptr).law;
  });
  RecordBootstrap found{.samples = samples,
                        .fewest = 0,
                        .laws = {},
                        .samples_with_law = {},
                        .weights = std::move(weights),
                        .with_unseen = std::move(with_unseen)};
  if (!exchangeable.empty()) found.fewest = std::ranges::min(exchangeable, {}, &std::vector<std::size_t>::size).size();
  for (std::size_t sample = 0; sample < samples; ++sample) {
    if (!laws[sample]) continue;
    found.laws.push_back(*laws[sample]);
    found.samples_with_law.push_back(sample);
  }
  return found;
}

// Exponential numbers over their sum.
std::vector<double> shares_with_unseen(std::size_t records, std::uint64_t sample, const RecordDraws& draws) {
  std::vector<double> shares;
  double sum = 0.0;
  for (std::size_t number = 0; number <= records; ++number) {
    shares.push_back(-std::log1p(-draws(sample, number)));
    sum += shares.back();
  }
  ROCKING_EXPECT(sum > 0.0);
  for (double& share : shares) share /= sum;
  return shares;
}

std::vector<double> mean_with_unseen(std::vector<double> mean, std::span<const double> shares_of_unseen,
                                     std::span<const double> unseen) {
  ROCKING_EXPECT(mean.size() == unseen.size() && mean.size() == shares_of_unseen.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = (1.0 - shares_of_unseen[k]) * mean[k] + shares_of_unseen[k] * unseen[k];
  }
  return mean;
}

std::optional<Interval> percentile_interval(std::vector<double> values, std::uint64_t samples, double confidence) {
  if (!are_enough(values, samples)) return std::nullopt;
  std::sort(values.begin(), values.end());
  return Interval{.low = percentile(values, 0.5 * (1.0 - confidence)),
                  .high = percentile(values, 0.5 * (1.0 + confidence))};
}

std::optional<Interval> bias_corrected_interval(std::vector<double> values, double estimate, std::uint64_t samples,
                                                double confidence) {
  if (!are_enough(values, samples)) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto [equal, above] = std::equal_range(values.begin(), values.end(), estimate);
  const auto count = static_cast<double>(values.size());
  const double below = (static_cast<double>(equal - values.begin()) + 0.5 * static_cast<double>(above - equal)) / count;
  const boost::math::normal_distribution<double> normal;
  const double bias = quantile(normal, std::clamp(below, 0.5 / count, 1.0 - 0.5 / count));
  // With two records the expanded percentiles are the ends themselves.
  const double tail = 0.5 * (1.0 - confidence);
  const double reach = tail > 0.0 ? quantile(complement(normal, tail)) : std::numeric_limits<double>::infinity();
  return Interval{.low = percentile(values, normal_cdf(2.0 * bias - reach)),
                  .high = percentile(values, normal_cdf(2.0 * bias + reach))};
}

double expanded_confidence(double confidence, std::size_t records) {
  if (records < 2) return confidence;
  const auto count = static_cast<double>(records);
  const double reach = std::sqrt(count / (count - 1.0)) * two_sided_t_quantile(confidence, count - 1.0);
  return 1.0 - 2.0 * normal_cdf(-reach);
}

}  // namespace rocking::stats

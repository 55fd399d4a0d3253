#include "rocking/studies/curves/suite_rates.hpp"

#include <utility>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "rocking/studies/curves/rare_tail.hpp"

namespace rocking {
namespace {

constexpr double rounding_of_rate = 1e-12;  ///< relative

stats::SuiteLevels levels_of(const std::vector<RecordCurve>& records) {
  stats::SuiteLevels suite;
  for (const RecordCurve& record : records) {
    auto& levels = suite.emplace_back();
    for (const FragilityLevel& level : record.curve.levels)
      levels.push_back({level.intensity, level.overturned, level.unresolved});
  }
  return suite;
}

CountedHazard counted_with_tail(const HazardCurve& hazard, const SuiteCurve& curve, const SuiteTail& tail) {
  CountedHazard counted = counted_hazard(hazard, curve.levels, curve.subject.least_uplift);
  if (tail.estimates.empty()) return counted;
  std::erase_if(counted.levels,
                [&tail](double level) { return tail.end ? level < *tail.end : level <= *tail.reach(); });
  std::vector<double> levels;
  for (const RareLevel& level : tail.estimates) levels.push_back(level.intensity);
  levels.insert(levels.end(), counted.levels.begin(), counted.levels.end());
  counted.levels = std::move(levels);
  return counted;
}

}  // namespace

std::optional<stats::Interval> between(const std::optional<stats::Interval>& lows,
                                       const std::optional<stats::Interval>& highs) {
  if (!lows || !highs) return std::nullopt;
  return stats::Interval{.low = lows->low, .high = highs->high};
}

CountedSuite::CountedSuite(const SuiteCurve& of, const HazardCurve& hazard)
    : curve(of), tail(of), counted(counted_with_tail(hazard, of, tail)), pieces(counted.pieces()) {}

WithTail<LognormalCapacity> LawRates::probability_of(const stats::SuiteLaw& law,
                                                     const std::vector<double>& weights) const {
  return {suite_.tail.y, suite_.tail.means(weights), {.centre = std::log(law.median), .dispersion = law.dispersion()}};
}

std::vector<double> LawRates::of_samples() const {
  const stats::RecordBootstrap& bootstrap = suite_.curve.bootstrap;
  std::vector<double> rates;
  for (std::size_t k = 0; k < bootstrap.laws.size(); ++k) {
    const std::vector<double>& weights = bootstrap.weights[bootstrap.samples_with_law[k]];
    rates.push_back(rate_of(probability_of(bootstrap.laws[k], weights), suite_.pieces));
  }
  return rates;
}

RateEstimate LawRates::estimate() const { return {RateSource::law, rate(), suite_.curve.interval_of(of_samples())}; }

ShareRates::ShareRates(const CountedSuite& suite)
    : suite_(suite),
      least_(levels_of(suite.curve.records)),
      most_(levels_of(suite.curve.records), stats::RecordShares::Unresolved::as_happened),
      rates_(suite.counted, least_.intensities().size(), suite.tail) {
  std::uint64_t trials = 0;
  for (const RecordCurve& record : suite.curve.records) trials += record.curve.levels.front().overturned.trials;
  half_trial_ = 0.5 / static_cast<double>(trials);
}

std::vector<double> ShareRates::isotonic(const stats::RecordShares& of, const std::vector<double>& weights) const {
  return rates_.counted_of(of.isotonic(weights), suite_.tail.means(weights));
}

std::vector<double> ShareRates::shares_of_record(const stats::RecordShares& of, std::size_t record) const {
  return rates_.counted_of(of.of_record(record), suite_.tail.of_records[record]);
}

AllowedRate ShareRates::allowed(const std::vector<double>& weights) const {
  AllowedRate found = rates_.allowed(isotonic(least_, weights), half_trial_);
  const AllowedRate most = rates_.allowed(isotonic(most_, weights), half_trial_);
  found.linear.high = most.linear.high;
  found.lognormal.high = most.lognormal.high;
  return found;
}

bool ShareRates::scatters() const {
  const std::vector<std::vector<double>>& samples = suite_.curve.bootstrap.weights;
  if (samples.empty()) return false;
  const double first = rate(least_, samples.front());
  return std::ranges::any_of(samples, [&](const std::vector<double>& weights) {
    return std::abs(rate(least_, weights) - first) > rounding_of_rate * first;
  });
}

RateEstimate ShareRates::estimate() const {
  std::vector<std::vector<double>> of_records;
  for (std::size_t r = 0; r < most_.records(); ++r) of_records.push_back(shares_of_record(most_, r));
  const std::vector<double> worst = rates_.worst_unseen(of_records);
  auto interval = interval_with_unseen(worst);
  // Records that are all alike say nothing of how much another one may differ.
  if (interval && interval->high - interval->low <= rounding_of_rate * interval->high) {
    interval = interval_with_unseen(std::vector<double>(worst.size(), 1.0));
  }
  return {RateSource::isotonic, rate(), interval};
}

/// From the least rate that the levels allow, with an unseen record that never overturns, to the largest one, with one
/// that does so as in `worst`. Trials without an answer have the event at the upper end.
std::optional<stats::Interval> ShareRates::interval_with_unseen(const std::vector<double>& worst) const {
  const stats::RecordBootstrap& bootstrap = suite_.curve.bootstrap;
  const std::vector<double> best(worst.size(), 0.0);
  std::vector<double> lows, highs;
  for (std::vector<double> weights : bootstrap.with_unseen) {
    const double unseen = weights.back();
    weights.pop_back();
    const std::vector<double> parts = shares_of_unseen(weights, unseen);
    lows.push_back(rates_.least_allowed(stats::mean_with_unseen(isotonic(least_, weights), parts, best)));
    highs.push_back(rates_.most_allowed(stats::mean_with_unseen(isotonic(most_, weights), parts, worst)));
  }
  const double confidence = suite_.curve.subject.confidence;
  return between(stats::percentile_interval(std::move(lows), bootstrap.samples, confidence),
                 stats::percentile_interval(std::move(highs), bootstrap.samples, confidence));
}

/// In the means at the points that count: of a level with records of its own, among these.
std::vector<double> ShareRates::shares_of_unseen(const std::vector<double>& weights, double unseen) const {
  std::vector<double> at_levels = least_.shares_of_another(weights, unseen);
  const std::size_t points = rates_.counted_of(at_levels, suite_.tail.means(weights)).size();
  at_levels.erase(at_levels.begin(), at_levels.end() - static_cast<std::ptrdiff_t>(std::min(points, at_levels.size())));
  at_levels.insert(at_levels.begin(), points - at_levels.size(), unseen);
  return at_levels;
}

/// A range of the tail is shared out by the mean of the shares that a record has in the probabilities at its two ends.
double ShareRates::of_record(std::size_t record) const {
  const SuiteTail& tail = suite_.tail;
  const std::vector<double> own = shares_of_record(least_, record);
  if (tail.estimates.empty()) return rates_.rate(own);
  const std::vector<double> equal = suite_.equal_weights();
  const std::vector<double> means = rates_.counted_of(least_.mean(equal), tail.means(equal));
  const auto of_all = rates_.probability(means);
  double rate = rate_of(rates_.probability(own), pieces_within(suite_.pieces, tail.y.back(), HUGE_VAL));
  for (std::size_t i = 0; i + 1 < tail.y.size(); ++i) {
    const double low = i == 0 ? -HUGE_VAL : tail.y[i];
    const double share = 0.5 * (own[i] / means[i] + own[i + 1] / means[i + 1]);
    rate += share * rate_of(of_all, pieces_within(suite_.pieces, low, tail.y[i + 1]));
  }
  return rate;
}

TailPiece tail_piece(double y_low, double p_low, double y_high, double p_high) {
  if (!(0.0 < p_low && p_low < p_high && p_high < 1.0)) {
    return KnownProbabilities{.y = {y_low, y_high}, .probabilities = {p_low, p_high}};
  }
  const boost::math::normal_distribution<double> normal;
  const double z_low = boost::math::quantile(normal, p_low);
  const double dispersion = (y_high - y_low) / (boost::math::quantile(normal, p_high) - z_low);
  return LognormalCapacity{.centre = y_low - z_low * dispersion, .dispersion = dispersion};
}

SuiteTail::SuiteTail(const SuiteCurve& curve) : UsedRare(used_rare(curve)) {
  for (const RecordCurve& record : curve.records) {
    std::vector<double>& probabilities = of_records.emplace_back(estimates.size(), 0.0);
    for (const RareLevel& level : record.curve.rare) {
      const auto node = std::ranges::find(estimates, level.intensity, &RareLevel::intensity);
      if (node != estimates.end()) {
        probabilities[static_cast<std::size_t>(node - estimates.begin())] = level.probability;
      }
    }
  }
}

std::vector<double> SuiteTail::means(const std::vector<double>& weights) const {
  std::vector<double> sums(estimates.size(), 0.0);
  if (sums.empty()) return sums;
  ROCKING_EXPECT(weights.size() == of_records.size());
  double total = 0.0;
  for (std::size_t r = 0; r < weights.size(); ++r) {
    total += weights[r];
    for (std::size_t node = 0; node < estimates.size(); ++node) sums[node] += weights[r] * of_records[r][node];
  }
  for (double& sum : sums) sum /= total;
  return sums;
}

}  // namespace rocking

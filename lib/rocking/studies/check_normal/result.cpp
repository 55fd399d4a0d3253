#include "rocking/studies/check_normal/study.hpp"

#include <array>
#include <utility>

#include "rocking/fields/container_types.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {
namespace stats {

// Static, not in an anonymous namespace: argument-dependent lookup does not look into that one.
static constexpr Rule probability = rule::share;

static const StructType& fields_of(const NormalLaw*) {
  static const StructType fields{
      "NormalLaw",
      field<&NormalLaw::mean>("mean", "mean of the distribution"),
      field<&NormalLaw::sigma>("sigma", "its standard deviation", rule::positive),
  };
  return fields;
}

static const StructType& fields_of(const MomentTest*) {
  static const StructType fields{
      "MomentTest",
      field<&MomentTest::moment, &Moment::value>("value", "of the sample"),
      field<&MomentTest::moment, &Moment::standard_error>(
          "standard_error", "standard deviation of the value under the distribution", rule::positive),
      field<&MomentTest::moment, &Moment::z>("z", "(value - its mean under the distribution)/standard_error"),
      field<&MomentTest::p_value>("p_value", "two-sided", probability),
  };
  return fields;
}

static const StructType& fields_of(const Nearness*) {
  static const StructType fields{
      "Nearness",
      field<&Nearness::distance>("distance", "from the value of the distribution", rule::not_negative),
      field<&Nearness::probability>("probability", "that a normal sample of this size is at most this far off",
                                    probability),
  };
  return fields;
}

static const StructType& fields_of(const ShapeTest*) {
  static const StructType fields{
      "ShapeTest",
      inlined<&ShapeTest::test>(),
      field<&ShapeTest::nearness>("nearness", "for a distance of 0.01 and for the distance found"),
      field<&ShapeTest::of_law>("of_law", "value of a distribution that is not normal", {}, WithoutValue::omitted),
  };
  return fields;
}

static const StructType& fields_of(const CorrelationTest*) {
  static constexpr std::array<std::string_view, 8> pairs{
      "members_of_a_pair",         "squares_in_a_pair",   "lag_1", "lag_2", "lag_3", "lag_200",
      "neighbouring_realisations", "neighbouring_sources"};
  static const StructType fields{
      "CorrelationTest",
      field<&CorrelationTest::between>("between", "which numbers; `lag_200` from 201 numbers on", {.choices = pairs}),
      inlined<&CorrelationTest::test>(),
  };
  return fields;
}

static const StructType& fields_of(const TestOfFit*) {
  static const StructType fields{
      "TestOfFit",
      field<&TestOfFit::statistic>("statistic", "of the test"),
      field<&TestOfFit::p_value>("p_value", "of the test", probability),
  };
  return fields;
}

static const StructType& fields_of(const TailCount*) {
  static const StructType fields{
      "TailCount",
      field<&TailCount::sigmas>("sigmas", "distance from the mean in standard deviations", rule::positive),
      field<&TailCount::beyond, &Proportion::successes>("count", "numbers beyond it"),
      field<&TailCount::expected>("expected", "number", rule::not_negative),
      field<&TailCount::p_value>("p_value", "exact, two-sided", probability),
  };
  return fields;
}

static const StructType& fields_of(const Histogram*) {
  static const StructType fields{
      "Histogram",
      field<&Histogram::edges>("edges", "of the bins, rising"),
      field<&Histogram::counts>("counts", "numbers in each bin"),
      field<&Histogram::expected>("expected", "in each bin", rule::not_negative),
      field<&Histogram::below>("below", "numbers below the first edge"),
      field<&Histogram::above>("above", "numbers from the last edge on"),
      field<&Histogram::expected_below>("expected_below", "number", rule::not_negative),
      field<&Histogram::expected_above>("expected_above", "number", rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const NormalCheck*) {
  static const StructType fields{
      "NormalCheck",
      field<&NormalCheck::law>("law", "the distribution that was asked for"),
      field<&NormalCheck::n>("n", "how many numbers", {.least = 4}),
      field<&NormalCheck::mean>("mean", "of the numbers"),
      field<&NormalCheck::standard_deviation>("standard_deviation", "with n - 1"),
      field<&NormalCheck::skewness>("skewness", "0 for a normal distribution"),
      field<&NormalCheck::kurtosis>("kurtosis", "3 for a normal distribution"),
      field<&NormalCheck::correlations>(
          "correlations",
          "mean products of the scores of numbers that should be independent; p-values of large samples"),
      field<&NormalCheck::dagostino_pearson>("dagostino_pearson", "test of skewness and kurtosis"),
      field<&NormalCheck::anderson_darling>("anderson_darling", "test of the whole distribution"),
      field<&NormalCheck::kolmogorov_smirnov>("kolmogorov_smirnov", "test of the whole distribution"),
      field<&NormalCheck::tails>("tails", "numbers beyond 3, 4 and 5 standard deviations"),
      field<&NormalCheck::histogram>("histogram", "counts and what the distribution lets expect"),
      derived<[](const NormalCheck& check) { return is_refuted(check); }>(
          "refuted", "whether a p-value is too small to be explained by chance (below 1e-6); then the exit code is 1"),
  };
  return fields;
}

}  // namespace stats

SamplerCheck sampler_check(const SamplerQuestion& question, const stats::NormalCheck& found) {
  std::optional<std::string> distribution;
  if (question.distribution != FluctuationLaw::normal) {
    distribution = fluctuation_law_names[static_cast<std::size_t>(question.distribution)];
  }
  SamplerCheck check{.distribution = std::move(distribution), .generated = {}, .of_file = {}, .found = found};
  if (question.file) {
    check.of_file = {.file = *question.file, .has_own_law = !question.mean};
  } else {
    check.generated = {.sampler = question.sampler, .seed = question.seed};
  }
  return check;
}

static const StructType& fields_of(const GeneratedNumbers*) {
  static constexpr std::array<std::string_view, 3> samplers{"box-muller", "ziggurat", "inverse-cdf"};
  static const StructType fields{
      "GeneratedNumbers",
      field<&GeneratedNumbers::sampler>("sampler", "that generated the numbers; absent: they are of a file",
                                        {.choices = samplers}),
      field<&GeneratedNumbers::seed>("seed", "of the random numbers, as text", seed_type()),
  };
  return fields;
}

static const StructType& fields_of(const NumbersOfFile*) {
  static const StructType fields{
      "NumbersOfFile",
      field<&NumbersOfFile::file>("file", "with the numbers; absent: they were generated"),
      field<&NumbersOfFile::has_own_law>(
          "own_law", "whether the distribution has the mean and the standard deviation of the numbers themselves"),
  };
  return fields;
}

const StructType& fields_of(const SamplerCheck*) {
  static constexpr std::array<std::string_view, 2> distributions{"lognormal", "uniform"};
  static const StructType fields{
      "SamplerCheck",
      field<&SamplerCheck::distribution>("distribution", "of the numbers, absent: normal", {.choices = distributions},
                                         WithoutValue::omitted),
      inlined<&SamplerCheck::generated>(),
      inlined<&SamplerCheck::of_file>(),
      inlined<&SamplerCheck::found>(),
  };
  return fields;
}

static void check_histogram(const SamplerCheck& check, const ReadingPlace& place) {
  const stats::Histogram& histogram = check.found.histogram;
  const ReadingPlace at = place.at("histogram");
  const std::size_t edges = histogram.edges.size();
  if (edges < 2) return at.at("edges").reject(histogram.edges, "must have at least two entries");
  if (histogram.counts.size() + 1 != edges) at.at("counts").reject({}, "must have one value between two edges");
  if (histogram.expected.size() + 1 != edges) at.at("expected").reject({}, "must have one value between two edges");
  for (std::size_t i = 1; i < edges; ++i) {
    if (histogram.edges[i] > histogram.edges[i - 1]) continue;
    return at.at("edges").at(std::to_string(i)).reject(histogram.edges[i], "must be greater than the edge before it");
  }
}

const DocumentOf<SamplerCheck>& check_normal_document() {
  static const DocumentOf<SamplerCheck> document(
      "rocking.check_normal/1", "Random numbers of a sampler, compared with a normal distribution.", check_histogram);
  return document;
}

}  // namespace rocking

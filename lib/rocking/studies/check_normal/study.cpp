#include "rocking/studies/check_normal/study.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <boost/math/distributions/normal.hpp>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/stats/law_check.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

stats::NormalLaw law_of(const SamplerQuestion& question) {
  return {question.mean.value_or(0.4), question.sigma.value_or(0.03)};
}

/// The normal number from which a number follows, by other formulas than those that gave it.
std::function<double(double)> score_under(const SamplerQuestion& question) {
  const auto [mean, sigma] = law_of(question);
  if (question.distribution == FluctuationLaw::uniform) {
    const double half_width = std::sqrt(3.0) * sigma;
    return [mean = mean, half_width](double x) {
      const double share = std::clamp(0.5 + 0.5 * (x - mean) / half_width, 0x1p-60, 1.0 - 0x1p-53);
      return -boost::math::quantile(boost::math::complement(boost::math::normal(), share));
    };
  }
  const double variance = std::log1p(sigma * sigma / (mean * mean));
  return [centre = std::log(mean) - 0.5 * variance, deviation = std::sqrt(variance)](double x) {
    return x > 0.0 ? (std::log(x) - centre) / deviation : -40.0;
  };
}

/// The numbers that a simulation would draw, scaled to the law, and their neighbours. Absent if sigma is too small to give
/// two different numbers. Precondition: a sampler of this name, n >= 20, and a positive mean of a lognormal distribution.
std::optional<stats::NormalCheck> check_sampler(const SamplerQuestion& question) {
  const random::SamplerKind kind = random::sampler_from_string(question.sampler).value();
  const auto [mean, sigma] = law_of(question);
  const RedrawnQuantity law = law_along_the_way(question.distribution, mean, sigma);
  const auto drawn = [&](std::uint64_t realisation, random::Source source) {
    auto numbers = random::standard_sample(kind, {question.seed, realisation}, source, question.n);
    for (double& number : numbers) number = value_at_normal(law, number);
    return numbers;
  };
  const auto sample = drawn(0, random::Source::check_normal);
  const auto of_next_realisation = drawn(1, random::Source::check_normal);
  const auto of_next_source = drawn(0, random::Source::slip_rate);
  const stats::NormalSamples samples{sample, of_next_realisation, of_next_source};
  if (question.distribution == FluctuationLaw::normal) return stats::check_normal(samples, law_of(question));
  return stats::check_law(samples, {.mean = mean,
                                    .sigma = sigma,
                                    .at = [&law](double z) { return value_at_normal(law, z); },
                                    .score = score_under(question)});
}

/// Those of a file.
stats::NormalCheck check_file(const SamplerQuestion& question) {
  if (question.mean.has_value() != question.sigma.has_value()) {
    refuse(question.mean ? "sigma" : "mean", "", "is missing: a file is compared with both, or with its own ones");
  }
  const std::vector<double> numbers = read_numbers(read_file(*question.file), *question.file, question.column);
  const auto found =
      question.mean ? stats::check_normal({numbers, {}, {}}, law_of(question)) : stats::check_own_law(numbers);
  if (!found) {
    throw base::InputError(
        {*question.file, "", "has numbers that are all equal, or too nearly so", "give numbers that scatter"});
  }
  return *found;
}

}  // namespace

stats::NormalCheck check_normal(const SamplerQuestion& question) {
  check_fields(question);
  if (question.file) return check_file(question);
  const auto [mean, sigma] = law_of(question);
  if (question.distribution == FluctuationLaw::lognormal && !(mean >= 1e-12 && sigma <= 100.0 * mean)) {
    refuse("mean", base::shortest(mean),
           "must be at least 1e-12 for a lognormal law, and at least a hundredth of sigma");
  }
  auto found = check_sampler(question);
  if (!found) {
    refuse("sigma", base::shortest(sigma), "is too small compared with the mean to give two different numbers");
  }
  return std::move(*found);
}

const StructType& fields_of(const SamplerQuestion*) {
  using Type = SamplerQuestion;
  static const StructType fields{
      "SamplerQuestion",
      asked(field<&Type::n>("n", "How many numbers", Rule{.least = 20.0, .most = 1e8}),
            {.names = "--n", .letter = "N", .excludes = "FILE"}),
      asked(field<&Type::mean>("mean", "Mean of the distribution; without it 0.4, or that of the numbers in FILE",
                               Rule{.least = -1e6, .most = 1e6}),
            {.names = "--mean", .letter = "M"}),
      // The fourth power of a smaller sigma is no normal double.
      asked(field<&Type::sigma>("sigma", "Its standard deviation; without it 0.03, or likewise",
                                Rule{.least = 1e-70, .most = 1e6}),
            {.names = "--sigma", .letter = "S"}),
      asked(field<&Type::distribution>("law", "Distribution of the numbers",
                                       the_only<NamedType<FluctuationLaw, fluctuation_law_names>>()),
            {.names = "--law", .letter = "NAME", .excludes = "FILE"}),
      asked(field<&Type::seed>("seed", "Seed, for example 0x2012 or 8210", seed_type()),
            {.names = "--seed", .letter = "S", .excludes = "FILE"}),
      asked(field<&Type::sampler>("sampler", "Method for normal numbers; simulations use box-muller",
                                  Rule{.choices = random::sampler_names}),
            {.names = "--sampler", .letter = "NAME", .excludes = "FILE"}),
      asked(field<&Type::file>("file",
                               "Numbers of your own, at least 20: one a line, or a column of CSV; without it numbers "
                               "are drawn as a simulation does"),
            {.names = "FILE", .letter = "FILE"}),
      asked(field<&Type::column>("column", "Of FILE, as its first line names it; needed where it has several"),
            {.names = "--column", .letter = "NAME", .needs = "FILE"}),
  };
  return fields;
}

namespace {

void check(const Subject&, SamplerQuestion&) {}

Answer find(const Subject&, const SamplerQuestion& question, const Circumstances&) {
  const SamplerCheck found = sampler_check(question, check_normal(question));
  Answer answer{.document = check_normal_document().text(found), .table = check_normal_summary(found)};
  if (stats::is_refuted(found.found)) {
    answer.notices = {"these numbers do not follow the distribution: a p-value is below 1e-6"};
    answer.end = AnswerEnd::refuted;
  }
  return answer;
}

std::vector<analysis::Figure> figures(const Json& document, std::span<const Json>) {
  return {analysis::normal_histogram(check_normal_document().read(document))};
}

constexpr StudyFunctions<SamplerQuestion> functions{.check = check, .find = find, .figures = figures};

}  // namespace

const Study& check_normal_study() {
  static const Study study = study_of<SamplerQuestion, functions>({
      .name = "check_normal",
      .sentence = "Test random numbers, or those of a file: moments, tests of fit, histogram",
      .example = "--n 20000 --mean 0.4 --sigma 0.03",
      .text = "generates 20000 friction coefficients as a simulation does and compares them with the normal "
              "distribution, or with that of --law.",
      .python_notes = "Raises InputError for a number out of range or an unknown name.",
      .python_example = R"(>>> import rocking
>>> found = rocking.check_normal(1000)
>>> abs(found.mean.value - 0.4) < 0.01
True)",
      .subject = SubjectKind::none,
      .document = check_normal_document(),
  });
  return study;
}

}  // namespace rocking

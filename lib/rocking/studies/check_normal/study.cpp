#include "rocking/studies/check_normal/study.hpp"

#include <array>
#include <string_view>

#include "rocking/fields/named_type.hpp"
#include "rocking/output/provenance_fields.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/studies/check_normal/figure.hpp"
#include "rocking/studies/check_normal/result.hpp"
#include "rocking/studies/check_normal/table.hpp"

namespace rocking {

const StructType& fields_of(const SamplerQuestion*) {
  using Type = SamplerQuestion;
  static const StructType fields{
      "SamplerQuestion",
      asked(field<&Type::n>("n", "How many numbers", Rule{.least = 20.0, .most = 1e8}),
            {.names = "--n", .letter = "N"}),
      asked(field<&Type::law, &stats::NormalLaw::mean>("mean", "Mean of the distribution",
                                                       Rule{.least = -1e6, .most = 1e6}),
            {.names = "--mean", .letter = "M"}),
      // The fourth power of a smaller sigma is no normal double.
      asked(field<&Type::law, &stats::NormalLaw::sigma>("sigma", "Standard deviation of the distribution",
                                                        Rule{.least = 1e-70, .most = 1e6}),
            {.names = "--sigma", .letter = "S"}),
      asked(field<&Type::distribution>("law", "Distribution of the numbers",
                                       the_only<NamedType<FluctuationLaw, fluctuation_law_names>>()),
            {.names = "--law", .letter = "NAME"}),
      asked(field<&Type::seed>("seed", "Seed, for example 0x2012 or 8210", seed_type()),
            {.names = "--seed", .letter = "S"}),
      asked(field<&Type::sampler>("sampler", "Method for normal numbers; simulations use box-muller",
                                  Rule{.choices = random::sampler_names}),
            {.names = "--sampler", .letter = "NAME"}),
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
      .sentence = "Test the random numbers: moments, tests of fit, histogram",
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

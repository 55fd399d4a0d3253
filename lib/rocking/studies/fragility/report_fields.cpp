#include <algorithm>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/fragility/study.hpp"

namespace rocking {

const StructType& fields_of(const ReportedSuite*) {
  static const StructType fields{
      "SuiteFragility",
      inlined<&ReportedSuite::run>(),
      inlined<&ReportedSuite::curve>(),
      field<&ReportedSuite::rate>("annual_rate", "with `--hazard`", {}, WithoutValue::omitted),
  };
  return fields;
}

static const StructType& fields_of(const ReportedComparison*) {
  static const StructType fields{
      "ReportedComparison",
      inlined<&ReportedComparison::run>(),
      inlined<&ReportedComparison::comparison>(),
  };
  return fields;
}

static const StructType& fields_of(const ReportedCurve*) {
  using Reported = ReportedCurve;
  static const StructType fields{
      "FragilityCurve",
      inlined<&Reported::run>(),
      inlined<&Reported::curve, &FragilityCurve::subject>(),
      inlined<&Reported::curve>(),
      field<&Reported::rate>("annual_rate", "with `--hazard`", {}, WithoutValue::omitted),
  };
  return fields;
}

namespace {

/// The curve of one motion or of a suite, which has the key `pooled`.
class CurveType final : public ValueType {
 public:
  using Either = std::variant<ReportedCurve, ReportedSuite>;

  [[nodiscard]] Json json(const void* value) const override {
    return std::visit([]<class Curve>(const Curve& curve) { return type_of<Curve>().json(&curve); }, either(value));
  }
  void write_element(const void* value, JsonWriter& out) const override {
    std::visit([&out]<class Curve>(const Curve& curve) { type_of<Curve>().write_element(&curve, out); }, either(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& read = *static_cast<Either*>(value);
    if (json.is_object() && json.contains("pooled"))
      return type_of<ReportedSuite>().read(json, place, &read.emplace<1>());
    type_of<ReportedCurve>().read(json, place, &read.emplace<0>());
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    return {{"anyOf", {type_of<ReportedCurve>().schema(rule), type_of<ReportedSuite>().schema(rule)}}};
  }
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
    type_of<ReportedCurve>().describe(prefix, rows);
    std::vector<KeyRow> of_suite;
    type_of<ReportedSuite>().describe(prefix, of_suite);
    for (const KeyRow& row : of_suite) {
      const auto has_key = [&row](const KeyRow& known) { return known.key == row.key; };
      if (std::ranges::none_of(rows, has_key)) rows.push_back(row);
    }
  }

 private:
  static const Either& either(const void* value) { return *static_cast<const Either*>(value); }
};

}  // namespace

template <>
struct TypeOf<std::variant<ReportedCurve, ReportedSuite>> : OnlyType<CurveType> {};

const StructType& fields_of(const FragilityReport*) {
  static const StructType fields{
      "Fragility",
      field<&FragilityReport::survival>("survival", "with `--survived`: whether the blocks still stand", {},
                                        WithoutValue::omitted),
      field<&FragilityReport::curves>("curves", "of one motion, or of a suite, which has `pooled`"),
      field<&FragilityReport::comparisons>("comparisons",
                                           "with `--hazard`: suites with other values of the rest of the sweep", {},
                                           WithoutValue::omitted),
      field<&FragilityReport::surfaces>("surfaces", "with `--surface`: of suites, over two measures of intensity", {},
                                        WithoutValue::omitted),
      field<&FragilityReport::incremental>("incremental", "incremental dynamic analyses, with `--ida`", {},
                                           WithoutValue::omitted),
  };
  return fields;
}

namespace {

/// Levels rise, and count no more events than realisations.
void check_report(const FragilityReport& report, const ReadingPlace& place) {
  for (std::size_t i = 0; i < report.curves.size(); ++i) {
    std::visit(
        [&](const auto& reported) {
          const auto& levels = reported.curve.levels;
          for (std::size_t j = 0; j < levels.size(); ++j) {
            const ReadingPlace own = place.at("curves").at(std::to_string(i)).at("levels").at(std::to_string(j));
            const auto& [successes, trials] = levels[j].overturned;
            if (successes > trials) {
              own.at("overturned").reject(Json(successes), "is greater than the number of realisations");
            } else if (levels[j].unresolved > trials - successes) {
              own.at("unresolved")
                  .reject(Json(levels[j].unresolved), "is greater than the number of those without the event");
            }
            if (j == 0 || levels[j].intensity > levels[j - 1].intensity) continue;
            own.at("intensity").reject(Json(levels[j].intensity), "is not greater than that of the previous level");
          }
        },
        report.curves[i]);
  }
}

}  // namespace

const DocumentOf<FragilityReport>& fragility_document() {
  static const DocumentOf<FragilityReport> document("rocking.fragility/1",
                                                    "Overturning against the intensity of the shaking.", check_report);
  return document;
}

FragilityReport fragility_report(const std::vector<RunFragility>& runs) {
  FragilityReport report;
  for (const RunFragility& found : runs) {
    const std::string& title = found.experiment.title;
    const auto has_title = [&title](const RunFragility& each) { return each.experiment.title == title; };
    const bool is_unique = found.name.empty() || std::ranges::count_if(runs, has_title) == 1;
    const CurveRun run{.title = is_unique ? title : found.name,
                       .experiment = base::sha256(found.experiment.canonical_text),
                       .left_out = found.experiment.left_out};
    for (const auto& [curve, rate] : found.curves) report.curves.emplace_back(ReportedCurve{run, curve, rate});
    for (const ShownSuite& suite : found.suites) {
      report.curves.emplace_back(ReportedSuite{run, suite.curve, suite.rate});
      if (suite.surface) report.surfaces.push_back({run, *suite.surface});
    }
    for (const RateComparison& comparison : found.comparisons) report.comparisons.push_back({run, comparison});
    if (found.survival) report.survival = found.survival;
    for (const IncrementalAnalysis& analysis : found.incremental) report.incremental.push_back({run, analysis});
  }
  return report;
}

static const StructType& fields_of(const SurvivingBlock*) {
  using Block = SurvivingBlock;
  static const StructType fields{
      "SurvivingBlock",
      field<&Block::name>("name", "values of the rest of the sweep, title or folder of the run"),
      field<&Block::rate>("rate", "mean annual rate of the event [1/year]", rule::not_negative),
      field<&Block::rate_interval>("rate_interval", "of it; null: unknown", rule::not_negative),
      field<&Block::probability>("probability", "that the event has not happened: exp(-rate years)", rule::share),
      field<&Block::interval>("interval", "of it; null: that of the rate is", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const SurvivalBranch*) {
  using Branch = SurvivalBranch;
  static const StructType fields{
      "SurvivalBranch",
      field<&Branch::hazard>("hazard", "file of the hazard curve"),
      field<&Branch::all>(
          "all",
          "that no block has had the event, `rate` that any has it; `probability` is the likelihood of the branch"),
      field<&Branch::independent>("independent", "product of the probabilities of the blocks, without what they share",
                                  rule::share),
      field<&Branch::weight>("weight", "likelihood over the sum over the branches; 0: all are 0", rule::share),
      field<&Branch::blocks>("blocks", "each by itself"),
  };
  return fields;
}

const StructType& fields_of(const Survival*) {
  static const StructType fields{
      "Survival",
      field<&Survival::event>("event", "as of a curve"),
      field<&Survival::years>("years", "that have passed", Rule{.above = 0.0}),
      field<&Survival::source>("from",
                               "`law`, if it holds for every block and for all together; else `levels` or `isotonic`"),
      field<&Survival::branches>("branches", "one for each hazard curve"),
  };
  return fields;
}

}  // namespace rocking

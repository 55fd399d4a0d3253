#include "rocking/studies/curves/look.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {
namespace {

using OpenEnds = std::array<std::optional<double>, 2>;

OpenEnds written_ends(const stats::Interval& interval) {
  return {interval.low, std::isfinite(interval.high) ? std::optional(interval.high) : std::nullopt};
}

void set_ends(const OpenEnds& ends, const ReadingPlace& place, stats::Interval& interval) {
  if (!ends[0]) return place.at("0").reject(Json(), "must be a number");
  interval = {.low = *ends[0], .high = ends[1].value_or(std::numeric_limits<double>::infinity())};
}

/// Keys of the threshold, by EventName.
constexpr std::array<std::string_view, 4> threshold_keys{"", "peak_tilt", "slip_m", "displacement_m"};
constexpr std::array<std::string_view, 4> threshold_titles{"", "PeakTiltExceeded", "SlipExceeded",
                                                           "DisplacementExceeded"};

/// `"overturned"`, or `{"peak_tilt": 0.5}`, `{"slip_m": 0.05}`, `{"displacement_m": 0.05}`.
class EventType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& event = *static_cast<const ResponseEvent*>(value);
    if (event.is_overturning()) return "overturned";
    return {{std::string(threshold_keys[static_cast<std::size_t>(event.name)]), event.threshold}};
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& event = *static_cast<ResponseEvent*>(value);
    event = {};
    if (json == "overturned") return;
    for (std::size_t name = 1; name < threshold_keys.size() && json.is_object() && json.size() == 1; ++name) {
      const auto number = json.find(threshold_keys[name]);
      if (number == json.end() || !number->is_number() || !(number->get<double>() >= 0.0)) continue;
      event = {static_cast<EventName>(name), number->get<double>()};
      return;
    }
    place.reject(json, R"(must be "overturned", or an object with a number as peak_tilt, slip_m or displacement_m)");
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    Json all = {{{"const", "overturned"}}};
    for (std::size_t name = 1; name < threshold_keys.size(); ++name) {
      const std::string key(threshold_keys[name]);
      all.push_back({{"title", threshold_titles[name]},
                     {"type", "object"},
                     {"properties", {{key, {{"type", "number"}, {"minimum", 0}}}}},
                     {"required", {key}},
                     {"additionalProperties", false}});
    }
    return {{"anyOf", all}};
  }
};

std::optional<OpenEnds> written_optional_ends(const std::optional<stats::Interval>& interval) {
  return interval ? std::optional(written_ends(*interval)) : std::nullopt;
}

void set_optional_ends(const std::optional<OpenEnds>& ends, const ReadingPlace& place,
                       std::optional<stats::Interval>& interval) {
  interval.reset();
  if (ends) set_ends(*ends, place, interval.emplace());
}

}  // namespace

const ValueType& optional_open_interval_type() {
  return the_only<ConvertedType<std::optional<stats::Interval>, std::optional<OpenEnds>, written_optional_ends,
                                set_optional_ends>>();
}

const ValueType& open_interval_type() {
  return the_only<ConvertedType<stats::Interval, OpenEnds, written_ends, set_ends>>();
}

const ValueType& TypeOf<ResponseEvent>::get() { return the_only<EventType>(); }

const StructType& fields_of(const CurveRun*) {
  static const StructType fields{
      "CurveRun",
      field<&CurveRun::title>("title", "of the run's experiment; where several runs share it the name of the run"),
      field<&CurveRun::experiment>("sha256", "of the experiment's canonical text, as `input.sha256` of its report"),
      field<&CurveRun::left_out>("left_out", "records of its suite that could not be read, if there are any", {},
                                 WithoutValue::omitted),
  };
  return fields;
}

const StructType& fields_of(const CurveSubject*) {
  static const StructType fields{
      "CurveSubject",
      field<&CurveSubject::parameter>("parameter", "JSON pointer to the intensity",
                                      Rule{.choices = all_intensity_pointers}),
      field<&CurveSubject::others>("others", "values of the other entries of the sweep"),
      field<&CurveSubject::confidence>("confidence", "of the intervals", rule::confidence),
      field<&CurveSubject::event>("event",
                                  "what `overturned` counts: `\"overturned\"`; `{\"peak_tilt\": A}`: the peak of "
                                  "abs(theta)/psi exceeds A; `{\"slip_m\": A}`: the largest slip does; "
                                  "`{\"displacement_m\": A}`: the slip at the end does; or the block overturns"),
      field<&CurveSubject::least_uplift>("least_uplift",
                                         "least intensity at which the motion, or any record of a suite, lifts the "
                                         "block, or of an event of slip also makes it slide; null: not known",
                                         rule::not_negative),
  };
  return fields;
}

template <>
struct TypeOf<stats::Bounded> {
  static const ValueType& get() {
    static const StructType fields{
        "BoundedEstimate",
        field<&stats::Bounded::value>("value", "estimate", rule::not_negative),
        field<&stats::Bounded::interval>("interval", "of it; null: without an upper bound", open_interval_type(),
                                         rule::not_negative),
    };
    return fields;
  }
};

namespace {

using Covariance = std::array<double, 3>;

Covariance covariance_of(const stats::LognormalFragility& law) {
  return {law.covariance.aa, law.covariance.ab, law.covariance.bb};
}

void set_covariance(const Covariance& read, const ReadingPlace&, stats::LognormalFragility& law) {
  law.covariance = {.aa = read[0], .ab = read[1], .bb = read[2]};
}

using CovarianceType = ConvertedType<stats::LognormalFragility, Covariance, covariance_of, set_covariance>;

}  // namespace

template <>
struct TypeOf<stats::LognormalFragility> {
  static const ValueType& get() {
    using Law = stats::LognormalFragility;
    static const StructType fields{
        "LognormalLaw",
        field<&Law::centre>("centre", "P = Phi(intercept + slope (ln x - centre))"),
        field<&Law::intercept>("intercept", "of the line"),
        field<&Law::slope>("slope", "of the line", Rule{.above = 0.0}),
        of_owner<Law>("covariance", "of intercept and slope: variance, covariance, variance",
                      the_only<CovarianceType>()),
        field<&Law::degrees_of_freedom>(
            "degrees_of_freedom", "of Student's distribution, whose quantiles the intervals use", Rule{.least = 1.0}),
    };
    return fields;
  }
};

namespace {

const StructType& median_fields() {
  static const StructType fields{
      "Median",
      inlined<&FittedLaw::median>(),
      field<&FittedLaw::is_extrapolated>("extrapolated", "whether it lies outside the levels"),
  };
  return fields;
}

}  // namespace

static const StructType& fields_of(const FittedLaw*) {
  static const StructType fields{
      "FittedLaw",
      of_owner<FittedLaw>("median", "of the function", median_fields()),
      field<&FittedLaw::dispersion>("dispersion", "standard deviation of the logarithm of the capacity"),
      inlined<&FittedLaw::function>(),
  };
  return fields;
}

const ValueType& TypeOf<stats::LackOfFit>::get() {
  using Test = stats::LackOfFit;
  static const StructType fields{
      "LackOfFit",
      field<&Test::deviance>("deviance", "of the function from a probability of its own at each level",
                             rule::not_negative),
      field<&Test::samples>("samples", "bootstrap samples", Rule{.least = 1.0}),
      field<&Test::as_large>("as_large", "those whose deviance is at least as large"),
      field<&Test::p_value>("p_value", "(as_large + 1)/(samples + 1)", Rule{.above = 0.0, .most = 1.0}),
  };
  return fields;
}

static const StructType& fields_of(const FragilityLevel*) {
  using Level = FragilityLevel;
  static const StructType fields{
      "FragilityLevel",
      field<&Level::intensity>("intensity", "of the excitation; 0 is left out", Rule{.above = 0.0}),
      field<&Level::shaking>(
          "shaking",
          "amplitude and frequency of the base in every unit, for the mean block; absent under a ground motion", {},
          WithoutValue::omitted),
      field<&Level::overturned, &stats::Proportion::trials>("realisations", "of the condition", Rule{.least = 1.0}),
      field<&Level::overturned, &stats::Proportion::successes>("overturned", "those with the event"),
      count_if_any<&Level::unresolved>("unresolved", unresolved_sentence),
      field<&Level::estimate>("estimate", "share of them", rule::share),
      field<&Level::exact>("exact", "its interval at this level alone", rule::share),
      field<&Level::simultaneous>("simultaneous", "its interval at all levels at once", rule::share),
      field<&Level::fitted>("fitted", "by the function; null: no law", rule::share),
      field<&Level::band>("band", "of `fitted` at this level alone, or of `isotonic` at all levels at once",
                          rule::share),
      field<&Level::isotonic>("isotonic",
                              "most likely probability that does not decrease; null unless the outcome is `rejected`",
                              rule::share),
  };
  return fields;
}

const StructType& fields_of(const RareLevel*) {
  static const StructType fields{
      "RareLevel",
      field<&RareLevel::intensity>("intensity", "of the excitation", Rule{.above = 0.0}),
      field<&RareLevel::probability>("probability", "of the event", rule::share),
      field<&RareLevel::interval>("interval", "of it", rule::share),
      field<&RareLevel::relative_error>("relative_error", "standard error over the probability", rule::not_negative),
      field<&RareLevel::degrees_of_freedom>("degrees_of_freedom", "of the error", rule::not_negative),
  };
  return fields;
}

const StructType& fields_of(const FragilityCurve*) {
  using Curve = FragilityCurve;
  static const StructType fields{
      "FittedCurve",
      field<&Curve::outcome>("outcome", "whether a function could be fitted, and why not"),
      field<&Curve::law>("law", "lognormal function of maximum likelihood; null: none, or it was rejected"),
      field<&Curve::test>("test", "of the fitted function; null: none could be fitted"),
      derived<[](const Curve& curve) {
        return curve.law ? std::optional<std::uint64_t>(curve.missed_levels()) : std::nullopt;
      }>("missed_levels", "at which the function lies outside the simultaneous interval; null: no function"),
      field<&Curve::levels>("levels", "by increasing intensity"),
      field<&Curve::rare>(
          "rare", "with `--rare`: small probabilities, by increasing intensity; of a suite the means over its records",
          {}, WithoutValue::omitted),
  };
  return fields;
}

}  // namespace rocking

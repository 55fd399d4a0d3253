#include "rocking/output/stats_fields.hpp"

#include <array>
#include <cstdint>
#include <optional>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"

namespace rocking {

/// A list of stats::Incidence as it is written.
struct WrittenCurve {
  std::vector<std::int64_t> periods;
  std::vector<double> estimate;
  std::vector<double> variance;
  std::vector<stats::Interval> pointwise;
  std::vector<stats::Interval> simultaneous;
};

namespace {

class IntervalType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& interval = *static_cast<const stats::Interval*>(value);
    return Json::array({interval.low, interval.high});
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::array<double, 2> ends{};
    const std::size_t before = place.problems->size();
    type_of<std::array<double, 2>>().read(json, place, &ends);
    if (place.problems->size() == before && ends[0] > ends[1]) place.reject(json, "must not have its upper end first");
    *static_cast<stats::Interval*>(value) = {.low = ends[0], .high = ends[1]};
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<std::array<double, 2>>().schema(rule); }
};

using WrittenQuantile = std::array<std::optional<double>, 4>;

WrittenQuantile written(const stats::QuantileEstimate& quantile) {
  return {quantile.level, quantile.value, quantile.low, quantile.high};
}

void convert(const WrittenQuantile& read, const ReadingPlace& place, stats::QuantileEstimate& quantile) {
  const auto& [level, value, low, high] = read;
  const bool has_level = level && *level > 0.0 && *level < 1.0;
  if (!has_level) place.at("0").reject(Json(), "must be a level between 0 and 1");
  if ((low && value && *low > *value) || (high && value && *value > *high) || (low && high && *low > *high)) {
    place.reject(Json(), "has a value that lies outside its interval");
  }
  quantile = {.level = level.value_or(0.0), .value = value, .low = low, .high = high};
}

WrittenCurve written(const std::vector<stats::Incidence>& points) {
  WrittenCurve curve;
  for (const stats::Incidence& point : points) {
    curve.periods.push_back(point.time);
    curve.estimate.push_back(point.estimate);
    curve.variance.push_back(point.variance);
    curve.pointwise.push_back(point.pointwise);
    curve.simultaneous.push_back(point.simultaneous);
  }
  return curve;
}

void convert(const WrittenCurve& curve, const ReadingPlace& place, std::vector<stats::Incidence>& points) {
  points.clear();
  const std::size_t size = curve.periods.size();
  if (curve.estimate.size() != size || curve.variance.size() != size || curve.pointwise.size() != size ||
      curve.simultaneous.size() != size) {
    return place.reject(Json(), "has lists of different lengths");
  }
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back({.time = curve.periods[i],
                      .estimate = curve.estimate[i],
                      .variance = curve.variance[i],
                      .pointwise = curve.pointwise[i],
                      .simultaneous = curve.simultaneous[i]});
  }
}

}  // namespace

static const StructType& fields_of(const WrittenCurve*) {
  static const StructType fields{
      "CurveOfTime",
      field<&WrittenCurve::periods>("periods", "where the estimate changes; at most 200", rule::not_negative),
      field<&WrittenCurve::estimate>("estimate", "of the probability by then", rule::share),
      field<&WrittenCurve::variance>("variance", "of the estimate", rule::not_negative),
      field<&WrittenCurve::pointwise>("pointwise", "its interval at this period alone", rule::share),
      field<&WrittenCurve::simultaneous>("simultaneous", "intervals that hold at all periods at once", rule::share),
  };
  return fields;
}

const ValueType& TypeOf<stats::QuantileEstimate>::get() {
  return the_only<ConvertedType<stats::QuantileEstimate, WrittenQuantile, written, convert>>();
}

const ValueType& TypeOf<std::vector<stats::Incidence>>::get() {
  return the_only<ConvertedType<std::vector<stats::Incidence>, WrittenCurve, written, convert>>();
}

const ValueType& TypeOf<stats::Interval>::get() { return the_only<IntervalType>(); }

}  // namespace rocking

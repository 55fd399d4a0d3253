#include "rocking/output/stats_fields.hpp"

#include <array>

#include "rocking/fields/container_types.hpp"

namespace rocking {
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

}  // namespace

const ValueType& TypeOf<stats::Interval>::get() { return the_only<IntervalType>(); }

}  // namespace rocking

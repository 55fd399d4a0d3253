#include "rocking/output/ensemble_fields.hpp"

#include <array>
#include <string>

#include "rocking/output/validity_fields.hpp"

namespace rocking {
namespace {

using Events = std::array<std::uint64_t, dynamics::event_kind_count>;

std::string name_of_event(std::size_t kind) { return std::string(to_string(static_cast<dynamics::EventKind>(kind))); }

/// Events by kind.
class EventsType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json json = Json::object();
    const auto& events = *static_cast<const Events*>(value);
    for (std::size_t kind = 0; kind < events.size(); ++kind) json[name_of_event(kind)] = events[kind];
    return json;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    if (!json.is_object()) return place.reject(json, "must be an object");
    auto& events = *static_cast<Events*>(value);
    for (std::size_t kind = 0; kind < events.size(); ++kind) {
      const std::string name = name_of_event(kind);
      if (!json.contains(name)) {
        place.at(name).reject(Json(), "is missing");
      } else {
        type_of<std::uint64_t>().read(json.at(name), place.at(name), &events[kind]);
      }
    }
    if (json.size() > events.size()) place.reject(json, "has an unknown kind of event");
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = {{"title", "EventCounts"}, {"type", "object"}, {"additionalProperties", false}};
    for (std::size_t kind = 0; kind < Events{}.size(); ++kind) {
      schema["properties"][name_of_event(kind)] = type_of<std::uint64_t>().schema(rule);
      schema["required"].push_back(name_of_event(kind));
    }
    return schema;
  }
};

}  // namespace

static const StructType& fields_of(const OperationCounts*) {
  using Counts = OperationCounts;
  static const StructType draws{
      "Draws",
      field<&Counts::static_friction_draws>("static_friction", "of the static friction"),
      field<&Counts::kinetic_friction_draws>("kinetic_friction", "of the kinetic friction"),
      field<&Counts::restitution_draws>("restitution", "of the restitution"),
      field<&Counts::amplitude_draws>("amplitude", "of the amplitude"),
      field<&Counts::initial_draws>("initial", "of block, phase and initial state"),
  };
  static const StructType fields{
      "OperationCounts",
      field<&Counts::steps>("steps", "Taylor steps"),
      field<&Counts::slip_steps>("slip_steps", "of these, steps of the equations with slip"),
      field<&Counts::root_isolations>("root_isolations",
                                      "searches for a zero crossing that the inexpensive bound did not exclude"),
      field<&Counts::ground_motion_segments>("ground_motion_segments",
                                             "segments of a ground motion that were looked up"),
      field<&Counts::exponent_periods>("exponent_periods", "periods with tangent vectors, for the Lyapunov exponent"),
      of_owner<Counts>("draws", "random numbers by source", draws),
  };
  return fields;
}

const StructType& fields_of(const Effort*) {
  static const StructType fields{
      "Effort",
      inlined<&Effort::operations>(),
      field<&Effort::clamps>("clamped_draws", "clamped random numbers by kind"),
      field<&Effort::operations, &OperationCounts::events>("events", "by kind", the_only<EventsType>()),
  };
  return fields;
}

}  // namespace rocking

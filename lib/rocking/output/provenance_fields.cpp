#include "rocking/output/provenance_fields.hpp"

#include <cstdint>
#include <utility>

#include "rocking/text/seed_text.hpp"

namespace rocking {
namespace {

class SeedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return seed_text(*static_cast<const std::uint64_t*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto seed = json.is_string() ? seed_from_text(json.get<std::string>()) : std::nullopt;
    if (!seed) return place.reject(json, "must be a seed as text", "for example \"0x2012\"");
    *static_cast<std::uint64_t*>(value) = *seed;
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"type", "string"}, {"pattern", "^0x[0-9a-f]{1,16}$"}};
  }
};

class ResponseModeType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return to_string(*static_cast<const section::ResponseMode*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto mode = json.is_string() ? section::response_mode_named(json.get<std::string>()) : std::nullopt;
    if (!mode) return place.reject(json, "must be the name of a response mode", "for example \"(1,1)\" or \"chaotic\"");
    *static_cast<section::ResponseMode*>(value) = *mode;
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"type", "string"}, {"pattern", "^(\\([0-9]{1,10},[0-9]{1,10}\\)|[a-z]+(-[a-z]+)*)$"}};
  }
};

class ParametersType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json parameters = Json::object();
    for (const Parameter& each : *static_cast<const std::vector<Parameter>*>(value)) {
      parameters[each.pointer] = Json::parse(each.value);
    }
    return parameters;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    if (!json.is_object()) return place.reject(json, "must be an object of JSON pointers and values");
    auto& parameters = *static_cast<std::vector<Parameter>*>(value);
    parameters.clear();
    for (const auto& [pointer, swept] : json.items()) parameters.push_back({.pointer = pointer, .value = swept.dump()});
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "object"}}; }
};

}  // namespace

const ValueType& seed_type() { return the_only<SeedType>(); }

const ValueType& TypeOf<section::ResponseMode>::get() { return the_only<ResponseModeType>(); }

const ValueType& TypeOf<std::vector<Parameter>>::get() { return the_only<ParametersType>(); }

}  // namespace rocking

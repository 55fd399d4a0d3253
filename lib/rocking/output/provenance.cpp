#include "rocking/output/provenance.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "rocking/fields/container_types.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

class SeedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return seed_text(*static_cast<const std::uint64_t*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto seed = json.is_string() ? seed_from_text(json.get<std::string>()) : std::nullopt;
    if (!seed)
      return place.reject(json, "must be a whole number of at most 64 bits, as text",
                          "give a value such as 0x2012 or 8210");
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
    return {{"type", "string"}, {"pattern", section::response_mode_pattern()}};
  }
};

class ParametersType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json parameters = Json::object();
    Json names = Json::object();
    for (const Parameter& each : *static_cast<const std::vector<Parameter>*>(value)) {
      parameters[each.pointer] = json_of(each.value);
      if (!each.name.empty()) names[each.pointer] = each.name;
    }
    if (!names.empty()) parameters[names_of_values] = std::move(names);
    return parameters;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    if (!json.is_object()) return place.reject(json, "must be an object of JSON pointers and values");
    const Json names = json.value(names_of_values, Json::object());
    const auto is_text = [](const Json& name) { return name.is_string(); };
    if (!names.is_object() || !std::ranges::all_of(names, is_text)) {
      return place.reject(names, "must be an object of JSON pointers and names");
    }
    auto& parameters = *static_cast<std::vector<Parameter>*>(value);
    parameters.clear();
    for (const auto& [pointer, swept] : json.items()) {
      if (pointer == names_of_values) continue;
      parameters.push_back({.pointer = pointer, .value = swept_value(swept), .name = names.value(pointer, "")});
    }
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "object"}}; }
};

/// `2012-02-01T12:00:00Z`, a text in C++ too.
class InstantType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return *static_cast<const std::string*>(value); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    constexpr std::string_view form = "0000-00-00T00:00:00Z";
    const std::string text = json.is_string() ? json.get<std::string>() : "";
    const auto fits = [](char c, char model) { return model == '0' ? '0' <= c && c <= '9' : c == model; };
    if (!std::ranges::equal(text, form, fits)) {
      return place.reject(json, "must be an instant in UTC", "for example \"2012-02-01T12:00:00Z\"");
    }
    *static_cast<std::string*>(value) = text;
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"type", "string"}, {"pattern", "^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z$"}};
  }
};

/// An experiment is described by its own schema; readers of a result use its title.
class QuotedExperimentType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return *static_cast<const Json*>(value); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const bool has_title = json.is_object() && json.contains("title") && json["title"].is_string();
    if (!json.is_null() && !has_title) return place.reject(json, "must be an experiment with a title, or null");
    *static_cast<Json*>(value) = json;
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", Json::array({"object", "null"})}}; }
};

class DigestType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return base::to_hex(*static_cast<const base::Sha256*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto digest = json.is_string() ? base::sha256_from_hex(json.get<std::string>()) : std::nullopt;
    if (!digest) return place.reject(json, "must be a SHA-256 of 64 hexadecimal digits");
    *static_cast<base::Sha256*>(value) = *digest;
  }
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "string"}, {"pattern", "^[0-9a-f]{64}$"}}; }
};

}  // namespace

const ValueType& TypeOf<base::Sha256>::get() { return the_only<DigestType>(); }

const StructType& fields_of(const InputFacts*) {
  static const StructType fields{
      "Input",
      field<&InputFacts::experiment>("experiment", "the canonical experiment; null: it was made in C++",
                                     the_only<QuotedExperimentType>()),
      field<&InputFacts::sha256>("sha256", "of its text, as `rocking validate --json` prints it"),
  };
  return fields;
}

const StructType& fields_of(const SystemFacts*) {
  using base::BuildInfo;
  using System = SystemFacts;
  static const StructType fields{
      "System",
      field<&System::build, &BuildInfo::version>("version", "of rocking"),
      field<&System::build, &BuildInfo::revision>("revision", "of its source"),
      field<&System::build, &BuildInfo::compiler>("compiler", "its name and version"),
      field<&System::build, &BuildInfo::flags>("flags", "of the compiler that affect numerical results"),
      field<&System::build, &BuildInfo::build_type>("build_type", "as `Release`"),
      field<&System::build, &BuildInfo::libraries>("libraries", "of others, with their versions", {},
                                                   WithoutValue::omitted),
      field<&System::machine>("machine", "processor and operating system"),
      field<&System::start>("start", "ISO 8601, UTC", the_only<InstantType>()),
      field<&System::duration_s>("duration_s", "wall-clock time [s]", rule::not_negative),
      field<&System::threads>("threads", "number of threads", Rule{.least = 1.0}),
  };
  return fields;
}

void check_input(const InputFacts& input, const ReadingPlace& place) {
  if (input.experiment.is_null() || input.sha256 == base::to_hex(base::sha256(input.experiment.dump()))) return;
  place.at("sha256").reject_changed(input.sha256);
}

void check_fit(const Json& read, const Json& right, const ReadingPlace& place) {
  const Json steps = Json::diff(read, right);
  if (steps.empty()) return;
  const auto path = steps.front().at("path").get<std::string>();
  const Json::json_pointer there(path);
  ReadingPlace differs = place;
  differs.pointer += path;
  differs.reject_changed(read.contains(there) ? read.at(there) : Json());
}

InputFacts input_of(const Experiment& experiment) {
  const std::string& text = experiment.canonical_text;
  return {.experiment = text.empty() ? Json() : Json::parse(text),
          .sha256 = base::to_hex(base::sha256(experiment.canonical_text))};
}

const ValueType& seed_type() { return the_only<SeedType>(); }

const ValueType& TypeOf<section::ResponseMode>::get() { return the_only<ResponseModeType>(); }

const ValueType& TypeOf<std::vector<Parameter>>::get() { return the_only<ParametersType>(); }

}  // namespace rocking

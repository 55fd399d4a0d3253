#include "rocking/output/validity_fields.hpp"

#include <map>
#include <string>
#include <vector>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"

namespace rocking {
namespace {

/// Cases stand in documents as their number.
class CasesType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return static_cast<const Cases*>(value)->count; }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    type_of<std::uint64_t>().read(json, place, &static_cast<Cases*>(value)->count);
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<std::uint64_t>().schema(rule); }
};

class ClampsType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json json = Json::object();
    for (const ClampKind& kind : clamp_kinds) {
      const std::uint64_t count = static_cast<const Clamps*>(value)->*kind.count;
      if (kind.in_every_report || count > 0) json[std::string(kind.key)] = count;
    }
    return json;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::map<std::string, std::uint64_t> counts;
    type_of<std::map<std::string, std::uint64_t>>().read(json, place, &counts);
    for (const ClampKind& kind : clamp_kinds) {
      auto found = counts.extract(std::string(kind.key));
      if (found) static_cast<Clamps*>(value)->*kind.count = found.mapped();
      if (!found && kind.in_every_report) place.at(kind.key).reject(Json(), "is missing");
    }
    for (const auto& [key, count] : counts) place.at(key).reject(Json(count), "is not a known key");
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = {{"title", "Clamps"}, {"type", "object"}, {"additionalProperties", false}};
    for (const ClampKind& kind : clamp_kinds) {
      schema["properties"][std::string(kind.key)] = type_of<std::uint64_t>().schema(rule);
      if (kind.in_every_report) schema["required"].push_back(kind.key);
    }
    return schema;
  }
};

}  // namespace

template <>
struct TypeOf<Cases> : OnlyType<CasesType> {};

const ValueType& TypeOf<Clamps>::get() { return the_only<ClampsType>(); }

namespace {

/// The first realisations of each kind that occurred, and of each reason for an unresolved response.
class FirstRealisationsType final : public ValueType {
  using Numbers = std::map<std::string, std::vector<std::uint64_t>>;

 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json first = Json::object();
    for_each_case(*static_cast<const Validity*>(value), [&first](const std::string& name, const Cases& cases) {
      if (cases.count > 0) first[name] = cases.first;
    });
    return first;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    Numbers numbers;
    type_of<Numbers>().read(json, place, &numbers);
    for_each_case(*static_cast<Validity*>(value), [&](const std::string& name, Cases& cases) {
      const auto found = numbers.extract(name);
      if (found) cases.first = found.mapped();
      if (!found && cases.count > 0) place.at(name).reject(Json(), "is missing, although there are such realisations");
    });
    for (const auto& [name, list] : numbers) place.at(name).reject(Json(list), "is of a kind that has no realisations");
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<Numbers>().schema(rule); }
};

}  // namespace

static const StructType& fields_of(const Validity*) {
  using V = Validity;
  static const StructType fields{
      "Validity",
      field<&V::left_ground>("left_ground", "reached a normal force of zero or less"),
      field<&V::left_ground_before_fall>("left_ground_before_fall", "of these, before any final fall"),
      field<&V::painleve>("painleve", "ended because the equations have no solution (Painleve's paradox)"),
      field<&V::stopped>("stopped", "ended because a budget of events or steps was exhausted"),
      field<&V::in_transient>("in_transient", "not settled at the end of the sampled periods"),
      field<&V::settled_late>("settled_late", "classified by the last part of their sampled periods"),
      field<&V::least_held>("least_held",
                            "smallest share of its sampled periods that supports a mode; 1 where none settled late",
                            Rule{.above = 0.0, .most = 1.0}),
      field<&V::past_balance>("past_balance", "reached abs(Theta) = 1"),
      field<&V::contradictions>("contradictions",
                                "had an instant at which neither sticking nor slipping is consistent; it sticks there"),
      field<&V::clamped>("clamped", "had a random number clamped"),
      field<&V::backed_by>(
          "backed_by",
          "what the labels (m,n) are backed by (a stable orbit, points that repeat, clouds) to realisations"),
      field<&V::unresolved>("unresolved", "reason why the mode is unresolved to realisations"),
      field<&V::clamps>("clamped_draws",
                        "clamped random numbers by kind; `block_length_at_bound` only where it is not 0"),
  };
  return fields;
}

const StructType& validity_fields() {
  using Result = ConditionResult;
  static const StructType fields{
      "ValidityOfRun",
      inlined<&Result::validity>(),
      derived<[](const Result& result) { return result.operations.draws(); }>("draws", "random numbers of all sources"),
      field<&Result::validity>("first_realisations",
                               "kind or reason to the numbers of the first few, for `rocking trajectory`",
                               the_only<FirstRealisationsType>()),
  };
  return fields;
}

}  // namespace rocking

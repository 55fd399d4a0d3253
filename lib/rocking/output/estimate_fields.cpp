#include "rocking/output/ensemble_fields.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rocking/fields/container_types.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {

/// A field for each method of an interval.
static const StructType& fields_of_methods() {
  static const StructType fields = []<std::size_t... i>(std::index_sequence<i...>) {
    return StructType("IntervalsByMethod", Field{.key = stats::interval_methods[i].key,
                                                 .sentence = stats::interval_methods[i].sentence,
                                                 .rule = rule::share,
                                                 .type = &type_of<stats::Interval>(),
                                                 .member = [](void* owner) -> void* {
                                                   return &(*static_cast<stats::IntervalsByMethod*>(owner))[i];
                                                 }}...);
  }
  (std::make_index_sequence<stats::interval_methods.size()>{});
  return fields;
}

static const StructType& fields_of(const Estimate*) {
  static const StructType fields{
      "Estimate",
      field<&Estimate::estimate>("estimate", "count/n", rule::share),
      inlined<&Estimate::alone>(fields_of_methods()),
      field<&Estimate::simultaneous>("simultaneous", "exact; the intervals of all possible modes hold at once",
                                     rule::share),
      field<&Estimate::anytime>(
          "anytime", "with `until`: holds for all modes at once, whenever the run stops; the one to quote then",
          rule::share, WithoutValue::omitted),
  };
  return fields;
}

const StructType& fields_of(const SideEstimate*) {
  using Side = SideEstimate;
  static const StructType fields{
      "SideEstimate",
      field<&Side::probability, &Estimate::counts, &stats::Proportion::successes>(
          "count", "realisations of the n that overturned to this side"),
      inlined<&Side::probability>(),
  };
  return fields;
}

namespace {

using Counts = std::map<section::ResponseMode, std::uint64_t>;
using Probabilities = std::map<section::ResponseMode, Estimate>;
using Modes = std::vector<ModeEstimate>;

class ModeCountsType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json counts = Json::object();
    for (const auto& [mode, probability] : *static_cast<const Modes*>(value)) {
      counts[to_string(mode)] = probability.counts.successes;
    }
    return counts;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    Counts counts;
    type_of<Counts>().read(json, place, &counts);
    auto& modes = *static_cast<Modes*>(value);
    modes.clear();
    for (const auto& [mode, count] : counts) {
      modes.push_back({.mode = mode, .probability = {}});
      modes.back().probability.counts.successes = count;
    }
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<Counts>().schema(rule); }
};

class ModeProbabilitiesType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json probabilities = Json::object();
    for (const auto& [mode, probability] : *static_cast<const Modes*>(value)) {
      probabilities[to_string(mode)] = type_of<Estimate>().json(&probability);
    }
    return probabilities;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    Probabilities found;
    type_of<Probabilities>().read(json, place, &found);
    for (auto& [mode, probability] : *static_cast<Modes*>(value)) {
      const std::string name = to_string(mode);
      if (auto node = found.extract(mode)) {
        node.mapped().counts = probability.counts;
        probability = node.mapped();
      } else {
        place.at(name).reject(Json(), "is missing: this mode has a count and no probability");
      }
    }
    for (const auto& [mode, probability] : found) place.at(to_string(mode)).reject(Json(), "has no count");
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<Probabilities>().schema(rule); }
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
    type_of<Probabilities>().describe(prefix, rows);
  }
};

}  // namespace

const ValueType& mode_counts_type() { return the_only<ModeCountsType>(); }
const ValueType& mode_probabilities_type() { return the_only<ModeProbabilitiesType>(); }

}  // namespace rocking

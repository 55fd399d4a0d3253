#include "rocking/output/write_facts.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// File names may contain bytes that are not UTF-8, which JSON does not allow. Each becomes U+FFFD.
std::string dump_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string facts_text(std::span<const Fact> facts) {
  Json json = Json::object();
  for (const Fact& fact : facts) {
    std::visit([&](const auto& value) { json[fact.name] = value; }, fact.value);
  }
  return dump_of(json) + '\n';
}

std::string validation_text(const Experiment& experiment) {
  Json json = Json::object();
  json["valid"] = true;
  json["conditions"] = experiment.conditions.size();
  json["sha256"] = base::to_hex(base::sha256(experiment.canonical_text));
  json["experiment"] = Json::parse(experiment.canonical_text);
  return dump_of(json) + '\n';
}

std::string validation_text(std::span<const base::Problem> problems) {
  Json json = Json::object();
  json["valid"] = false;
  Json& list = json["problems"] = Json::array();
  for (const base::Problem& problem : problems) {
    Json entry = Json::object();
    entry["place"] = problem.place;
    if (!problem.where.empty()) entry["where"] = problem.where;
    entry["value"] = problem.value;
    entry["reason"] = problem.reason;
    entry["remedy"] = problem.remedy;
    list.push_back(std::move(entry));
  }
  return dump_of(json) + '\n';
}

}  // namespace rocking

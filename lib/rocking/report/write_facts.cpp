#include "rocking/report/write_facts.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/report/json.hpp"

namespace rocking::report {

std::string facts_text(std::span<const Fact> facts) {
  Json json = Json::object();
  for (const Fact& fact : facts) {
    std::visit([&](const auto& value) { json[fact.name] = value; }, fact.value);
  }
  return json.dump(2) + '\n';
}

std::string validation_text(const experiment::Experiment& experiment) {
  Json json = Json::object();
  json["valid"] = true;
  json["conditions"] = experiment.conditions.size();
  json["sha256"] = base::to_hex(base::sha256(experiment.canonical_text));
  json["experiment"] = Json::parse(experiment.canonical_text);
  return json.dump(2) + '\n';
}

std::string validation_text(std::span<const base::Problem> problems) {
  Json json = Json::object();
  json["valid"] = false;
  Json& list = json["problems"] = Json::array();
  for (const base::Problem& problem : problems) {
    Json entry = Json::object();
    entry["place"] = problem.place;
    entry["value"] = problem.value;
    entry["reason"] = problem.reason;
    entry["remedy"] = problem.remedy;
    list.push_back(std::move(entry));
  }
  return json.dump(2) + '\n';
}

}  // namespace rocking::report

#include "rocking/output/write_check_normal.hpp"

#include "rocking/text/json.hpp"
#include "rocking/text/seed_text.hpp"

namespace rocking {
namespace {

void write_moment(const stats::MomentTest& test, Json& json) {
  json["value"] = test.moment.value;
  json["standard_error"] = test.moment.standard_error;
  json["z"] = test.moment.z;
  json["p_value"] = test.p_value;
}

Json moment_json(const stats::MomentTest& test) {
  Json json = Json::object();
  write_moment(test, json);
  return json;
}

Json shape_json(const stats::ShapeTest& shape) {
  Json json = moment_json(shape.test);
  Json& nearness = json["nearness"] = Json::array();
  for (const stats::Nearness& near : {shape.near, shape.observed}) {
    Json entry = Json::object();
    entry["distance"] = near.distance;
    entry["probability"] = near.probability;
    nearness.push_back(std::move(entry));
  }
  return json;
}

Json correlations_json(const std::vector<stats::CorrelationTest>& correlations) {
  Json json = Json::array();
  for (const stats::CorrelationTest& correlation : correlations) {
    Json entry = Json::object();
    entry["between"] = correlation.between;
    write_moment(correlation.test, entry);
    json.push_back(std::move(entry));
  }
  return json;
}

Json test_json(const stats::TestOfFit& test) {
  Json json = Json::object();
  json["statistic"] = test.statistic;
  json["p_value"] = test.p_value;
  return json;
}

Json tails_json(const stats::NormalCheck& check) {
  Json tails = Json::array();
  for (const stats::TailCount& tail : check.tails) {
    Json entry = Json::object();
    entry["sigmas"] = tail.sigmas;
    entry["count"] = tail.beyond.successes;
    entry["expected"] = tail.expected;
    entry["p_value"] = tail.p_value;
    tails.push_back(std::move(entry));
  }
  return tails;
}

Json histogram_json(const stats::Histogram& histogram) {
  Json json = Json::object();
  json["edges"] = histogram.edges;
  json["counts"] = histogram.counts;
  json["expected"] = histogram.expected;
  json["below"] = histogram.below;
  json["above"] = histogram.above;
  json["expected_below"] = histogram.expected_below;
  json["expected_above"] = histogram.expected_above;
  return json;
}

}  // namespace

std::string check_normal_text(const SamplerCheck& check) {
  const stats::NormalCheck& found = check.found;
  Json json = Json::object();
  json["format"] = check_normal_format;
  json["sampler"] = check.sampler;
  json["seed"] = seed_text(check.seed);
  Json& law = json["law"] = Json::object();
  law["mean"] = found.law.mean;
  law["sigma"] = found.law.sigma;
  json["n"] = found.n;
  json["mean"] = moment_json(found.mean);
  json["standard_deviation"] = moment_json(found.standard_deviation);
  json["skewness"] = shape_json(found.skewness);
  json["kurtosis"] = shape_json(found.kurtosis);
  json["correlations"] = correlations_json(found.correlations);
  json["jarque_bera"] = test_json(found.jarque_bera);
  json["dagostino_pearson"] = test_json(found.dagostino_pearson);
  json["anderson_darling"] = test_json(found.anderson_darling);
  json["kolmogorov_smirnov"] = test_json(found.kolmogorov_smirnov);
  json["tails"] = tails_json(found);
  json["histogram"] = histogram_json(found.histogram);
  json["refuted"] = stats::is_refuted(found);
  return json.dump(2) + '\n';
}

}  // namespace rocking

#include "rocking/report/write_check_normal.hpp"

#include "rocking/report/json.hpp"
#include "rocking/report/read_quantity.hpp"

namespace rocking::report {
namespace {

Json moment_json(const stats::Moment& moment) {
  Json json = Json::object();
  json["value"] = moment.value;
  json["standard_error"] = moment.standard_error;
  json["z"] = moment.z;
  return json;
}

Json test_json(const stats::TestOfFit& test) {
  Json json = Json::object();
  json["statistic"] = test.statistic;
  json["p_value"] = test.p_value;
  return json;
}

Json tails_json(const NormalCheck& check) {
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

std::string check_normal_text(const NormalCheck& check) {
  Json json = Json::object();
  json["format"] = check_normal_format;
  json["sampler"] = check.sampler;
  json["seed"] = seed_text(check.seed);
  Json& law = json["law"] = Json::object();
  law["mean"] = check.law.mean;
  law["sigma"] = check.law.sigma;
  json["n"] = check.moments.n;
  json["mean"] = moment_json(check.moments.mean);
  json["standard_deviation"] = moment_json(check.moments.standard_deviation);
  json["skewness"] = moment_json(check.moments.skewness);
  json["kurtosis"] = moment_json(check.moments.kurtosis);
  json["pair_correlation"] = moment_json(check.pair_correlation);
  json["lag_correlation"] = moment_json(check.lag_correlation);
  json["jarque_bera"] = test_json(check.jarque_bera);
  json["dagostino_pearson"] = test_json(check.dagostino_pearson);
  json["anderson_darling"] = test_json(check.anderson_darling);
  json["kolmogorov_smirnov"] = test_json(check.kolmogorov_smirnov);
  json["tails"] = tails_json(check);
  json["histogram"] = histogram_json(check.histogram);
  return json.dump(2) + '\n';
}

}  // namespace rocking::report

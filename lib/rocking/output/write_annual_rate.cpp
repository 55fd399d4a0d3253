#include "rocking/output/write_annual_rate.hpp"

#include <vector>

#include "rocking/output/fragility_words.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

Json annual_rate_json(const std::optional<AnnualRate>& rate) {
  if (!rate) return nullptr;
  Json json = Json::object();
  json["value"] = rate->value;
  json["interval"] = rate->interval ? interval_json(*rate->interval) : Json();
  json["from"] = rate->source == RateSource::law ? "law" : "levels";
  json["untested_share"] = rate->untested_share;
  json["probability_at_first"] = rate->probability_at_first;
  Json& ranges = json["by_level"] = Json::array();
  for (const RateInRange& range : rate->by_level) {
    ranges.push_back({{"from", range.from},
                      {"to", range.to ? Json(*range.to) : Json()},
                      {"rate", range.rate},
                      {"share", range.share},
                      {"tested", range.is_tested}});
  }
  return json;
}

std::string annual_rate_table(const AnnualRate& rate, const FragilityEvent& event, const std::string& parameter) {
  std::string text = "mean annual rate of " + words_of(event) + ": " + significant(rate.value, 3);
  if (rate.interval) {
    text += " [" + significant(rate.interval->low, 3) + ", " + significant(rate.interval->high, 3) + ']';
  }
  text += rate.value > 0.0 ? ", once in " + significant(1.0 / rate.value, 3) + " years\n" : "\n";
  if (rate.source == RateSource::levels) {
    text +=
        "no function is fitted: the rate is that of the levels, interpolated; its interval assumes that the "
        "probability does not decrease\n";
  }
  std::vector<TextRow> rows{{last_key(parameter) + " from", "to", "per year", "share", "tested"}};
  for (const RateInRange& range : rate.by_level) {
    rows.push_back({significant(range.from, 4), range.to ? significant(*range.to, 4) : ".", significant(range.rate, 3),
                    per_cent(range.share), range.is_tested ? "yes" : "no"});
  }
  text += aligned(rows) + per_cent(rate.untested_share) + " % of the rate comes from intensities outside the levels\n";
  if (rate.probability_at_first > 0.001) {
    text += "at the lowest intensity of the hazard curve the probability is " + per_cent(rate.probability_at_first) +
            " %; weaker shaking is not counted: begin the hazard curve at lower intensities\n";
  }
  return text;
}

}  // namespace rocking

#include "rocking/output/write_cost.hpp"

#include "rocking/output/cost_table.hpp"
#include "rocking/output/provenance_fields.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

Json flip_json(const Flip& flip) {
  Json json = Json::object();
  json["condition"] = flip.key.condition;
  json["realisation"] = flip.key.realisation;
  json["mode"] = to_string(flip.mode);
  json["reference"] = to_string(flip.reference);
  return json;
}

Json departure_json(const Departure& departure) {
  Json json = Json::object();
  json["error"] = {{"of", departure.moving},
                   {"median", or_null(departure.median_error)},
                   {"largest", or_null(departure.largest_error)}};
  json["diverged"] = departure.diverged;
  json["flips"] = {{"count", departure.flips.successes},
                   {"of", departure.flips.trials},
                   {"interval", interval_json(departure.flips_interval)}};
  Json& beyond = json["beyond_floor"] = Json();
  if (departure.beside_tolerance_sensitivity) {
    beyond = {{"here_only", departure.beside_tolerance_sensitivity->first_only},
              {"floor_only", departure.beside_tolerance_sensitivity->second_only},
              {"interval", interval_json(*departure.beyond_floor)}};
  }
  Json& first = json["first_flips"] = Json::array();
  for (const Flip& flip : departure.first_flips) first.push_back(flip_json(flip));
  return json;
}

Json tolerance_json(const ToleranceCost& cost) {
  Json json = Json::object();
  json["tolerance"] = cost.tolerance;
  json["periods"] = cost.periods;
  json["steps_per_period"] = cost.steps_per_period();
  json["departure"] = cost.departure ? departure_json(*cost.departure) : Json();
  return json;
}

Json recommendation_json(const Cost& cost) {
  const Recommendation& found = cost.recommendation;
  Json json = Json::object();
  json["tolerance"] = found.place ? Json(cost.curve[*found.place].tolerance) : Json();
  json["coarsest"] = found.coarsest ? Json(cost.curve[*found.coarsest].tolerance) : Json();
  json["assurance"] = to_string(found.assurance);
  json["half_width"] = or_null(cost.yardstick.half_width);
  json["bearable"] = found.bearable;
  json["at_most"] = found.place ? Json(found.at_most) : Json();
  json["sample_needed"] = or_null(found.sample_needed);
  return json;
}

Json result_json(const Cost& cost) {
  Json json = Json::object();
  json["sample"] = {{"realisations", cost.sample},
                    {"conditions", cost.sampled_conditions},
                    {"is_everything", cost.yardstick.is_everything}};
  json["error_periods"] = cost_error_periods;
  Json& tolerances = json["tolerances"] = Json::array();
  for (const ToleranceCost& tolerance : cost.curve) tolerances.push_back(tolerance_json(tolerance));
  Json& planned = json["realisations"] = Json::array();
  for (const auto& [factor, widths, periods, seconds] : cost.planned) {
    planned.push_back({{"factor", factor},
                       {"half_width_mean", widths.mean},
                       {"half_width_widest", widths.widest},
                       {"wilson_widest", widths.widest_wilson},
                       {"periods", periods}});
  }
  Json& goals = json["goals"] = Json::array();
  for (const auto& [half_width, needed, periods, seconds] : cost.goals) {
    goals.push_back({{"half_width", half_width},
                     {"realisations", needed.by_shares},
                     {"at_most", needed.at_most},
                     {"periods", periods}});
  }
  json["recommendation"] = recommendation_json(cost);
  return json;
}

Json times_json(const MeasuredCost& measured) {
  Json json = type_of<SystemFacts>().json(&measured.system);
  const CostTiming& timing = measured.cost.timing;
  json["processor_s_per_period"] = timing.seconds_per_period;
  Json& planned = json["planned_processor_s"] = Json::array();
  for (const PlannedRealisations& plan : measured.cost.planned) planned.push_back(plan.seconds);
  json["timed"] = {{"realisations", timing.realisations}, {"periods", timing.periods}};
  json["recommendation"] = cost_recommendation(measured);
  return json;
}

}  // namespace

std::string cost_text(const MeasuredCost& measured) {
  Json json = Json::object();
  json["format"] = cost_format;
  const InputFacts input = input_of(*measured.experiment);
  json["input"] = type_of<InputFacts>().json(&input);
  json["result"] = result_json(measured.cost);
  json["system"] = times_json(measured);
  return json.dump(2) + '\n';
}

}  // namespace rocking

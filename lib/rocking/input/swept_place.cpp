#include "rocking/input/sweep.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/excitation.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

/// Keys of which a file has one, in different units.
constexpr std::array<std::span<const NamedPlace>, 9> alternatives{quantities::amplitudes,
                                                                  quantities::strengths,
                                                                  quantities::frequencies,
                                                                  quantities::vertical_amplitudes,
                                                                  quantities::vertical_frequencies,
                                                                  quantities::tilts,
                                                                  quantities::tilt_rates,
                                                                  quantities::slips,
                                                                  quantities::slip_rates};

/// What to do about a place that the file has in another form: the other unit of a number, or a restitution.
std::optional<std::string> advice_on_form(const std::string& pointer, const Json& document) {
  const auto advice = [](std::string_view has, const std::string& instead) {
    return "the file has \"" + std::string(has) + "\": sweep that, or write " + instead + " in its place";
  };
  constexpr std::string_view restitution = "/restitution/";
  if (pointer.starts_with(restitution) && document.contains("restitution")) {
    if (const auto form = restitution_type().written(pointer.substr(restitution.size()))) {
      return advice("/restitution", *form);
    }
  }
  for (const auto& places : alternatives) {
    if (std::ranges::find(places, pointer, &NamedPlace::place) == places.end()) continue;
    for (const NamedPlace& each : places) {
      if (document.contains(Json::json_pointer(std::string(each.place)))) {
        return advice(each.place, '"' + last_key(pointer) + '"');
      }
    }
  }
  return std::nullopt;
}

bool leads_somewhere(const std::string& pointer, const Json& experiment) {
  for (const std::string_view fixed : {"/format", "/title", "/seed", "/sweep", "/unknown", "/excitation/suite",
                                       "/excitation/sha256", "/excitation/vertical_sha256"}) {
    if (is_within(pointer, fixed)) return false;
  }
  try {
    return experiment.contains(Json::json_pointer(pointer));
  } catch (const Json::exception&) {  // not a pointer at all
    return false;
  }
}

constexpr Rule any_end{.demand = "must be a number", .example = "0.0"};

/// A law with a density.
std::optional<Quantity> read_prior(FieldReader& in) {
  if (!in.has("prior")) return std::nullopt;
  Quantity prior = 0.0;
  const std::size_t problems_before = in.problems().size();
  in.value({"prior", ""}, prior, any_end, Absent::error);
  if (in.problems().size() != problems_before) return std::nullopt;
  if (!is_drawn(prior) || std::holds_alternative<Values>(prior)) {
    in.reject("prior",
              {"must be a law with a density", "give for example {\"normal\": {\"mean\": 0.3, \"sigma\": 0.05}}"});
    return std::nullopt;
  }
  return prior;
}

Unknown read_unknown(FieldReader& in, const Json& base) {
  const std::size_t problems_before = in.problems().size();
  Unknown unknown{.pointer = read_swept_place(in, base)};
  const bool is_place = in.problems().size() == problems_before;
  if (is_place && !base[Json::json_pointer(unknown.pointer)].is_number()) {
    in.reject("parameter",
              {"is no number in this file", "write a number there, or give a number within, such as the mean"});
  }
  unknown.from = in.number({"from", ""}, any_end);
  unknown.to = in.number({"to", ""}, any_end);
  if (in.problems().size() == problems_before && !(unknown.from < unknown.to)) {
    in.reject("to", {"is not above \"from\"", "give the smallest value as \"from\" and the largest as \"to\""});
  }
  unknown.prior = read_prior(in);
  return unknown;
}

bool overlap(const std::string& a, const std::string& b) {
  return !a.empty() && !b.empty() && (is_within(a, b) || is_within(b, a));
}

}  // namespace

std::vector<std::string> swept_places(const Json& experiment) {
  std::vector<std::string> pointers;
  for (const auto& [key, value] : experiment.items()) {
    if (key == "format" || key == "title" || key == "seed" || key == "sweep" || key == "unknown") continue;
    const std::string place = child_pointer("", key);
    pointers.push_back(place);
    if (!value.is_object()) continue;
    for (const std::string& inner : swept_places(value)) pointers.push_back(place + inner);
  }
  return pointers;
}

std::string read_swept_place(FieldReader& in, const Json& experiment) {
  if (!in.has("parameter")) {
    in.reject("parameter",
              {"is missing", "give a place in the file, for example \"parameter\": \"/excitation/amplitude\""});
    return {};
  }
  std::string pointer;
  in.value({"parameter", ""}, pointer, TextType(), Absent::error);
  const bool is_text = in.found("parameter")->is_string();
  if (is_text && (pointer.empty() || !leads_somewhere(pointer, experiment))) {
    auto known = swept_places(experiment);
    const Json kind = experiment.value(Json::json_pointer("/excitation/kind"), Json());
    if (kind == Recorded::name) {
      for (const std::string_view key : all_strengths) known.push_back("/excitation/" + std::string(key));
    }
    const auto named = std::ranges::find_if(known, [&](const auto& place) { return last_key(place) == pointer; });
    const auto nearest = named != known.end() ? *named : nearest_word(pointer, known);
    const auto of_excitation = std::ranges::find_if(known, [&experiment](const std::string& place) {
      return place.starts_with("/excitation/") && experiment.value(Json::json_pointer(place), Json()).is_number();
    });
    const std::string example = kind == Recorded::name         ? "/excitation/pga_g"
                                : of_excitation != known.end() ? *of_excitation
                                                               : "/block/width_m";
    const std::string otherwise =
        nearest ? "did you mean \"" + *nearest + "\"?" : "give a place of the file, such as \"" + example + '"';
    in.reject("parameter", {"is not a value of this file that a sweep may change",
                            advice_on_form(pointer, experiment).value_or(otherwise)});
  }
  if (pointer == "/excitation/file" || pointer == "/excitation/vertical_file") {
    in.reject("parameter",
              {"changes a file without its digest, by which a report identifies it",
               "give the files as a \"suite\", or sweep \"/excitation\" with one object for each ground motion"});
  }
  return pointer;
}

std::vector<Unknown> read_unknowns(const Json& list, const Json& base, const std::vector<SweepAxis>& axes,
                                   Problems& problems) {
  std::vector<Unknown> unknowns;
  if (!list.is_array() || list.empty() || list.size() > most_unknowns) {
    problems.push_back({"/unknown", brief(list), "must be a list of one to three entries",
                        "give for example [{\"parameter\": \"/friction/static\", \"from\": 0.2, \"to\": 0.6}]"});
    return unknowns;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = "/unknown/" + std::to_string(i);
    FieldReader in(list[i], place, problems);
    Unknown unknown = read_unknown(in, base);
    static_cast<void>(in.finish());
    const bool is_swept =
        std::ranges::any_of(axes, [&](const SweepAxis& axis) { return overlap(axis.pointer, unknown.pointer); });
    const bool is_double =
        std::ranges::any_of(unknowns, [&](const Unknown& other) { return overlap(other.pointer, unknown.pointer); });
    if (is_swept || is_double) {
      problems.push_back({place + "/parameter", '"' + unknown.pointer + '"',
                          is_swept ? "is also swept" : "is also set by an entry before it", "keep one of them"});
    }
    unknowns.push_back(std::move(unknown));
  }
  return unknowns;
}

}  // namespace rocking

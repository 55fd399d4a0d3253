#include "rocking/input/swept_place.hpp"

#include <algorithm>
#include <optional>

#include "rocking/scene/excitation.hpp"
#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

/// Keys of which a file has one, in different units.
const std::vector<std::vector<std::string>>& alternatives() {
  static const std::vector<std::vector<std::string>> places = [] {
    std::vector<std::string> strengths;
    for (const std::string_view key : all_strengths) strengths.push_back("/excitation/" + std::string(key));
    return std::vector<std::vector<std::string>>{
        {"/excitation/amplitude", "/excitation/amplitude_g", "/excitation/amplitude_m_s2"},
        std::move(strengths),
        {"/excitation/frequency_ratio", "/excitation/frequency_hz", "/excitation/period_s"}};
  }();
  return places;
}

/// What to do about a place that the file has in another form: the other unit of a number, or a restitution.
std::optional<std::string> advice_on_form(const std::string& pointer, const Json& document) {
  const auto advice = [](std::string_view has, const std::string& instead) {
    return "the file has \"" + std::string(has) + "\": sweep that, or write " + instead + " in its place";
  };
  if (pointer == "/restitution/rate_ratio" && document.contains("restitution"))
    return advice("/restitution", "{\"rate_ratio\": 0.93}");
  for (const auto& places : alternatives()) {
    if (std::ranges::find(places, pointer) == places.end()) continue;
    for (const std::string& place : places) {
      if (document.contains(Json::json_pointer(place))) return advice(place, '"' + last_key(pointer) + '"');
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

}  // namespace

bool is_within(std::string_view inner, std::string_view outer) {
  return inner == outer || (inner.starts_with(outer) && inner[outer.size()] == '/');
}

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

std::string read_swept_place(ObjectReader& in, const Json& experiment) {
  if (!in.has("parameter")) {
    in.reject("parameter", "is missing",
              "give a place in the file, for example \"parameter\": \"/excitation/amplitude\"");
    return {};
  }
  std::string pointer = in.text("parameter", "");
  const bool is_text = in.value("parameter")->is_string();
  if (is_text && (pointer.empty() || !leads_somewhere(pointer, experiment))) {
    const auto known = swept_places(experiment);
    const auto nearest = nearest_word(pointer, known);
    const std::string otherwise =
        nearest ? "did you mean \"" + *nearest + "\"?" : "give a place such as \"/excitation/amplitude\"";
    in.reject("parameter", "is not a value of this file that a sweep may change",
              advice_on_form(pointer, experiment).value_or(otherwise));
  }
  if (pointer == "/excitation/file" || pointer == "/excitation/vertical_file") {
    in.reject("parameter", "changes a file without its digest, by which a report identifies it",
              "give the files as a \"suite\", or sweep \"/excitation\" with one object for each ground motion");
  }
  return pointer;
}

}  // namespace rocking

#include "rocking/input/former_keys.hpp"

#include <string_view>

namespace rocking {
namespace {

constexpr const char* former_key = "repeat_every";
constexpr const char* present_key = "rerun_every";
constexpr std::string_view former_place = "/accuracy/repeat_every";
constexpr std::string_view present_place = "/accuracy/rerun_every";

bool rename_in_accuracy(Json& document) {
  if (!document.contains("accuracy") || !document["accuracy"].is_object()) return false;
  Json& accuracy = document["accuracy"];
  if (!accuracy.contains(former_key) || accuracy.contains(present_key)) return false;
  accuracy[present_key] = accuracy[former_key];
  accuracy.erase(former_key);
  return true;
}

bool rename_in_sweep(Json& document) {
  if (!document.contains("sweep") || !document["sweep"].is_array()) return false;
  bool found = false;
  for (Json& axis : document["sweep"]) {
    if (!axis.is_object() || !axis.contains("parameter") || axis["parameter"] != former_place) continue;
    axis["parameter"] = present_place;
    found = true;
  }
  return found;
}

}  // namespace

bool rename_former_keys(Json& document) {
  if (!document.is_object()) return false;
  const bool is_in_accuracy = rename_in_accuracy(document);
  return rename_in_sweep(document) || is_in_accuracy;
}

void name_former_keys(Problems& problems) {
  for (base::Problem& problem : problems) {
    if (problem.place == present_place) problem.place = former_place;
  }
}

}  // namespace rocking

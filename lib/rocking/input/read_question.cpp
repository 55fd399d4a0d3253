#include "rocking/input/read_question.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/field_reader.hpp"

namespace rocking {
namespace {

void read_format(FieldReader& in) {
  const Json* format = in.found("format");
  if (format == nullptr) {
    in.reject("format", {"is missing", "add \"format\": \"" + std::string(experiment_format) + '"'});
  } else if (*format != experiment_format) {
    in.reject("format", {"is not a format that this version reads", "write \"" + std::string(experiment_format) + '"'});
  }
  in.write("format", experiment_format);
}

/// The places that a sweep changes, as far as it is one.
std::vector<std::string> places_of_sweep(const Json& document) {
  std::vector<std::string> places;
  if (!document.is_object() || !document.contains("sweep") || !document["sweep"].is_array()) return places;
  for (const Json& axis : document["sweep"]) {
    if (!axis.is_object() || !axis.contains("parameter") || !axis["parameter"].is_string()) continue;
    places.push_back(axis["parameter"].get<std::string>());
  }
  return places;
}

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

QuestionAsRead read_question(const Json& document, GroundMotionFiles* files, Problems& problems,
                             std::span<const std::string> written) {
  QuestionAsRead read;
  FieldReader in(document, "", problems);
  if (!written.empty()) in.write_only(written);
  const std::vector<std::string> swept = places_of_sweep(document);
  in.follow_sweep(swept);
  read_format(in);
  FiledRecords records(files);
  keys_of(in, read.question, records);
  read.canonical = in.finish();
  return read;
}

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

#include "rocking/input/read_question.hpp"

#include <string>
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

}  // namespace

QuestionAsRead read_question(const Json& document, RecordFields& records, Problems& problems,
                             std::span<const std::string> written) {
  QuestionAsRead read;
  FieldReader in(document, "", problems);
  if (!written.empty()) in.write_only(written);
  const std::vector<std::string> swept = places_of_sweep(document);
  in.follow_sweep(swept);
  read_format(in);
  keys_of(in, read.question, records);
  read.canonical = in.finish();
  return read;
}

}  // namespace rocking

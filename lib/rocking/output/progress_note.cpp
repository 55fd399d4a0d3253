#include "rocking/output/progress_note.hpp"

#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr const char* format_of_note = "rocking.progress/1";

}  // namespace

std::string to_text(const ProgressNote& note) {
  Json json = Json::object();
  json["format"] = format_of_note;
  json["process"] = note.process;
  json["elapsed_s"] = note.elapsed_s;
  json["done_before"] = note.done_before;
  json["done"] = note.done;
  json["all"] = note.all;
  return json.dump(2) + '\n';
}

std::optional<ProgressNote> read_progress_note(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", "") != format_of_note) return std::nullopt;
  for (const char* key : {"process", "done_before", "done", "all"}) {
    if (!json.contains(key) || !json[key].is_number_unsigned()) return std::nullopt;
  }
  if (!json.contains("elapsed_s") || !json["elapsed_s"].is_number()) return std::nullopt;
  return ProgressNote{.process = json["process"],
                      .elapsed_s = json["elapsed_s"],
                      .done_before = json["done_before"],
                      .done = json["done"],
                      .all = json["all"]};
}

}  // namespace rocking

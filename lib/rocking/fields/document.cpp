#include "rocking/fields/document.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;

}  // namespace

void Document::write_to(const TextSink& sink, const void* value) const {
  JsonWriter out(sink);
  out.begin_object();
  out.member("format", format_);
  fields_->write_members(value, out);
  out.end();
  sink("\n");
}

void Document::read_into(void* value, const Json& json, std::vector<base::Problem>& problems) const {
  const ReadingPlace place{.pointer = "", .problems = &problems};
  if (!json.is_object() || json.value("format", "") != format_) {
    return place.at("format").reject(json, "is missing or another: this is no file of " + std::string(format_));
  }
  Json rest = json;
  rest.erase("format");
  fields_->read(rest, place, value);
  if (problems.size() > most_problems) problems.resize(most_problems);
}

std::string Document::schema_text() const {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", format_},
                 {"description", sentence_},
                 {"type", "object"},
                 {"properties", {{"format", {{"const", format_}}}}},
                 {"required", Json::array({"format"})},
                 {"additionalProperties", false}};
  const Json fields = fields_->schema({});
  schema["properties"].update(fields["properties"]);
  for (const Json& key : fields["required"]) schema["required"].push_back(key);
  return schema.dump(2) + '\n';
}

std::string Document::table() const {
  std::vector<KeyRow> rows;
  fields_->describe("", rows);
  std::string table = "| key | meaning |\n| --- | --- |\n";
  for (const KeyRow& row : rows) table += "| `" + row.key + "` | " + std::string(row.sentence) + " |\n";
  return table;
}

}  // namespace rocking

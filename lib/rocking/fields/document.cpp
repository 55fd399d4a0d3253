#include "rocking/fields/document.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;
constexpr std::size_t least_repetition = 4;  ///< rows that stand in a table once, and are referred to later

/// Rows from `from` on that say under `prefix` what rows from `of` on say under another prefix.
struct Repetition {
  std::size_t rows = 0;
  std::size_t of = 0;
  std::string prefix;
  std::string prefix_there;
};

/// The longest one that begins at row `from` and repeats rows that are printed.
Repetition repetition_at(const std::vector<KeyRow>& rows, const std::vector<bool>& is_printed, std::size_t from) {
  Repetition longest;
  const std::string& key = rows[from].key;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
    const std::string suffix = key.substr(dot);
    for (std::size_t of = 0; of < from; ++of) {
      if (!rows[of].key.ends_with(suffix)) continue;
      Repetition found{.rows = 0,
                       .of = of,
                       .prefix = key.substr(0, dot),
                       .prefix_there = rows[of].key.substr(0, rows[of].key.size() - suffix.size())};
      while (from + found.rows < rows.size() && of + found.rows < from && is_printed[of + found.rows]) {
        const KeyRow& here = rows[from + found.rows];
        const KeyRow& there = rows[of + found.rows];
        const bool is_same = here.sentence == there.sentence && there.key.starts_with(found.prefix_there) &&
                             here.key == found.prefix + there.key.substr(found.prefix_there.size());
        if (!is_same) break;
        ++found.rows;
      }
      if (found.rows > longest.rows) longest = found;
    }
  }
  return longest;
}

}  // namespace

void Document::write_to(const TextSink& sink, const void* value) const {
  JsonWriter out(sink);
  out.begin_object();
  out.member("format", format_);
  fields_->write_members(value, out);
  out.end();
  sink("\n");
}

void Document::read_into(void* value, const Json& json, const ReadingPlace& place) const {
  if (!json.is_object() || json.value("format", "") != format_) {
    return place.at("format").reject(json, "is missing or another: this is no file of " + std::string(format_));
  }
  Json rest = json;
  rest.erase("format");
  fields_->read(rest, place, value);
  if (place.problems->size() > most_problems) place.problems->resize(most_problems);
}

std::string Document::schema_text() const {
  const Json fields = fields_->schema({});
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", fields["title"]},
                 {"description", sentence_},
                 {"type", "object"},
                 {"properties", {{"format", {{"const", format_}}}}},
                 {"required", Json::array({"format"})},
                 {"additionalProperties", false}};
  schema["properties"].update(fields["properties"]);
  for (const Json& key : fields["required"]) schema["required"].push_back(key);
  return schema.dump(2) + '\n';
}

std::string Document::table() const {
  std::vector<KeyRow> rows;
  fields_->describe("", rows);
  std::vector<bool> is_printed(rows.size(), false);
  std::string table = "| key | meaning |\n| --- | --- |\n";
  for (std::size_t i = 0; i < rows.size();) {
    const Repetition again = repetition_at(rows, is_printed, i);
    if (again.rows < least_repetition) {
      table += "| `" + rows[i].key + "` | " + std::string(rows[i].sentence) + " |\n";
      is_printed[i++] = true;
    } else {
      const std::string last = rows[i + again.rows - 1].key.substr(again.prefix.size());
      table += "| `" + rows[i].key + "` to `" + last + "` | as of `" + again.prefix_there + "` |\n";
      i += again.rows;
    }
  }
  return table;
}

}  // namespace rocking

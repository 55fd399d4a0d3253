#include "rocking/input/suite.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace rocking {
namespace {

constexpr std::array<std::string_view, 4> keys_of_a_record{"file", "sha256", "vertical_file", "vertical_sha256"};
constexpr std::size_t most_records = 10'000;

bool is_pattern(const std::string& name) { return name.find_first_of("*?") != std::string::npos; }

class SuiteReader {
 public:
  SuiteReader(const FileMatches& matches, Problems& problems) : matches_(matches), problems_(problems) {}

  std::vector<Json> read(const Json& suite) {
    const std::string place = "/excitation/suite";
    if (suite.is_string()) {
      add_names(suite, place);
    } else if (suite.is_array() && !suite.empty() && suite.size() <= most_records) {
      for (std::size_t i = 0; i < suite.size() && problems_.size() < 20; ++i) {
        add(suite[i], place + '/' + std::to_string(i));
      }
    } else {
      reject(place, suite, "must be a list of 1 to 10000 files, or a pattern",
             R"(give ["a.at2", "b.at2"], or "records/*.at2")");
    }
    return std::move(records_);
  }

 private:
  void reject(const std::string& place, const Json& value, std::string reason, std::string remedy) {
    problems_.push_back({place, brief(value), std::move(reason), std::move(remedy)});
  }

  void add(const Json& entry, const std::string& place) {
    if (entry.is_string()) return add_names(entry, place);
    if (!entry.is_object()) {
      return reject(place, entry, "must be the name of a file",
                    "give its path relative to the folder of the experiment");
    }
    for (const auto& [key, value] : entry.items()) {
      if (std::ranges::find(keys_of_a_record, key) != keys_of_a_record.end()) continue;
      return reject(place + '/' + key, value, "is not a key of a record in a suite",
                    "known keys: \"file\", \"sha256\", \"vertical_file\", \"vertical_sha256\"");
    }
    if (!entry.contains("file") || !entry["file"].is_string()) {
      return reject(place, entry, "has no \"file\"", "add the name of the record's file");
    }
    add_record(entry, place);
  }

  void add_names(const Json& text, const std::string& place) {
    const auto& name = text.get_ref<const std::string&>();
    if (!is_pattern(name)) return add_record({{"file", name}}, place);
    const std::vector<std::string> found = matches_(name);
    if (found.empty()) {
      return reject(
          place, text, "fits no file",
          "check the folder, which is relative to that of the experiment, and capital letters: *.at2 does not "
          "fit A.AT2");
    }
    if (found.size() > most_records)
      return reject(place, text, "fits more than 10000 files", "give a narrower pattern");
    for (const std::string& file : found) add_record({{"file", file}}, place);
  }

  void add_record(const Json& record, const std::string& place) {
    if (!names_.insert(record["file"].get<std::string>()).second) {
      return reject(place, record["file"], "is in the suite twice", "name each record once");
    }
    records_.push_back(record);
  }

  const FileMatches& matches_;
  Problems& problems_;
  std::set<std::string> names_;
  std::vector<Json> records_;
};

/// The excitation of an experiment; null if it has none that is an object.
Json* excitation_in(Json& document) {
  if (!document.is_object() || !document.contains("excitation") || !document["excitation"].is_object()) return nullptr;
  return &document["excitation"];
}

bool is_recorded(const Json& excitation) { return excitation.contains("kind") && excitation["kind"] == "recorded"; }

}  // namespace

std::vector<Json> take_suite(Json& document, const FileMatches& matches, Problems& problems) {
  Json* excitation = excitation_in(document);
  if (excitation == nullptr || !is_recorded(*excitation) || !excitation->contains("suite")) return {};
  for (const std::string_view key : keys_of_a_record) {
    if (!excitation->contains(key)) continue;
    problems.push_back({"/excitation/suite", "", "excludes \"" + std::string(key) + '"',
                        "keep one of them; a record of a suite may be an object with these keys"});
  }
  if (!problems.empty()) return {};
  std::vector<Json> records = SuiteReader(matches, problems).read((*excitation)["suite"]);
  if (!problems.empty()) return {};
  excitation->erase("suite");
  put_record(document, records.front());
  return records;
}

void put_record(Json& document, const Json& record) {
  Json* excitation = excitation_in(document);
  if (excitation == nullptr) return;
  for (const std::string_view key : keys_of_a_record) excitation->erase(std::string(key));
  for (const auto& [key, value] : record.items()) (*excitation)[key] = value;
}

Json record_of(const Json& canonical) {
  const Json& excitation = canonical.at("excitation");
  Json record = Json::object();
  for (const std::string_view key : keys_of_a_record) {
    if (excitation.contains(key)) record[std::string(key)] = excitation.at(std::string(key));
  }
  return record;
}

void write_suite(Json& canonical, const std::vector<Json>& records) {
  Json written = Json::object();
  for (const auto& [key, value] : canonical.at("excitation").items()) {
    if (key == "file") written["suite"] = records;
    if (std::ranges::find(keys_of_a_record, key) == keys_of_a_record.end()) written[key] = value;
  }
  canonical["excitation"] = std::move(written);
}

Json with_suite_as_sweep(Json document) {
  Json& sweep = document["sweep"];
  if (!sweep.is_array()) sweep = Json::array();
  sweep.push_back({{"parameter", std::string(suite_place)}});
  return document;
}

void take_strength_from_sweep(Json& document) {
  Json* excitation = excitation_in(document);
  if (excitation == nullptr || !is_recorded(*excitation) || !document.contains("sweep")) return;
  for (const char* key : {"scale", "pga_g", "pgv_m_s"}) {
    if (excitation->contains(key)) return;
  }
  const Json& sweep = document["sweep"];
  if (!sweep.is_array()) return;
  for (const Json& axis : sweep) {
    if (!axis.is_object() || !axis.contains("parameter")) continue;
    for (const char* key : {"pga_g", "pgv_m_s"}) {
      if (axis["parameter"] != std::string("/excitation/") + key) continue;
      const bool listed = axis.contains("values") && axis["values"].is_array() && !axis["values"].empty();
      if (listed) (*excitation)[key] = axis["values"].front();
      if (!listed && axis.contains("from")) (*excitation)[key] = axis["from"];
    }
  }
}

}  // namespace rocking

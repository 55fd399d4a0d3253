#include "rocking/input/suite.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include "rocking/base/digest.hpp"
#include "rocking/base/utf8.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/record_tables.hpp"
#include "rocking/scene/excitation.hpp"

namespace rocking {
namespace {

constexpr std::array<std::string_view, 10> keys_of_a_record{
    "file",   "sha256", "component",           "vertical_file", "vertical_sha256",
    "factor", "level",  "return_period_years", "magnitude",     "distance_km"};
constexpr const char* left_out_key = "left_out";
constexpr std::size_t most_records = 10'000;
constexpr std::size_t most_problems_of_a_table = 20;

bool is_pattern(const std::string& name) { return name.find_first_of("*?") != std::string::npos; }

class SuiteReader {
 public:
  /// `component`: of records that do not state theirs; null: none.
  SuiteReader(const FileMatches& matches, GroundMotionFiles& files, Json component, bool skips_unreadable,
              Problems& problems)
      : matches_(matches),
        files_(files),
        component_(std::move(component)),
        skips_unreadable_(skips_unreadable),
        problems_(problems) {}

  Suite read(const Json& suite) {
    const std::string place = "/excitation/suite";
    if (suite.is_string()) {
      add_names(suite, place);
    } else if (suite.is_object()) {
      add_levels(suite, place);
    } else if (suite.is_array() && !suite.empty() && suite.size() <= most_records) {
      for (std::size_t i = 0; i < suite.size() && problems_.size() < 20; ++i) {
        add(suite[i], place + '/' + std::to_string(i));
      }
    } else {
      reject(place, suite, "must be a list of 1 to 10000 files, a pattern, or a table",
             R"(give ["a.at2", "b.at2"], "records/*.at2", "_SearchResults.csv" or {"levels": "selection.csv"})");
    }
    return std::move(suite_);
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
                    "known keys: " + quoted_words(keys_of_a_record));
    }
    if (!entry.contains("file") || !entry["file"].is_string()) {
      return reject(place, entry, "has no \"file\"", "add the name of the record's file");
    }
    add_record(entry, place);
  }

  void add_names(const Json& text, const std::string& place) {
    const auto& name = text.get_ref<const std::string&>();
    if (!is_pattern(name)) return add_file(name, place);
    const std::vector<std::string> found = matches_(name);
    if (found.empty()) {
      return reject(place, text, "fits no file", "check the folder, which is relative to that of the experiment");
    }
    if (found.size() > most_records)
      return reject(place, text, "fits more than 10000 files", "give a narrower pattern");
    for (const std::string& file : found) {
      if (base::is_utf8(file)) {
        add_record({{"file", file}}, place);
      } else {
        reject(place, file, "is fitted by " + brief(text) + ", but is no UTF-8",
               "rename the file, or narrow the pattern");
      }
    }
  }

  /// A record, or the table of PEER that selects them.
  void add_file(const std::string& name, const std::string& place) {
    const bool may_be_table =
        name != ".csv" && name.find('\0') == std::string::npos && in_small_letters(name).ends_with(".csv");
    if (!may_be_table || !is_search_results(files_.text(name))) return add_record({{"file", name}}, place);
    add_selected(search_results(files_.text(name), name, problems_), name, place);
  }

  void add_levels(const Json& suite, const std::string& place) {
    if (suite.size() != 1 || !suite.contains("levels") || !suite["levels"].is_string()) {
      return reject(place, suite, "is an object, which must have \"levels\" alone",
                    "give {\"levels\": \"selection.csv\"}");
    }
    const auto name = suite["levels"].get<std::string>();
    if (name.empty() || name.find('\0') != std::string::npos) {
      return reject(place + "/levels", suite["levels"], "is not the name of a file",
                    "give {\"levels\": \"selection.csv\"}");
    }
    add_selected(level_table(files_.text(name), name, problems_), name, place);
  }

  /// Their files are named from the folder of the table.
  void add_selected(const std::vector<SelectedRecord>& selected, const std::string& table, const std::string& place) {
    const std::string folder = table.substr(0, table.rfind('/') + 1);
    if (selected.size() > most_records) {
      return reject(place, table, "selects more than 10000 records", "give a shorter table");
    }
    for (const SelectedRecord& each : selected) {
      if (problems_.size() >= most_problems_of_a_table) return;
      Json record{{"file", each.file.starts_with('/') ? each.file : folder + each.file}};
      if (each.component) record["component"] = *each.component;
      if (each.factor) record["factor"] = *each.factor;
      if (each.level) record[each.is_return_period ? "return_period_years" : "level"] = *each.level;
      if (each.magnitude) record["magnitude"] = *each.magnitude;
      if (each.distance_km) record["distance_km"] = *each.distance_km;
      if (base::is_utf8(each.file)) {
        add_record(std::move(record), place);
      } else {
        reject(place, each.file, "is named by " + brief(Json(table)) + ", but is no UTF-8", "write the table in UTF-8");
      }
    }
  }

  void add_record(Json record, const std::string& place) {
    if (!component_.is_null() && !record.contains("component")) record["component"] = component_;
    const auto& name = record["file"].get_ref<const std::string&>();
    const bool is_name =
        !name.empty() && name.find('\0') == std::string::npos;  // others are refused with the excitation
    try {
      if (is_name && !is_new(name, record, place)) return;
    } catch (const std::system_error&) {
      if (!skips_unreadable_) throw;
      return suite_.left_out.push_back(name);
    }
    suite_.records.push_back(std::move(record));
  }

  /// Whether no record before it has the bytes of this file: under two names it would count twice.
  [[nodiscard]] bool is_new(const std::string& name, const Json& record, const std::string& place) {
    std::string of_file;
    for (const char* key : {"component", "level", "return_period_years"}) {
      if (record.contains(key)) of_file += record[key].dump();
    }
    const auto [known, added] = names_.emplace(files_.digest(name) + of_file, name);
    if (added) return true;
    const bool is_same_name = known->second == name;
    reject(place, record["file"],
           is_same_name ? "is in the suite twice"
                        : "has the same content as " + brief(known->second) + ", which is in the suite (SHA-256 " +
                              known->first.substr(0, 8) + "...)",
           "name each record once");
    return false;
  }

  const FileMatches& matches_;
  GroundMotionFiles& files_;
  Json component_;
  bool skips_unreadable_;
  Problems& problems_;
  std::map<std::string, std::string> names_;  ///< by digest, and component
  Suite suite_;
};

/// The excitation of an experiment; null if it has none that is an object.
Json* excitation_in(Json& document) {
  if (!document.is_object() || !document.contains("excitation") || !document["excitation"].is_object()) return nullptr;
  return &document["excitation"];
}

bool is_recorded(const Json& excitation) { return excitation.contains("kind") && excitation["kind"] == "recorded"; }

std::vector<std::string> take_left_out(Json& excitation, Problems& problems) {
  if (!excitation.contains(left_out_key)) return {};
  const Json names = excitation[left_out_key];
  excitation.erase(left_out_key);
  if (names.is_array() && std::all_of(names.begin(), names.end(), [](const Json& name) { return name.is_string(); }))
    return names.get<std::vector<std::string>>();
  problems.push_back({std::string("/excitation/") + left_out_key, brief(names), "must be a list of names of files",
                      "omit it: `rocking run --skip-unreadable` writes it"});
  return {};
}

/// Leaves out records in which no motion is found, unless there is no other.
void leave_out_unreadable(Suite& suite, Json document, GroundMotionFiles& files) {
  std::vector<Json> readable;
  std::vector<std::string> left_out = suite.left_out;
  for (const Json& record : suite.records) {
    put_record(document, record);
    Problems problems;
    bool is_open = true;
    try {
      static_cast<void>(read_question(with_suite_as_sweep(document), &files, problems));
    } catch (const std::system_error&) {
      is_open = false;  // its vertical component
    }
    const auto is_own = [&record](const base::Problem& problem) { return is_of_record(problem, record); };
    if (is_open && std::ranges::none_of(problems, is_own)) {
      readable.push_back(record);
    } else {
      left_out.push_back(record["file"].get<std::string>());
    }
  }
  if (!readable.empty()) suite = {.records = std::move(readable), .left_out = std::move(left_out)};
}

}  // namespace

Suite take_suite(Json& document, const FileMatches& matches, GroundMotionFiles& files, bool skips_unreadable,
                 Problems& problems) {
  Json* excitation = excitation_in(document);
  if (excitation == nullptr || !is_recorded(*excitation) || !excitation->contains("suite")) return {};
  for (const std::string_view key : keys_of_a_record) {
    if (!excitation->contains(key) || key == "component") continue;
    problems.push_back({"/excitation/suite", "", "excludes \"" + std::string(key) + '"',
                        "keep one of them; a record of a suite may be an object with these keys"});
  }
  if (!problems.empty()) return {};
  std::vector<std::string> known = take_left_out(*excitation, problems);
  Suite suite = SuiteReader(matches, files, excitation->value("component", Json()), skips_unreadable, problems)
                    .read((*excitation)["suite"]);
  if (!problems.empty()) return {};
  suite.left_out.insert(suite.left_out.begin(), known.begin(), known.end());
  excitation->erase("suite");
  if (suite.records.empty()) {
    problems.push_back(
        {"/excitation/suite", "", "has no file that can be read", "check the names and the permissions"});
    return {};
  }
  put_record(document, suite.records.front());
  if (skips_unreadable) leave_out_unreadable(suite, document, files);
  put_record(document, suite.records.front());
  return suite;
}

bool is_of_record(const base::Problem& problem, const Json& record) {
  for (const char* key : {"file", "vertical_file"}) {
    if (!record.contains(key) || !record[key].is_string()) continue;
    const auto& name = record[key].get_ref<const std::string&>();
    if (problem.place == name || problem.place.starts_with(name + ", line ")) return true;
  }
  return false;
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

std::uint64_t stream_of(const Json& record) {
  const auto& digits = record.at("sha256").get_ref<const std::string&>();
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + std::min<std::size_t>(digits.size(), 16), number, 16);
  if (!record.contains("component")) return number;
  const std::string own = base::to_hex(base::sha256(record.at("component").dump()));
  std::uint64_t of_component = 0;
  std::from_chars(own.data(), own.data() + 16, of_component, 16);
  return number ^ of_component;
}

Json name_of_record(const Json& record) {
  if (!record.contains("file") || !record.at("file").is_string()) return record;
  auto name = record.at("file").get<std::string>();
  if (record.contains("component") && record.at("component").is_string()) {
    name += ", " + record.at("component").get<std::string>();
  }
  if (record.contains("level")) name += ", level " + record.at("level").dump();
  if (record.contains("return_period_years")) name += ", level " + record.at("return_period_years").dump();
  return name;
}

std::optional<SweepAxis> suite_axis(const Json& canonical) {
  const Json::json_pointer place("/excitation/suite");
  if (!canonical.contains(place) || !canonical.at(place).is_array()) return std::nullopt;
  SweepAxis axis{.pointer = std::string(suite_place), .values = {}};
  for (const Json& record : canonical.at(place)) axis.values.push_back(name_of_record(record));
  return axis;
}

Json without_suite(Json canonical) {
  if (!suite_axis(canonical)) return canonical;
  for (const char* key : {"suite", left_out_key}) canonical["excitation"].erase(key);
  return canonical;
}

void write_suite(Json& canonical, const Suite& suite) {
  Json written = Json::object();
  for (const auto& [key, value] : canonical.at("excitation").items()) {
    if (key == "file") written["suite"] = suite.records;
    if (key == "file" && !suite.left_out.empty()) written[left_out_key] = suite.left_out;
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
  for (const std::string_view key : all_strengths) {
    if (excitation->contains(std::string(key))) return;
  }
  const Json& sweep = document["sweep"];
  if (!sweep.is_array()) return;
  for (const Json& axis : sweep) {
    if (!axis.is_object() || !axis.contains("parameter")) continue;
    for (const std::string_view measure : all_strengths) {
      const std::string key(measure);
      if (key == "scale" || axis["parameter"] != "/excitation/" + key) continue;
      const bool listed = axis.contains("values") && axis["values"].is_array() && !axis["values"].empty();
      if (listed) (*excitation)[key] = axis["values"].front();
      if (!listed && axis.contains("from")) (*excitation)[key] = axis["from"];
    }
  }
}

std::vector<std::string> left_out_of(const Json& canonical) {
  const Json::json_pointer place(std::string("/excitation/") + left_out_key);
  return canonical.contains(place) ? canonical.at(place).get<std::vector<std::string>>() : std::vector<std::string>{};
}

}  // namespace rocking

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

constexpr std::string_view of_openquake = "investigation_time=";
constexpr std::string_view of_a_level = "poe-";
/// Columns of a table that are no levels.
constexpr std::array<std::string_view, 7> of_a_site{"name", "lon", "lat", "depth", "custom_site_id", "site_id", "vs30"};

/// The fields of a line of a table. A comma between quotation marks separates none.
std::vector<std::string_view> table_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  bool is_quoted = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') is_quoted = !is_quoted;
    if (i < line.size() && (is_quoted || line[i] != ',')) continue;
    std::string_view field = line.substr(start, i - start);
    constexpr std::string_view around = " \t\r\"";
    field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(around) + 1));
    start = i + 1;
  }
  return fields;
}

/// What a comment gives to a word, without quotation marks: `imt="PGA"`, `imt='PGA'`, `imt=PGA`; empty: nothing.
std::string stated(std::string_view comment, std::string_view word) {
  for (std::size_t at = comment.find(word); at != std::string_view::npos; at = comment.find(word, at + 1)) {
    const bool is_end_of_another =
        at > 0 && (std::isalnum(static_cast<unsigned char>(comment[at - 1])) != 0 || comment[at - 1] == '_');
    std::string_view rest = comment.substr(at + word.size());
    if (is_end_of_another || !rest.starts_with('=')) continue;
    rest.remove_prefix(std::min(rest.find_first_not_of("='\" ("), rest.size()));
    return std::string(rest.substr(0, rest.find_first_of(",'\" \r\n")));
  }
  return "";
}

/// Columns of a table.
struct TableColumns {
  std::size_t count = 0;
  std::size_t longitude = 0;
  std::size_t latitude = 0;
  std::vector<std::pair<std::size_t, std::string>> levels;  ///< column, and intensity as written
};

class HazardTable {
 public:
  explicit HazardTable(std::string name) : name_(std::move(name)) {}

  std::optional<std::vector<HazardInFile>> read(std::string_view text) {
    while (!text.empty() && problems_.size() < 20) {
      ++line_;
      const std::size_t end = text.find('\n');
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      if (line.find_first_not_of(", \t\r") == std::string_view::npos) continue;
      if (line.starts_with('#') || (columns_->count == 0 && line.find(of_openquake) != std::string_view::npos)) {
        comments_ += std::string(line) + '\n';
      } else if (columns_->count > 0) {
        read_site(line);
      } else if (!is_header(line)) {
        return std::nullopt;
      }
    }
    if (columns_->count == 0) return std::nullopt;
    if (curves_.empty() && problems_.empty())
      reject("", "has no line for a site", "give longitude, latitude and values");
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(curves_);
  }

 private:
  [[nodiscard]] std::string place() const { return name_ + ", line " + std::to_string(line_); }

  void reject(std::string_view found, std::string reason, std::string remedy) {
    problems_.push_back({place(), std::string(found.substr(0, 100)), std::move(reason), std::move(remedy)});
  }

  /// Whether a line names the columns of a table of sites; takes them.
  bool is_header(std::string_view line) {
    const std::vector<std::string_view> names = table_fields(line);
    const auto column = [&names](std::string_view name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    columns_->longitude = column("lon");
    columns_->latitude = column("lat");
    if (columns_->longitude == names.size() || columns_->latitude == names.size()) return false;
    columns_->count = names.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(of_a_site, names[i]) == of_a_site.end()) add_level(i, names[i]);
    }
    if (columns_->levels.empty()) reject(line, "has no column of an intensity", "name them poe-0.1, or 0.1 for rates");
    return true;
  }

  void add_level(std::size_t column, std::string_view name) {
    const bool is_probability = name.starts_with(of_a_level);
    const std::string level(is_probability ? name.substr(of_a_level.size()) : name);
    if (!hazard_number(level)) {
      return reject(name, "is neither a place nor an intensity",
                    "name the columns lon, lat, depth, poe-0.1, ... as OpenQuake does, or name, lon, lat, 0.1, ... "
                    "with annual rates");
    }
    if (!columns_->levels.empty() && is_probability != kind_.is_probability) {
      return reject(name, "is of another kind than the columns before it", "give probabilities or rates");
    }
    kind_.is_probability = is_probability;
    columns_->levels.emplace_back(column, level);
  }

  void read_site(std::string_view line) {
    const std::vector<std::string_view> fields = table_fields(line);
    if (fields.size() != columns_->count) {
      return reject(line, "has not as many values as there are columns", "give a value for each column");
    }
    const std::string_view longitude = fields[columns_->longitude], latitude = fields[columns_->latitude];
    const auto x = hazard_number(std::string(longitude)), y = hazard_number(std::string(latitude));
    if (!x || !y) return reject(x ? latitude : longitude, "is not a number", "give longitude and latitude in degrees");
    if (curves_.empty()) take_comments();
    curves_.push_back({.place = place(),
                       .measure = measure_,
                       .statistic = statistic_,
                       .site = HazardSite{.longitude = *x, .latitude = *y},
                       .kind = kind_,
                       .add_points = [columns = columns_, line, place = place()](HazardPoints& points) {
                         const std::vector<std::string_view> values = table_fields(line);
                         for (const auto& [column, level] : columns->levels) {
                           points.add(place, level, std::string(values[column]));
                         }
                       }});
  }

  void take_comments() {
    measure_ = stated(comments_, "imt");
    statistic_ = statistic_word(stated(comments_, "kind"));
    const bool is_of_a_path = !stated(comments_, "source_model_tree_path").empty();
    if (statistic_.empty() && is_of_a_path) statistic_ = "realisation";
    if (kind_.is_probability) kind_.years = hazard_number(stated(comments_, "investigation_time"));
  }

  std::string name_;
  std::string comments_;
  std::shared_ptr<TableColumns> columns_ = std::make_shared<TableColumns>();
  std::string measure_, statistic_;
  HazardKind kind_;
  std::vector<HazardInFile> curves_;
  std::vector<base::Problem> problems_;
  std::size_t line_ = 0;
};

}  // namespace

std::optional<std::vector<HazardInFile>> hazard_table(std::string_view text, const std::string& name) {
  return HazardTable(name).read(text);
}

}  // namespace rocking

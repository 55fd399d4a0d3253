#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/csv_table.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

constexpr std::string_view of_openquake = "investigation_time=";
constexpr std::string_view of_a_level = "poe-";
/// Columns of a table that are no levels.
constexpr std::array<std::string_view, 7> of_a_site{"name", "lon", "lat", "depth", "custom_site_id", "site_id", "vs30"};

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
  std::size_t longitude = 0;
  std::size_t latitude = 0;
  std::vector<std::pair<std::size_t, std::string>> levels;  ///< column, and intensity as written
};

class HazardTable {
 public:
  explicit HazardTable(const std::string& name) : name_(name), lines_(name, problems_) {}

  std::optional<std::vector<HazardInFile>> read(std::string_view text) {
    take_lines_above(text);
    CsvTable rows(text, lines_);
    if (!rows.next() || !is_header(rows)) return std::nullopt;
    while (rows.next()) read_site(rows.fields());
    if (curves_.empty() && problems_.empty())
      lines_.reject_file("has no line for a site", "give longitude, latitude and values");
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(curves_);
  }

 private:
  /// Comments; of OpenQuake also one that a spreadsheet has put between quotation marks.
  void take_lines_above(std::string_view& text) {
    for (bool is_above = true; is_above && !text.empty();) {
      const std::string_view line = text.substr(0, text.find('\n'));
      const bool is_empty = line.find_first_not_of(", \t\r") == std::string_view::npos;
      const bool is_comment = line.starts_with('#') || line.find(of_openquake) != std::string_view::npos;
      is_above = is_empty || is_comment;
      if (is_above) static_cast<void>(lines_.next_line(text));
      if (is_comment) comments_ += std::string(line) + '\n';
    }
  }

  /// Whether a row names the columns of a table of sites; takes them.
  bool is_header(const CsvTable& row) {
    const std::vector<std::string>& names = row.fields();
    const auto column = [&names](std::string_view name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    columns_->longitude = column("lon");
    columns_->latitude = column("lat");
    if (columns_->longitude == names.size() || columns_->latitude == names.size()) return false;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(of_a_site, names[i]) == of_a_site.end()) add_level(i, names[i]);
    }
    if (columns_->levels.empty())
      lines_.reject_line(row.line(), "has no column of an intensity", "name them poe-0.1, or 0.1 for rates");
    return true;
  }

  void add_level(std::size_t column, std::string_view name) {
    const bool is_probability = name.starts_with(of_a_level);
    const std::string level(is_probability ? name.substr(of_a_level.size()) : name);
    if (!hazard_number(level)) {
      return lines_.reject_line(name, "is neither a place nor an intensity",
                                "name the columns lon, lat, depth, poe-0.1, ... as OpenQuake does, or name, lon, lat, "
                                "0.1, ... with annual rates");
    }
    if (!columns_->levels.empty() && is_probability != kind_.is_probability) {
      return lines_.reject_line(name, "is of another kind than the columns before it", "give probabilities or rates");
    }
    kind_.is_probability = is_probability;
    columns_->levels.emplace_back(column, level);
  }

  void read_site(const std::vector<std::string>& fields) {
    const std::string &longitude = fields[columns_->longitude], &latitude = fields[columns_->latitude];
    const auto x = hazard_number(longitude), y = hazard_number(latitude);
    if (!x || !y) {
      return lines_.reject_line(x ? latitude : longitude, "is not a number", "give longitude and latitude in degrees");
    }
    if (curves_.empty()) take_comments();
    const std::string place = name_ + ", line " + std::to_string(lines_.line());
    curves_.push_back({.place = place,
                       .measure = measure_,
                       .statistic = statistic_,
                       .site = HazardSite{.longitude = *x, .latitude = *y},
                       .kind = kind_,
                       .add_points = [columns = columns_, fields, place](HazardPoints& points) {
                         for (const auto& [column, level] : columns->levels) points.add(place, level, fields[column]);
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
  Problems problems_;
  LineProblems lines_;
};

}  // namespace

std::optional<std::vector<HazardInFile>> hazard_table(std::string_view text, const std::string& name) {
  return HazardTable(name).read(text);
}

}  // namespace rocking

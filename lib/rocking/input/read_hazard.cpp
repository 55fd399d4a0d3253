#include "rocking/input/read_hazard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/csv_table.hpp"

namespace rocking {
namespace {

/// Two columns, with or without a header.
class TwoColumns {
 public:
  TwoColumns(std::string name, const HazardReading& reading)
      : name_(std::move(name)), is_given_years_(reading.years), points_(name_, reading), lines_(name_, problems_) {}

  HazardCurve read(std::string_view text) {
    CsvTable rows(text, lines_, {.do_blanks_separate = true});
    if (rows.next()) read_first(rows.fields());
    while (are_two_ && !points_.is_enough() && rows.next()) add(rows.fields());
    for (const base::Problem& each : problems_) points_.reject(each.place, each.value, each.reason, each.remedy);
    return points_.finish();
  }

 private:
  [[nodiscard]] std::string place() const { return name_ + ", line " + std::to_string(lines_.line()); }

  void read_first(const std::vector<std::string>& fields) {
    are_two_ = fields.size() == 2;
    if (!are_two_) {
      return points_.reject(place(), std::to_string(fields.size()) + " in the first line", "are not two columns",
                            "write: intensity, annual rate of exceedance; a decimal point is a point");
    }
    if (!hazard_number(fields[0]) && !hazard_number(fields[1])) return read_header(fields);
    take_as_flags_say();
    add(fields);
  }

  void add(const std::vector<std::string>& fields) { points_.add(place(), fields[0], fields[1]); }

  void read_header(const std::vector<std::string>& fields) {
    points_.set_header_line(lines_.line());
    const std::string &first = fields[0], &second = fields[1];
    const bool is_nameless = std::ranges::find(nameless, first) != nameless.end();
    const std::optional<HazardMeasure> measure = hazard_measure(first);
    if (!measure && !is_nameless) {
      points_.reject(place(), first, "is no known intensity measure", HazardPoints::known_measures);
    } else {
      points_.set_measure(place(), measure);
    }
    const std::optional<HazardKind> kind = hazard_kind(second);
    if (kind) return points_.set_kind(place(), second, *kind);
    points_.reject(place(), second, "is neither a rate nor a probability of exceedance",
                   "call the column annual_rate, or poe with --years T");
  }

  /// Without a header: a rate, or with --years a probability, of the measure that --imt names.
  void take_as_flags_say() {
    points_.set_measure(name_, std::nullopt);
    points_.set_kind(name_, "", {.is_probability = is_given_years_});
  }

  static constexpr std::array<std::string_view, 4> nameless{"iml", "intensity", "level", "im"};

  std::string name_;
  bool is_given_years_;
  HazardPoints points_;
  Problems problems_;  ///< of lines that are no rows
  LineProblems lines_;
  bool are_two_ = false;  ///< columns
};

}  // namespace

HazardCurve read_hazard(std::string_view text, const std::string& name, const HazardReading& reading) {
  if (reading.years && !(*reading.years > 0.0 && std::isfinite(*reading.years))) {
    throw base::InputError(
        {"--years", base::shortest(*reading.years), "must be a positive number of years", "write --years 50"});
  }
  if (text.size() > most_hazard_bytes) {
    throw base::InputError({name, "more than 10 MB", "is too large for a hazard curve", "keep the site that is meant"});
  }
  text = without_byte_order_mark(text);
  const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  if (text.substr(first).starts_with('<')) return chosen_hazard(nrml_hazards(text, name), name, reading);
  if (text.substr(first).starts_with('{')) return chosen_hazard(usgs_json_hazards(text, name), name, reading);
  if (auto curves = hazard_table(text, name)) return chosen_hazard(*std::move(curves), name, reading);
  for (const auto& [flag, is_given] :
       {std::pair{"--site", reading.site.has_value()}, std::pair{"--statistic", reading.statistic.has_value()}}) {
    if (is_given)
      throw base::InputError({flag, "", "chooses one of several curves, and " + name + " holds one", "omit it"});
  }
  return TwoColumns(name, reading).read(text);
}

}  // namespace rocking

#include "rocking/input/read_hazard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

/// Without the quotation marks that programs write around the name of a column.
std::string unquoted(const std::string& field) {
  const bool is_quoted = field.size() > 1 && field.front() == '"' && field.back() == '"';
  return is_quoted ? field.substr(1, field.size() - 2) : field;
}

/// The fields of a line, without the comment and without blanks around them: between commas or semicolons if there are
/// any, else between blanks.
std::vector<std::string> fields_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  line = line.substr(0, line.find('#'));
  const std::string_view separators = line.find_first_of(",;") == std::string_view::npos ? blanks : ",;";
  std::vector<std::string> fields;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    std::string_view field = line.substr(0, end);
    field.remove_prefix(std::min(field.find_first_not_of(blanks), field.size()));
    field = field.substr(0, field.find_last_not_of(blanks) + 1);
    // Blanks side by side separate once.
    if (!field.empty() || separators != blanks) fields.emplace_back(field);
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// Two columns, with or without a header.
class TwoColumns {
 public:
  TwoColumns(std::string name, const HazardReading& reading)
      : name_(std::move(name)), is_given_years_(reading.years), points_(name_, reading) {}

  HazardCurve read(std::string_view text) {
    while (!text.empty() && !points_.is_enough()) {
      ++line_;
      const std::size_t end = text.find('\n');
      read_line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return points_.finish();
  }

 private:
  [[nodiscard]] std::string place() const { return name_ + ", line " + std::to_string(line_); }

  void read_line(std::string_view line) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.empty() || (fields.size() == 1 && fields.front().empty())) return;
    const bool is_first = std::exchange(is_first_, false);
    if (fields.size() != 2) {
      return points_.reject(place(), std::string(line.substr(0, 200)), "has not two columns",
                            "write: intensity, annual rate of exceedance");
    }
    if (is_first && !hazard_number(fields[0]) && !hazard_number(fields[1])) return read_header(fields);
    if (is_first) take_as_flags_say();
    points_.add(place(), fields[0], fields[1]);
  }

  void read_header(const std::vector<std::string>& fields) {
    points_.set_header_line(line_);
    const std::string first = unquoted(fields[0]), second = unquoted(fields[1]);
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
  std::size_t line_ = 0;
  bool is_first_ = true;
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

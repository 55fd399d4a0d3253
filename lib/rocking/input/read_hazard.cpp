#include "rocking/input/read_hazard.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/check_hazard.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_hazard_problems = 20;

/// Without the quotation marks that programs write around the name of a column.
std::string unquoted(const std::string& field) {
  const bool is_quoted = field.size() > 1 && field.front() == '"' && field.back() == '"';
  return is_quoted ? field.substr(1, field.size() - 2) : field;
}

/// The fields of a line, without the comment and without blanks around them.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  line = line.substr(0, line.find('#'));
  std::string field;
  bool after_comma = false;
  const auto end_field = [&] {
    if (!field.empty() || after_comma) fields.push_back(field);
    field.clear();
    after_comma = false;
  };
  for (const char c : line) {
    if (c == ',' || c == ';') {
      end_field();
      after_comma = true;
    } else if (c == ' ' || c == '\t' || c == '\r') {
      if (!field.empty()) end_field();
    } else {
      // A blank before a comma ends the field, and the comma belongs to it.
      field += c;
      after_comma = false;
    }
  }
  end_field();
  return fields;
}

std::optional<double> hazard_number(const std::string& field) {
  const char* first = field.data() + (field.starts_with('+') ? 1 : 0);
  const char* last = field.data() + field.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

class HazardReader {
 public:
  explicit HazardReader(std::string name) { curve_.name = std::move(name); }

  HazardCurve read(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (text.size() > most_hazard_bytes) reject_file("more than 10 MB", "is too large for a hazard curve");
    while (!text.empty() && problems_.size() < most_hazard_problems && curve_.points.size() <= most_hazard_points) {
      ++line_;
      const std::size_t end = text.find('\n');
      read_line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (curve_.points.size() > most_hazard_points) {
      reject_file("more than " + std::to_string(most_hazard_points) + " points", "is too large for a hazard curve");
    }
    if (problems_.empty() && curve_.points.size() < 2) {
      problems_.push_back({curve_.name, std::to_string(curve_.points.size()) + " points",
                           "a hazard curve needs at least two points",
                           "give a line \"intensity, annual rate of exceedance\" for each"});
    }
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(curve_);
  }

 private:
  void reject(const std::string& found, std::string reason, std::string remedy) {
    problems_.push_back({curve_.name + ", line " + std::to_string(line_), found, std::move(reason), std::move(remedy)});
  }

  void reject_file(std::string found, std::string reason) {
    throw base::InputError(
        {.place = curve_.name,
         .value = std::move(found),
         .reason = std::move(reason),
         .remedy = "give at most " + std::to_string(most_hazard_points) +
                   " points: between them the logarithm of the rate is linear in that of the intensity"});
  }

  void read_line(std::string_view line) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.empty()) return;
    const bool is_first = std::exchange(is_first_, false);
    if (fields.size() != 2) {
      return reject(std::string(line.substr(0, 200)), "has not two columns",
                    "write: intensity, annual rate of exceedance");
    }
    const std::optional<double> intensity = hazard_number(fields[0]);
    const std::optional<double> rate = hazard_number(fields[1]);
    if (is_first && !intensity && !rate) {
      curve_.intensity = unquoted(fields[0]);
      curve_.header_line = line_;
      return;
    }
    if (!intensity) return reject(fields[0], "is not a number", "give the intensity as a number, 0.25");
    if (!rate) return reject(fields[1], "is not a number", "give the annual rate of exceedance as a number, 2.1e-3");
    const HazardPoint point{.intensity = *intensity, .rate = *rate};
    if (const auto fault = fault_of(point, curve_.points.empty() ? nullptr : &curve_.points.back())) {
      const bool is_rate = fault->number == &HazardPoint::rate;
      return reject(fields[is_rate ? 1 : 0], fault->reason, fault->remedy);
    }
    curve_.points.push_back(point);
  }

  HazardCurve curve_;
  std::vector<base::Problem> problems_;
  std::size_t line_ = 0;
  bool is_first_ = true;
};

}  // namespace

HazardCurve read_hazard(std::string_view text, const std::string& name) { return HazardReader(name).read(text); }

}  // namespace rocking

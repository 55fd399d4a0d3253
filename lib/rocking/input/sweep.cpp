#include "rocking/input/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rocking {
namespace {

constexpr Rule any_number{.demand = "must be a number", .example = "1.0"};

/// What the rounding of from, to and step moves a point by, at most, in steps: a few ulps of a million.
constexpr double rounding = 1e-9;

/// The double nearest to `number` in 12 significant decimal digits: 1.0 + 7 x 0.1 becomes the double that 1.7 reads as.
double to_twelve_digits(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::scientific, 11);
  static_cast<void>(error);  // 32 characters hold every double in 12 digits
  double rounded = number;
  std::from_chars(digits, end, rounded);  // leaves it as it is where rounding up leaves the doubles
  return rounded;
}

constexpr std::size_t most_axes = 100;
constexpr std::size_t longest_name = 60;

/// Text that fits a table.
bool is_name(const Json& name) {
  const auto is_control = [](unsigned char c) { return c < ' '; };
  return name.is_string() && name.get_ref<const std::string&>().size() <= longest_name &&
         std::ranges::none_of(name.get_ref<const std::string&>(), is_control);
}

class AxisReader {
 public:
  AxisReader(FieldReader& in, const Json& base, std::size_t most) : in_(in), base_(base), most_(most) {}

  SweepAxis read() {
    SweepAxis axis;
    axis.pointer = read_swept_place(in_, base_);
    const bool listed = in_.has("values");
    const bool stepped = in_.has("from") || in_.has("to") || in_.has("step");
    if (listed && stepped) {
      in_.reject("values", {"excludes \"from\", \"to\" and \"step\"", "keep one of the two"});
    } else if (listed) {
      axis.values = read_values();
      axis.names = read_names(axis.values.size());
    } else {
      axis.evenly_spaced = true;
      axis.values = read_steps();
    }
    return axis;
  }

 private:
  std::vector<Json> read_values() {
    const Json& values = *in_.found("values");
    if (!values.is_array() || values.empty()) {
      in_.reject("values", {"must be a list of at least one value", "give a list such as [0.3, 0.4]"});
      return {};
    }
    return {values.begin(), values.end()};
  }

  /// Of so many values; none where there are none, or a problem.
  std::vector<std::string> read_names(std::size_t values) {
    if (!in_.has("names")) return {};
    const Json& names = *in_.found("names");
    if (!names.is_array() || names.size() != values || !std::ranges::all_of(names, is_name)) {
      in_.reject("names", {"must be a list of texts of at most " + std::to_string(longest_name) +
                               " bytes on a line, one for each of the " + std::to_string(values) + " values",
                           "give a list such as [\"batteries high\", \"batteries low\"]"});
      return {};
    }
    std::vector<std::string> read = names;
    std::ranges::sort(read);
    const auto again =
        std::ranges::adjacent_find(read, [](const auto& a, const auto& b) { return !a.empty() && a == b; });
    if (again != read.end()) in_.reject("names", {"has \"" + *again + "\" twice", "give each value a name of its own"});
    return names;
  }

  std::vector<Json> read_steps() {
    const std::size_t problems_before = in_.problems().size();
    const double from = in_.number({"from", ""}, any_number);
    const double to = in_.number({"to", ""}, any_number);
    const double step = in_.number({"step", ""}, any_number);
    if (in_.problems().size() != problems_before) return {};
    if (step == 0.0) {
      in_.reject("step", {"must not be 0", "omit the sweep to run one condition"});
      return {};
    }
    const double steps = (to - from) / step;
    if (steps < 0.0) {
      in_.reject("step", {"leads away from \"to\"", "change its sign, or swap \"from\" and \"to\""});
      return {};
    }
    if (!(steps < static_cast<double>(most_))) {
      in_.reject("step", {"makes more than " + std::to_string(most_) + " points", "give a larger step"});
      return {};
    }
    const double count = std::round(steps);
    if (std::abs(steps - count) > rounding) {
      in_.reject("step", {"does not divide the distance from \"from\" to \"to\"",
                          "end at " + Json(from + std::floor(steps) * step).dump() + ", or give another step"});
      return {};
    }
    return points(from, to, step, static_cast<std::size_t>(count));
  }

  static std::vector<Json> points(double from, double to, double step, std::size_t count) {
    std::vector<Json> values;
    values.reserve(count + 1);
    values.emplace_back(from);
    for (std::size_t i = 1; i < count; ++i) {
      const double point = from + static_cast<double>(i) * step;
      values.emplace_back(std::abs(point) < rounding * std::abs(step) ? 0.0 : to_twelve_digits(point));
    }
    if (count > 0) values.emplace_back(to);
    return values;
  }

  FieldReader& in_;
  const Json& base_;
  std::size_t most_;
};

void check_disjoint(const std::vector<SweepAxis>& axes, Problems& problems) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (axes[i].pointer.empty() || axes[j].pointer.empty()) continue;
      if (!is_within(axes[i].pointer, axes[j].pointer) && !is_within(axes[j].pointer, axes[i].pointer)) continue;
      problems.push_back({"/sweep/" + std::to_string(i) + "/parameter", '"' + axes[i].pointer + '"',
                          "is also swept by /sweep/" + std::to_string(j), "keep one of them"});
    }
  }
}

}  // namespace

std::vector<SweepAxis> read_sweep(const Json& sweep, const Json& base, std::size_t most, Problems& problems) {
  std::vector<SweepAxis> axes;
  if (!sweep.is_array() || sweep.empty()) {
    problems.push_back(
        {"/sweep", brief(sweep), "must be a list of at least one entry", "omit \"sweep\" to run one condition"});
    return axes;
  }
  if (sweep.size() > most_axes) {
    problems.push_back({"/sweep", "", "has more than " + std::to_string(most_axes) + " entries", "give fewer entries"});
    return axes;
  }
  // What is beyond the limit is not worked out: many entries of a million points each would not fit into memory.
  for (std::size_t i = 0; i < sweep.size() && grid_size(axes) <= most; ++i) {
    FieldReader in(sweep[i], "/sweep/" + std::to_string(i), problems);
    axes.push_back(AxisReader(in, base, most).read());
    static_cast<void>(in.finish());
  }
  check_disjoint(axes, problems);
  if (grid_size(axes) > most) {
    problems.push_back({"/sweep", "", "makes more than " + std::to_string(most) + " conditions",
                        "give larger steps or fewer entries"});
  }
  return axes;
}

std::size_t grid_size(const std::vector<SweepAxis>& axes) {
  std::size_t size = 1;
  for (const SweepAxis& axis : axes) {
    size *= axis.values.size();
    if (size > most_conditions) return most_conditions + 1;
  }
  return size;
}

std::vector<const Json*> grid_point(const std::vector<SweepAxis>& axes, std::size_t index) {
  std::vector<const Json*> point(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    point[i] = &axes[i].values[index % axes[i].values.size()];
    index /= axes[i].values.size();
  }
  return point;
}

}  // namespace rocking

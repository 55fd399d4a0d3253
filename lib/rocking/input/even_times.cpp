#include "rocking/input/even_times.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

/// Which steps fit printed times: all t_i must lie within half a unit of their last digit of t + i h, for some t. Rounded
/// times do, and so do times that are cut off.
class FittingSteps {
 public:
  FittingSteps(std::span<const double> times, const PrintedDigits& digits) : times_(times) {
    for (const double time : times) errors_.push_back(0.5 * digits.unit_of(time));
    constexpr double unit_roundoff = 0x1p-53;
    rounding_ = unit_roundoff * static_cast<double>(times.size() + 4) * times.back();  // of times summed step by step
  }

  [[nodiscard]] bool fits(double step) const { return gap_at(step) <= rounding_; }

  /// The step at which the gap is smallest; it is convex.
  [[nodiscard]] double best(double least, double most) const {
    constexpr int most_halvings = 60;
    for (int i = 0; i < most_halvings; ++i) {
      const double third = (most - least) / 3.0;
      const double low = least + third, high = most - third;
      if (fits(low)) return low;
      if (fits(high)) return high;
      (gap_at(low) < gap_at(high) ? most : least) = gap_at(low) < gap_at(high) ? high : low;
    }
    return 0.5 * (least + most);
  }

 private:
  /// By how much the bounds on t contradict each other; not positive if some t fits.
  [[nodiscard]] double gap_at(double step) const {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const double start = times_[i] - step * static_cast<double>(i);
      least = std::max(least, start - errors_[i]);
      most = std::min(most, start + errors_[i]);
    }
    return least - most;
  }

  std::span<const double> times_;
  std::vector<double> errors_;
  double rounding_ = 0.0;
};

/// `number` in the fewest digits for which `suits` holds; the number itself if it holds for none.
template <class Suits>
double shortest(double number, Suits&& suits) {
  constexpr int most_digits = 17;
  for (int digits = 1; digits < most_digits; ++digits) {
    const std::string text = base::significant(number, digits);
    double rounded = number;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    if (suits(rounded)) return rounded;
  }
  return number;
}

double largest_deviation(std::span<const double> times, double step) {
  double largest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    largest = std::max(largest, std::abs(times[i] - times.front() - step * static_cast<double>(i)));
  }
  return largest;
}

}  // namespace

void PrintedDigits::add(std::string_view field) {
  const std::size_t end = std::min(field.find_first_of("eEdD"), field.size());
  int exponent = 0;
  if (end + 1 < field.size()) {
    std::string_view digits = field.substr(end + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  int significant = 0;
  int decimals = 0;
  bool is_behind_point = false;
  for (const char c : field.substr(0, end)) {
    if (c == '.') is_behind_point = true;
    if (c < '0' || c > '9') continue;
    if (is_behind_point) ++decimals;
    if (significant > 0 || c != '0') ++significant;
  }
  finest_exponent_ = std::min(finest_exponent_, exponent - decimals);
  most_significant_ = std::max(most_significant_, significant);
}

double PrintedDigits::unit_of(double value) const {
  const double finest = std::pow(10.0, finest_exponent_);
  if (value == 0.0) return finest;
  return std::max(finest, std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - most_significant_));
}

Evenness evenness_of(std::span<const double> times, const PrintedDigits& digits) {
  const double length = times.back() - times.front();
  const double mean = length / static_cast<double>(times.size() - 1);
  constexpr double rounding = 1e-9;  // of the step, over all times
  const auto is_mean = [&](double step) { return largest_deviation(times, step) <= rounding * mean; };
  Evenness found{.step = shortest(mean, is_mean), .shortest_step = times[1] - times[0]};
  found.largest_deviation = largest_deviation(times, found.step);
  found.is_progression = length > 0.0 && found.is_even();
  if (length > 0.0 && !found.is_progression) {
    const FittingSteps steps(times, digits);
    const double best = steps.fits(mean) ? mean : steps.best(0.5 * mean, 2.0 * mean);
    // Of rounded times often one step alone fits, which is a number with few digits.
    const double step = shortest(best, [&steps](double each) { return steps.fits(each); });
    found.is_progression = steps.fits(step);
    if (found.is_progression) found.step = step;
    found.largest_deviation = largest_deviation(times, found.step);
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    found.shortest_step = std::min(found.shortest_step, times[i] - times[i - 1]);
    found.longest_step = std::max(found.longest_step, times[i] - times[i - 1]);
  }
  return found;
}

std::optional<Refusal> refuse_long_steps(const std::vector<dynamics::GroundMotionSample>& samples) {
  constexpr std::size_t most_corners = 10;  // of a pulse that is given by the corners of a polyline
  constexpr double longest_step = 0.5;
  constexpr double longest_duration = 3600.0;
  if (samples.size() <= most_corners) return std::nullopt;
  const double duration = samples.back().time - samples.front().time;
  const double step = duration / static_cast<double>(samples.size() - 1);
  if (step < longest_step && duration <= longest_duration) return std::nullopt;
  const bool may_be_number = std::abs(step - 1.0) < 1e-9;
  return Refusal{
      "has a mean time step of " + base::significant(step, 4) + " s and lasts " + base::significant(duration, 4) +
          " s, which no record of an earthquake does",
      (may_be_number
           ? std::string(R"(if its first column counts the samples, give "columns": ["other", "horizontal"] and )"
                         R"("time_step_s")")
           : "if its times are in ms, so that the step is " + base::significant(step / 1000.0, 4) +
                 " s, say so above them: # time [ms]; else correct the time step") +
          "; if they are in seconds, give samples less than 0.5 s apart"};
}

std::string uneven_in_words(const Evenness& times, const std::string& remedy) {
  std::string text = "has uneven times: steps from " + base::significant(times.shortest_step, 3) + " to " +
                     base::significant(times.longest_step, 3) + " s; the largest deviation from even steps of " +
                     base::shortest(times.step) + " s is " + base::significant(times.largest_deviation, 3) + " s";
  if (!times.is_progression) return text + "; they are used as they stand";
  text += ", as if they were rounded; they are used as they stand, which changes the motion";
  return remedy.empty() ? text : text + " (for even steps " + remedy + ": " + base::shortest(times.step) + ')';
}

}  // namespace rocking

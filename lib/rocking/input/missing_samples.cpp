#include "rocking/input/missing_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

constexpr double beyond_all = 1e15;              // no unit makes an acceleration of it
constexpr double largest_of_two_digits = 100.0;  // 99.9 may also be a peak
constexpr double far_off = 20.0;                 // of the largest other number
constexpr double some_way_off = 1.5;

/// Whether programs write a number where nothing was recorded.
bool is_usual_mark(double number) {
  constexpr std::array<double, 14> marks{99.0,   99.9,   99.99,   999.0,   999.9,   999.99,  999.999,
                                         9999.0, 9999.9, 9999.99, 99999.0, 99999.9, 32768.0, 2147483648.0};
  const double size = std::abs(number);
  return MissingSamples::is_mark_alone(number) || std::ranges::find(marks, size) != marks.end() || size == 99999.99 ||
         size == 999999.0 || size == 9999999.0;
}

}  // namespace

bool MissingSamples::is_mark_alone(double number) { return std::abs(number) >= beyond_all; }

void MissingSamples::add(double number, std::size_t line) {
  const double size = std::abs(number);
  const bool goes_on = number == before_;
  const bool stands_off = goes_on || std::abs(number - before_) > 0.5 * size;
  if (size > std::abs(largest_.number) || largest_.count == 0) {
    largest_other_ = std::max(largest_other_, std::abs(largest_.number));
    largest_ = {.number = number, .count = 1, .line = line, .stands_off = stands_off};
  } else if (number == largest_.number) {
    ++largest_.count;
    largest_.stands_off = largest_.stands_off && stands_off;
  } else {
    largest_other_ = std::max(largest_other_, size);
  }
  if (!goes_on) {
    run_length_ = is_usual_mark(number) && stands_off ? 1 : 0;
    run_start_ = line;
  }
  if (goes_on && run_length_ > 0) ++run_length_;
  constexpr std::size_t least_run = 3;
  if (run_.count > 0 && number == run_.number) ++run_.count;
  if (run_.count == 0 && run_length_ == least_run) run_ = {.number = number, .count = least_run, .line = run_start_};
  before_ = number;
}

bool MissingSamples::is_mark(const Candidate& candidate) const {
  const double size = std::abs(candidate.number);
  if (is_mark_alone(candidate.number)) return true;
  if (candidate.count > 1 && largest_other_ > 0.0 && size >= far_off * largest_other_) return true;
  const double least = size < largest_of_two_digits ? some_way_off * largest_other_ : largest_other_;
  return is_usual_mark(candidate.number) && candidate.stands_off && size > least && largest_other_ > 0.0;
}

void MissingSamples::check(LineProblems& problems) const {
  const bool is_largest = is_mark(largest_);
  const Candidate& found = is_largest ? largest_ : run_;
  if (!is_largest && !(std::abs(run_.number) >= 999.0 && std::abs(run_.number) < std::abs(largest_.number))) return;
  problems.reject_line_at(
      found.line, base::shortest(found.number),
      "is a mark of missing samples, not an acceleration: it stands at " + std::to_string(found.count) +
          (found.count == 1 ? " sample" : " samples") +
          (is_largest ? ", and all others are at most " + base::significant(largest_other_, 3) + " in size" : ""),
      "fill the gap, or cut the record before it: nothing is interpolated");
}

}  // namespace rocking

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking {

/// The digits with which the numbers of a column are printed.
class PrintedDigits {
 public:
  /// `field`: a number as it stands in a file.
  void add(std::string_view field);

  /// One unit of the last digit with which `value` is printed: the finest of the column, or, in a column with a fixed
  /// number of significant digits, that of the value.
  [[nodiscard]] double unit_of(double value) const;

 private:
  int finest_exponent_ = 0;  ///< of ten, of the last digit
  int most_significant_ = 1;
};

/// How far times are from even steps.
struct Evenness {
  /// Whether they are, to their printed digits, an arithmetic progression that rises from the first one.
  bool is_progression = false;
  double step = 0.0;  ///< [s]; of a progression the number with the fewest digits that fits, otherwise the mean
  double largest_deviation = 0.0;  ///< from even steps that begin at the first one [s]
  double shortest_step = 0.0;      ///< between neighbours [s]
  double longest_step = 0.0;       ///< likewise

  /// Of times in a unit of which a second holds so many.
  [[nodiscard]] Evenness in_seconds(double per_second) const {
    return {is_progression, step / per_second, largest_deviation / per_second, shortest_step / per_second,
            longest_step / per_second};
  }

  /// Whether the deviation is small enough to change nothing: a thousandth of a step.
  [[nodiscard]] bool is_even() const { return largest_deviation <= 1e-3 * step; }
};

/// Of at least two times. A printed time may be rounded or cut off at its last digit.
[[nodiscard]] Evenness evenness_of(std::span<const double> times, const PrintedDigits& digits);

/// Of samples whose times are likely not in seconds: more than ten with a mean step of half a second and more, or of more than
/// an hour together. The remedy has the readings that would make sense.
[[nodiscard]] std::optional<Refusal> refuse_long_steps(const std::vector<dynamics::GroundMotionSample>& samples);

/// What a user should know of times that are not even; `remedy`: what would make them even, before the step of times that are
/// only rounded; empty: nothing.
[[nodiscard]] std::string uneven_in_words(const Evenness& times, const std::string& remedy);

}  // namespace rocking

#pragma once

#include <cstddef>

#include "rocking/input/line_problems.hpp"

namespace rocking {

/// Looks in a series for marks of missing samples: -999, 99999.9, 1e20 or -32768, or another number that stands there again
/// and again, far beyond all others.
class MissingSamples {
 public:
  /// The next number of the series, as the file has it, in this line.
  void add(double number, std::size_t line);

  /// Reports a mark at its first line, with the number of its samples.
  void check(LineProblems& problems) const;

  /// Whether a number is a mark in every unit.
  [[nodiscard]] static bool is_mark_alone(double number);

 private:
  /// A number and where it stands.
  struct Candidate {
    double number = 0.0;
    std::size_t count = 0;
    std::size_t line = 0;    ///< the first one
    bool stands_off = true;  ///< by half its size from the sample before it, wherever it stands
  };
  [[nodiscard]] bool is_mark(const Candidate& candidate) const;

  Candidate largest_;
  Candidate run_;               ///< of a usual mark, three times on end, though others are larger
  double largest_other_ = 0.0;  ///< than largest_, in size
  double before_ = 0.0;
  std::size_t run_length_ = 0;
  std::size_t run_start_ = 0;  ///< line
};

}  // namespace rocking

#pragma once

#include <string>
#include <vector>

#include "rocking/input/quantities_in_text.hpp"

namespace rocking::analysis {

/// Smallest and largest of some numbers: `0.5`, `0.5 to 2`; in `digits` digits.
struct Spread {
  double low, high;
  [[nodiscard]] bool is_one() const { return low == high; }
};
[[nodiscard]] Spread spread_of(const std::vector<double>& numbers);
[[nodiscard]] std::string spread_in_words(const Spread& spread, int digits);

/// In six digits, a law in three: `0.5`, `0.4 to 0.6 (drawn)`, `0.5 (drawn, standard deviation 0.05)`, `0.4 to 0.6 (drawn, triangular)`.
[[nodiscard]] std::string quantity_in_words(const Quantity& quantity);

}  // namespace rocking::analysis

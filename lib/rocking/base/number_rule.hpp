#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/rule.hpp"

namespace rocking {

/// Why a value will not do, and what would.
struct Refusal {
  std::string reason;
  std::string remedy;
};

using Problems = std::vector<base::Problem>;

/// What a number must be, and how to say so.
struct NumberRule {
  Rule bounds;               ///< least and largest value, so that no infinite number is allowed
  std::string_view demand;   ///< `must be ...`
  std::string_view example;  ///< JSON text of a value that would do

  [[nodiscard]] constexpr bool allows(double value) const { return bounds.allows(value); }
  [[nodiscard]] std::string remedy() const { return "give a value such as " + std::string(example); }
};

/// The same of a whole number.
struct IntegerRule {
  std::int64_t low;
  std::int64_t high;
  std::int64_t example;

  template <class Integer>
  [[nodiscard]] constexpr bool allows(Integer value) const {
    return std::cmp_less_equal(low, value) && std::cmp_less_equal(value, high);
  }
  [[nodiscard]] std::string demand() const {
    return "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  }
  [[nodiscard]] std::string remedy() const { return "give a value such as " + std::to_string(example); }
};

}  // namespace rocking

#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"

namespace rocking {

/// Refuses an argument of a call, which is not at a place of a file.
[[noreturn]] inline void refuse(std::string_view name, const std::string& value, std::string reason) {
  throw base::InputError(
      {.place = std::string(name), .value = value, .reason = std::move(reason), .remedy = {}, .where = {}});
}

/// Refuses an argument that is not a whole number from `least` to `largest`.
template <class Number>
void expect(std::string_view name, Number value, Number least, Number largest) {
  if (least <= value && value <= largest) return;
  refuse(name, std::to_string(value),
         "must be a whole number from " + std::to_string(least) + " to " + std::to_string(largest));
}

}  // namespace rocking

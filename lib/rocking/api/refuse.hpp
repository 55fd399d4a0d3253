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

}  // namespace rocking

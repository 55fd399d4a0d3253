#pragma once

#include <string>

namespace rocking {

/// Why a value will not do, and what would.
struct Refusal {
  std::string reason;
  std::string remedy;
};

}  // namespace rocking

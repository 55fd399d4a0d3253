#pragma once

#include <string>

#include "rocking/studies/check_normal/result.hpp"

namespace rocking {

/// The check as text for a terminal.
[[nodiscard]] std::string check_normal_summary(const SamplerCheck& check);

}  // namespace rocking

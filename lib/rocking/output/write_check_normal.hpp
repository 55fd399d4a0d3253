#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/stats/normal_check.hpp"

namespace rocking {

/// Value of `format` in the output of `rocking check-normal --json`.
inline constexpr std::string_view check_normal_format = "rocking.check_normal/1";

/// The check of a sampler against its law.
struct SamplerCheck {
  std::string sampler;  ///< `box-muller`, ...
  std::uint64_t seed = 0;
  stats::NormalCheck found;
};

[[nodiscard]] std::string check_normal_text(const SamplerCheck& check);

}  // namespace rocking

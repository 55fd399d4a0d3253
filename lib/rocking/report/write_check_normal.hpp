#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/stats/normal_check.hpp"

namespace rocking::report {

/// Value of `format` in what `rocking check-normal --json` prints.
inline constexpr std::string_view check_normal_format = "rocking.check_normal/1";

/// A sampler's sample beside the law that it promises.
struct SamplerCheck {
  std::string sampler;  ///< `box-muller`, ...
  std::uint64_t seed = 0;
  stats::NormalCheck found;
};

[[nodiscard]] std::string check_normal_text(const SamplerCheck& check);

/// The same for a reader at a terminal.
[[nodiscard]] std::string check_normal_summary(const SamplerCheck& check);

}  // namespace rocking::report

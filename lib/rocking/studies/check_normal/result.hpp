#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/fields/document.hpp"
#include "rocking/stats/normal_check.hpp"
#include "rocking/studies/check_normal/check_sampler.hpp"

namespace rocking {

/// The check of a sampler against its law.
struct SamplerCheck {
  std::optional<std::string> distribution;  ///< `lognormal`, `uniform`; absent: normal
  std::string sampler;                      ///< `box-muller`, ...
  std::uint64_t seed = 0;
  stats::NormalCheck found;
};

[[nodiscard]] SamplerCheck sampler_check(const SamplerQuestion& question, const stats::NormalCheck& found);

[[nodiscard]] const StructType& fields_of(const SamplerCheck*);

/// The output of `rocking check-normal --json`.
[[nodiscard]] const DocumentOf<SamplerCheck>& check_normal_document();

}  // namespace rocking

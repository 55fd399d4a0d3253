#pragma once

#include <cstdint>
#include <string>

#include "rocking/fields/document.hpp"
#include "rocking/stats/normal_check.hpp"

namespace rocking {

/// The check of a sampler against its law.
struct SamplerCheck {
  std::string sampler;  ///< `box-muller`, ...
  std::uint64_t seed = 0;
  stats::NormalCheck found;
};

[[nodiscard]] const StructType& fields_of(const SamplerCheck*);

/// The output of `rocking check-normal --json`.
[[nodiscard]] const DocumentOf<SamplerCheck>& check_normal_document();

}  // namespace rocking

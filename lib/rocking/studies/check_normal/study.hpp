#pragma once

#include <optional>

#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/studies/check_normal/question.hpp"
#include "rocking/study/study.hpp"

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

/// The check as text for a terminal.
[[nodiscard]] std::string check_normal_summary(const SamplerCheck& check);

[[nodiscard]] const StructType& fields_of(const SamplerQuestion*);

[[nodiscard]] const Study& check_normal_study();

}  // namespace rocking

namespace rocking::analysis {

/// The figure `normal_histogram` of a check of random numbers: counts and the curve of the normal distribution, as in
/// Fig. 2 of Jeong and Yang (2012).
[[nodiscard]] Figure normal_histogram(const SamplerCheck& check);

}  // namespace rocking::analysis

#pragma once

#include <optional>
#include <string_view>

#include "rocking/studies/check_normal/question.hpp"

namespace rocking {

/// Whether a sampler has this name.
[[nodiscard]] bool is_sampler(std::string_view name);

/// The numbers that a simulation would draw, scaled to the law, and their neighbours. Absent if sigma is too small to give
/// two different numbers. Precondition: is_sampler, n >= 20, and a positive mean
/// of a lognormal distribution.
[[nodiscard]] std::optional<stats::NormalCheck> check_sampler(const SamplerQuestion& question);

}  // namespace rocking

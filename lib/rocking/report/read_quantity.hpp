#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/object_reader.hpp"

namespace rocking::report {

/// A number or a law: `0.1`, `{"uniform": [a, b]}` or `{"normal": {"mean": m, "sigma": s}}`; 0 where the key is absent.
/// `rule` bounds the number, both ends of the interval, and the mean.
[[nodiscard]] experiment::Quantity read_quantity(ObjectReader& in, std::string_view key, const NumberRule& rule);

/// Mean of the law; the number itself where it is one.
[[nodiscard]] double mean_of(const experiment::Quantity& quantity);

/// 64 bits in decimal, or in hexadecimal after `0x`; absent where the text is neither.
[[nodiscard]] std::optional<std::uint64_t> seed_from_text(std::string_view text);

/// `0x2012`: how a seed is written everywhere, since not every program reads 64 bits from a JSON number.
[[nodiscard]] std::string seed_text(std::uint64_t seed);

}  // namespace rocking::report

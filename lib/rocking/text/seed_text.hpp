#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocking {

/// 64 bits in decimal, or in hexadecimal after `0x`; absent if the text is neither.
[[nodiscard]] std::optional<std::uint64_t> seed_from_text(std::string_view text);

/// `0x2012`. Seeds are always written as text, because some programs cannot read 64 bits from a JSON number.
[[nodiscard]] std::string seed_text(std::uint64_t seed);

}  // namespace rocking

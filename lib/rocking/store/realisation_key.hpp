#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace rocking {

/// Identifies one realisation of one condition; both numbers count from 0.
struct RealisationKey {
  std::uint64_t condition = 0;
  std::uint64_t realisation = 0;

  friend auto operator<=>(const RealisationKey&, const RealisationKey&) = default;
};

[[nodiscard]] inline std::string text_of(const RealisationKey& key) {
  return "condition " + std::to_string(key.condition) + ", realisation " + std::to_string(key.realisation);
}

/// One of the parts into which an experiment is divided.
struct Shard {
  std::uint64_t part = 1;  ///< from 1 to `parts`
  std::uint64_t parts = 1;

  friend bool operator==(const Shard&, const Shard&) = default;

  /// Whether the work item with this number, counted from 0 over the whole experiment, belongs to this part.
  [[nodiscard]] bool has(std::uint64_t number) const { return number % parts == part - 1; }
};

}  // namespace rocking

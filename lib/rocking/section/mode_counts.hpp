#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/section/response_mode.hpp"

namespace rocking::section {

/// Numbers of windows, or of anything else, by response mode; none is 0.
class ModeCounts {
 public:
  std::uint64_t& operator[](const ResponseMode& mode) { return counts_[mode]; }
  [[nodiscard]] auto begin() const { return counts_.begin(); }
  [[nodiscard]] auto end() const { return counts_.end(); }
  [[nodiscard]] std::uint64_t total() const;

  friend bool operator==(const ModeCounts&, const ModeCounts&) = default;

 private:
  std::map<ResponseMode, std::uint64_t> counts_;
};

/// `(1,1)=5 chaotic=12`: the modes in their order, separated by a space; empty without counts.
[[nodiscard]] std::string to_string(const ModeCounts& counts);

/// The counts that to_string writes so; absent for any other text.
[[nodiscard]] std::optional<ModeCounts> mode_counts_named(std::string_view text);

}  // namespace rocking::section

#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rocking::section {

/// Kind of the long-time motion of a realisation.
enum class ResponseKind : std::uint8_t { periodic, quasi_periodic, chaotic, overturned, slide, rest, unresolved };

/// Class of a response; (m, n) if it is periodic.
struct ResponseMode {
  ResponseKind kind = ResponseKind::unresolved;
  int rocks = 0;    ///< m: pairs of impacts in n periods; 0 unless periodic
  int periods = 0;  ///< n: excitation periods until the response repeats; 0 unless periodic

  /// Order in tables: periodic by n, then by m; then quasi-periodic, chaotic, overturned, slide, rest, unresolved.
  friend std::strong_ordering operator<=>(const ResponseMode& a, const ResponseMode& b) {
    if (const auto by_kind = a.kind <=> b.kind; by_kind != 0) return by_kind;
    if (const auto by_periods = a.periods <=> b.periods; by_periods != 0) return by_periods;
    return a.rocks <=> b.rocks;
  }
  friend bool operator==(const ResponseMode&, const ResponseMode&) = default;
};

[[nodiscard]] constexpr ResponseMode periodic(int rocks, int periods) {
  return {ResponseKind::periodic, rocks, periods};
}

/// `(1,3)`, `quasi-periodic`, `chaotic`, `overturned`, `slide`, `rest` or `unresolved`.
[[nodiscard]] std::string to_string(const ResponseMode& mode);

/// What a block does with a response of this kind: `overturns`; empty if it is periodic, where the numbers say it.
[[nodiscard]] std::string_view meaning_of(ResponseKind kind);

/// The mode with this name; absent if there is none.
[[nodiscard]] std::optional<ResponseMode> response_mode_named(std::string_view name);

/// The names of the modes that are not periodic, for messages: `quasi-periodic, chaotic, overturned, slide, rest, unresolved`.
[[nodiscard]] std::string response_mode_words();

/// Regular expression of the names, for schemas.
[[nodiscard]] std::string response_mode_pattern();

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

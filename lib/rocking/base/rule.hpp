#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rocking {

/// What a value in a document must be, beside its type: bounds of a number, or the texts that may stand there. Of one that
/// people write also how to say so.
struct Rule {
  std::optional<double> least = {};                ///< inclusive
  std::optional<double> above = {};                ///< exclusive
  std::optional<double> most = {};                 ///< inclusive
  std::optional<double> below = {};                ///< exclusive
  std::span<const std::string_view> choices = {};  ///< of a text; empty: any
  std::string_view demand = {};                    ///< `must be ...`; a whole number needs none
  std::string_view example = {};                   ///< JSON text of a value that would do

  /// Of a value that is not a number: only without bounds.
  [[nodiscard]] constexpr bool allows(double number) const {
    return !(least && !(number >= *least)) && !(above && !(number > *above)) && !(most && !(number <= *most)) &&
           !(below && !(number < *below));
  }
  [[nodiscard]] std::string remedy() const { return "give a value such as " + std::string(example); }
};

namespace rule {

inline constexpr Rule none{};
inline constexpr Rule not_negative{.least = 0.0};
inline constexpr Rule positive{.above = 0.0};
inline constexpr Rule share{.least = 0.0, .most = 1.0};
inline constexpr Rule difference_of_shares{.least = -1.0, .most = 1.0};
inline constexpr Rule confidence{.above = 0.0, .below = 1.0};

}  // namespace rule
}  // namespace rocking

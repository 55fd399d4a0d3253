#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/harmonic.hpp"
#include "rocking/dynamics/excitation/pulse.hpp"
#include "rocking/dynamics/excitation/recorded.hpp"

namespace rocking::dynamics {

/// How the base of one realisation moves: one of the kinds. Offers what each of them does (see BaseExcitation).
class Excitation {
 public:
  using Kinds = std::variant<HarmonicExcitation<false>, RecordedExcitation<false>, RecordedExcitation<true>,
                             PulseExcitation, HarmonicExcitation<true>>;

  Excitation() = default;
  template <BaseExcitation Kind>
  Excitation(Kind kind) : kind_(std::move(kind)) {}

  /// Calls use(kind) with the kind that it is.
  template <class Use>
  decltype(auto) visit(Use&& use) {
    return std::visit(std::forward<Use>(use), kind_);
  }
  template <class Use>
  decltype(auto) visit(Use&& use) const {
    return std::visit(std::forward<Use>(use), kind_);
  }

  [[nodiscard]] bool is_periodic() const {
    return visit([]<class Kind>(const Kind&) { return Kind::is_periodic; });
  }
  [[nodiscard]] bool has_vertical() const {
    return visit([]<class Kind>(const Kind&) { return Kind::has_vertical; });
  }
  [[nodiscard]] bool has_knots() const {
    return visit([]<class Kind>(const Kind&) { return Kind::has_knots; });
  }
  /// Its place among the kinds.
  [[nodiscard]] std::size_t index() const { return kind_.index(); }
  [[nodiscard]] double unit(const Geometry& block) const {
    return visit([&](const auto& kind) { return kind.unit(block); });
  }
  [[nodiscard]] double horizontal(const Clock& clock, double amplitude) const {
    return visit([&](const auto& kind) { return kind.horizontal(clock, amplitude); });
  }
  [[nodiscard]] double most_horizontal(double amplitude) const {
    return visit([&](const auto& kind) { return kind.most_horizontal(amplitude); });
  }
  [[nodiscard]] double weight(const Clock& clock) const {
    return visit([&](const auto& kind) { return kind.weight(clock); });
  }
  [[nodiscard]] std::optional<Instant> next_change(const Clock& clock) const {
    return visit([&](const auto& kind) { return kind.next_change(clock); });
  }
  /// Largest abs(alpha) from now to the next change; infinite for a kind that does not offer it.
  [[nodiscard]] double largest_before_change(const Clock& clock, double amplitude) const {
    return visit([&](const auto& kind) {
      if constexpr (requires { kind.largest_before_change(clock); }) {
        return std::abs(amplitude) * kind.largest_before_change(clock);
      } else {
        return std::numeric_limits<double>::infinity();
      }
    });
  }
  /// The coming samples of a ground motion up to which abs(alpha) stays below `bound`, at most `most` and clearly before
  /// `limit`; none for a kind that does not offer them. Some may be left out.
  [[nodiscard]] SamplesPassed samples_below(double bound, double amplitude, const Instant& limit, std::size_t most,
                                            const Clock& clock) const {
    return visit([&](const auto& kind) -> SamplesPassed {
      if constexpr (requires { kind.samples_below(bound, limit, most, clock); }) {
        return kind.samples_below(bound / std::abs(amplitude), limit, most, clock);
      } else {
        return {};
      }
    });
  }

 private:
  Kinds kind_;
};

inline constexpr std::size_t excitation_kinds = std::variant_size_v<Excitation::Kinds>;

/// Of the kinds' pieces.
inline constexpr std::size_t most_piece_numbers = []<class... Kinds>(std::variant<Kinds...>*) {
  return std::max({Kinds::piece_numbers...});
}(static_cast<Excitation::Kinds*>(nullptr));

}  // namespace rocking::dynamics

#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/harmonic.hpp"
#include "rocking/dynamics/excitation/recorded.hpp"

namespace rocking::dynamics {

/// How the base of one realisation moves: one of the kinds. Offers what each of them does (see BaseExcitation).
class Excitation {
 public:
  using Kinds = std::variant<HarmonicExcitation, RecordedExcitation<false>, RecordedExcitation<true>>;

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
  [[nodiscard]] bool runs_in_lanes() const {
    return visit([]<class Kind>(const Kind&) { return Kind::runs_in_lanes; });
  }
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
  [[nodiscard]] std::uint64_t segments_looked_up() const {
    return visit([](const auto& kind) { return kind.segments_looked_up(); });
  }

 private:
  Kinds kind_;
};

}  // namespace rocking::dynamics

#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"

namespace rocking::support {

/// A source of coefficients that returns chosen values in order and counts the calls. The last value of a list is
/// repeated.
struct ScriptedCoefficients {
  double amplitude_value = 0.0;
  std::vector<double> statics{};                 ///< mu_s at the start, after the first stop, ...; none: no friction
  std::optional<double> static_after_chatter{};  ///< mu_s after the end of a chatter
  std::vector<double> kinetics{0.0};             ///< mu_k at the start, after the first change, ...
  bool hold_kinetic = true;                      ///< limit mu_k to mu_s, as every source should
  std::vector<dynamics::Instant> changes{};      ///< of kinetic friction, in order
  std::vector<double> restitutions{0.0};         ///< e of the first impact, the second, ...

  std::size_t stops = 0;
  std::size_t chatters = 0;
  std::size_t impacts = 0;

  [[nodiscard]] bool has_friction() const { return !statics.empty(); }
  [[nodiscard]] double static_friction() const {
    if (!has_friction()) return std::numeric_limits<double>::infinity();
    if (chatters > 0 && static_after_chatter) return *static_after_chatter;
    return at(statics, stops);
  }
  [[nodiscard]] double kinetic_friction(const dynamics::Clock& clock) const {
    const double wanted = at(kinetics, changes_reached(clock));
    return hold_kinetic ? std::min(wanted, static_friction()) : wanted;
  }
  [[nodiscard]] double restitution(double) { return at(restitutions, impacts++); }
  [[nodiscard]] double amplitude(const dynamics::Clock&) const { return amplitude_value; }
  void stop() { ++stops; }
  void chatter_ended() { ++chatters; }
  [[nodiscard]] std::optional<dynamics::Instant> next_change(const dynamics::Clock& clock, bool slipping) const {
    const std::size_t reached = changes_reached(clock);
    if (!slipping || reached == changes.size()) return std::nullopt;
    return changes[reached];
  }

 private:
  [[nodiscard]] static double at(const std::vector<double>& values, std::size_t index) {
    return values[std::min(index, values.size() - 1)];
  }
  [[nodiscard]] std::size_t changes_reached(const dynamics::Clock& clock) const {
    std::size_t reached = 0;
    while (reached < changes.size() && clock.until(changes[reached]) <= clock.resolution()) ++reached;
    return reached;
  }
};

static_assert(dynamics::CoefficientSource<ScriptedCoefficients>);

}  // namespace rocking::support

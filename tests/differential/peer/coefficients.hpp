#pragma once

#include <cstdint>

#include "differential/peer/scene.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::peer {

/// Friction, restitution and amplitude as they fluctuate: lib/docs/model.md, section 5.
class Coefficients {
 public:
  explicit Coefficients(const Scene& scene);

  /// mu_s in force and, of the grid's interval `interval`, mu_k.
  [[nodiscard]] Friction friction(std::int64_t interval) const;
  [[nodiscard]] double amplitude(std::int64_t period) const;
  [[nodiscard]] double next_restitution();
  void stopped();
  void chatter_ended();

 private:
  [[nodiscard]] double drawn(double mean, double sigma, random::Source source, std::uint64_t index) const;
  void draw_static();

  Scene scene_;
  random::Draws draws_;
  std::uint64_t chatters_ = 0;
  std::uint64_t stops_ = 0;    ///< since the last chatter's end
  std::uint64_t impacts_ = 0;  ///< since the last chatter's end
  double mu_s_ = 0.0;
};

}  // namespace rocking::peer

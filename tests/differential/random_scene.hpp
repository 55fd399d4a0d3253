#pragma once

#include <cstdint>

#include "differential/peer/scene.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking::differential {

/// A question for both implementations.
struct Question {
  Condition condition;
  std::uint64_t seed;
  std::uint64_t realisation;
  std::int64_t periods;
};

/// The question with this number, the same on every machine.
[[nodiscard]] Question random_question(std::uint64_t number);
/// The same about a block with its mass off the middle.
[[nodiscard]] Question random_general_question(std::uint64_t number);
/// A block with its mass off the middle, which cannot slip, at rest before one cycle of a sine of the base.
[[nodiscard]] Question random_pulse_question(std::uint64_t number);

/// A block at a wall, under a sine, perhaps with a vertical one, under one cycle of a sine, or under a broken line.
[[nodiscard]] Question random_wall_question(std::uint64_t number);

/// A_h of the excitation, or the scale of a record.
[[nodiscard]] Quantity& amplitude_of(rocking::Scene& scene);

/// The question in the form that the peer takes.
[[nodiscard]] peer::Scene peer_scene(const Question& question);

}  // namespace rocking::differential

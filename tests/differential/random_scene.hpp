#pragma once

#include <cstdint>

#include "differential/peer/scene.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::differential {

/// A question that both sides can be asked.
struct Question {
  experiment::Condition condition;
  std::uint64_t seed;
  std::uint64_t realisation;
  std::int64_t periods;
};

/// The same question for the same number, everywhere.
[[nodiscard]] Question random_question(std::uint64_t number);

/// The question in the peer's words.
[[nodiscard]] peer::Scene peer_scene(const Question& question);

}  // namespace rocking::differential

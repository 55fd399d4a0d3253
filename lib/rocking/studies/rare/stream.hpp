#pragma once

#include <cstdint>

#include "rocking/base/error.hpp"

namespace rocking::rare {

/// Which random numbers: those of one move of one particle of one stage of one repetition (0: the pilot run).
struct Stream {
  std::uint64_t repetition = 0;
  std::uint64_t stage = 0;
  std::uint64_t particle = 0;
  std::uint64_t move = 0;
};

inline constexpr std::uint64_t stage_limit = std::uint64_t{1} << 9U;
inline constexpr std::uint64_t particle_limit = std::uint64_t{1} << 17U;
inline constexpr std::uint64_t move_limit = std::uint64_t{1} << 9U;
inline constexpr std::uint64_t repetition_limit = std::uint64_t{1} << 20U;
/// No particle has this number: what a stage draws by itself.
inline constexpr std::uint64_t last_particle = particle_limit - 1;

/// The realisation number of a stream (lib/docs/draws.md): bit 55 is set, which no realisation of a run has in
/// practice; below it 20 bits of the repetition, 9 of the stage, 17 of the particle, 9 of the move.
[[nodiscard]] constexpr std::uint64_t number_of(const Stream& stream) {
  ROCKING_EXPECT(stream.repetition < repetition_limit && stream.stage < stage_limit);
  ROCKING_EXPECT(stream.particle < particle_limit && stream.move < move_limit);
  return std::uint64_t{1} << 55U | stream.repetition << 35U | stream.stage << 26U | stream.particle << 9U | stream.move;
}

}  // namespace rocking::rare

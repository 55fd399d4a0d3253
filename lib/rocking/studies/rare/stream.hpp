#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"

namespace rocking::rare {

/// Thrown by a computation that is not finished when the time of the study is up.
class TimeIsUp : public base::Stopped {};

/// What ends the work of a study: a request, or a time. Used by several threads.
class Halt {
 public:
  Halt() = default;
  /// `seconds` on the clock of `elapsed_seconds`; absent: no limit.
  Halt(base::StopRequest stop, std::function<double()> elapsed_seconds, std::optional<double> seconds)
      : stop_(stop), elapsed_seconds_(std::move(elapsed_seconds)), seconds_(seconds) {}

  /// Time since the start of the study [s]; 0 without a limit.
  [[nodiscard]] double elapsed() const { return seconds_ ? elapsed_seconds_() : 0.0; }
  /// Whether `share` of the time does not suffice for `needed` more seconds.
  [[nodiscard]] bool ends_within(double needed, double share) const {
    return seconds_ && elapsed_seconds_() + needed >= share * *seconds_;
  }
  /// Throws Stopped if the request has been made, TimeIsUp at the end of the time.
  void check() const {
    stop_.check();
    if (ends_within(0.0, 1.0)) throw TimeIsUp();
  }
  /// The request alone, which costs less.
  void check_request() const { stop_.check(); }

 private:
  base::StopRequest stop_;
  std::function<double()> elapsed_seconds_;
  std::optional<double> seconds_;
};

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

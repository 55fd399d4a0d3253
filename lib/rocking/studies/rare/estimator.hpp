#pragma once

#include "rocking/studies/rare/block_paths.hpp"

namespace rocking::rare {

/// Unbiased, independent estimates of one probability. It may be used by several threads.
class Estimator {
 public:
  /// What was found out before the first repetition.
  struct Pilot {
    std::vector<double> levels;   ///< of the search for the event, rising
    std::vector<double> reached;  ///< share of the particles at each, and the event last
    bool found_event = true;
    double work = 0.0;  ///< simulated time, in realisations to the horizon
  };

  Estimator() = default;
  Estimator(const Estimator&) = delete;
  Estimator& operator=(const Estimator&) = delete;
  virtual ~Estimator() = default;

  [[nodiscard]] virtual RareMethod method() const = 0;
  [[nodiscard]] virtual const Pilot& pilot() const = 0;
  /// The trajectories with the event of a repetition, with weights whose sum is in proportion to its estimate.
  [[nodiscard]] virtual std::vector<KeptPath> paths_of(std::uint64_t repetition) const = 0;
  [[nodiscard]] virtual std::optional<CommittorMap> committor() const { return std::nullopt; }
  /// Number 1 and up, below most_repetitions. Throws as Halt::check.
  [[nodiscard]] virtual Repetition repeat(std::uint64_t repetition) const = 0;
};

/// More are never made; numbers from here on belong to pilot runs.
inline constexpr std::uint64_t most_repetitions = 20'000;

/// That before the pilot runs.
[[nodiscard]] RareMethod method_of(const Scene& scene);

/// The estimator for these paths, with this number of particles, after its pilot runs. The paths must outlive it.
/// Throws as Halt::check.
[[nodiscard]] std::unique_ptr<Estimator> estimator_of(const BlockPaths& paths, std::size_t particles, unsigned threads);

}  // namespace rocking::rare

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/ensemble/stopping.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/realisation_key.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Work item: a realisation with an even number and the next one, of one condition. The two are compared while the
/// strobe points of both are in memory.
struct Pair {
  std::size_t condition = 0;
  std::uint64_t first = 0;
};

/// Tolerance of the reruns with common random numbers, which separate the effect of arithmetic from that of random
/// friction: a hundred times tighter, but at least 1e-16.
[[nodiscard]] double rerun_tolerance(double tolerance);

/// The work that remains of an experiment or of a shard.
class WorkList {
 public:
  WorkList(const Experiment& experiment, const std::optional<Shard>& shard);

  /// Marks a realisation as finished.
  void mark_done(const RealisationKey& key);
  /// Whether all realisations up to the target of the condition are finished and the target is not final.
  [[nodiscard]] bool wants_look(std::size_t condition) const;
  [[nodiscard]] const Target& target(std::size_t condition) const { return conditions_[condition].target; }
  void set_target(std::size_t condition, const Target& target);

  /// The next pair that is neither finished nor taken; absent if there is none at present.
  [[nodiscard]] std::optional<Pair> take();

  [[nodiscard]] std::uint64_t all() const { return all_; }  ///< realisations up to the targets, including finished ones
  [[nodiscard]] std::uint64_t done() const { return done_; }  ///< finished ones of these
  [[nodiscard]] bool is_complete() const;
  /// Realisations up to the targets that are not finished, in order.
  [[nodiscard]] std::vector<RealisationKey> missing() const;

 private:
  struct PerCondition {
    Target target;
    std::uint64_t first_pair = 0;  ///< number of its first pair within the experiment
    std::uint64_t next = 0;        ///< first realisation that was not taken
    std::uint64_t done_count = 0;
    std::vector<bool> done;  ///< by realisation, up to the target
  };
  [[nodiscard]] bool is_ours(const RealisationKey& key) const;
  [[nodiscard]] bool is_done(const Pair& pair) const;
  [[nodiscard]] std::optional<Pair> take_from(std::size_t condition);

  std::optional<Shard> shard_;
  std::vector<PerCondition> conditions_;
  std::size_t first_open_ = 0;  ///< all conditions before it have final targets and no pairs left
  std::uint64_t all_ = 0;
  std::uint64_t done_ = 0;
};

}  // namespace rocking

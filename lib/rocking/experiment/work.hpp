#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/shard.hpp"
#include "rocking/experiment/stopping.hpp"
#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// A realisation of even number and the next one, of one condition: the unit of work. The two are compared while both
/// strobe records are at hand.
struct Pair {
  std::size_t condition = 0;
  std::uint64_t first = 0;
};

/// The tolerance at which some of the realisations are repeated, with the same draws, to tell what arithmetic does from
/// what friction does: a hundred times tighter, but not below 1e-16.
[[nodiscard]] double repeat_tolerance(double tolerance);

/// How many realisations a condition will really run, at most: one, where nothing is drawn at random.
[[nodiscard]] std::uint64_t effective_realisations(const Condition& condition);

/// What is still to be done of an experiment, or of a shard of it.
class WorkList {
 public:
  WorkList(const Experiment& experiment, const std::optional<Shard>& shard);

  /// Counts a realisation as done before.
  void mark_done(const RealisationKey& key);
  /// Whether all realisations up to the condition's target are done, and the target is not final: time to look.
  [[nodiscard]] bool wants_look(std::size_t condition) const;
  [[nodiscard]] const Target& target(std::size_t condition) const { return conditions_[condition].target; }
  void set_target(std::size_t condition, const Target& target);

  /// The next pair that is not done and was not given out; absent if there is none for now.
  [[nodiscard]] std::optional<Pair> take();

  [[nodiscard]] std::uint64_t all() const {
    return all_;
  }  ///< realisations up to the targets, with those that are done
  [[nodiscard]] std::uint64_t done() const { return done_; }  ///< of them
  [[nodiscard]] bool is_complete() const;
  /// Realisations up to the targets that are not done, in their order.
  [[nodiscard]] std::vector<RealisationKey> missing() const;

 private:
  struct PerCondition {
    Target target;
    std::uint64_t first_pair = 0;  ///< number of its first pair in the experiment
    std::uint64_t next = 0;        ///< first realisation that was not given out
    std::uint64_t done_count = 0;
    std::vector<bool> done;  ///< by realisation, up to the target
  };
  [[nodiscard]] bool is_ours(const RealisationKey& key) const;
  [[nodiscard]] bool is_done(const Pair& pair) const;
  [[nodiscard]] std::optional<Pair> take_from(std::size_t condition);

  std::optional<Shard> shard_;
  std::vector<PerCondition> conditions_;
  std::size_t first_open_ = 0;  ///< before it, all is given out and every target final
  std::uint64_t all_ = 0;
  std::uint64_t done_ = 0;
};

}  // namespace rocking::experiment

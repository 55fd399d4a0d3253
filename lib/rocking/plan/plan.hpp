#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking {

/// Largest disk space and memory that a run needs at a time, estimated to within a factor of 1.5 for runs of a megabyte
/// and more (reports/evidence/scale.md).
struct Needs {
  std::uint64_t disk_bytes = 0;
  std::uint64_t memory_bytes = 0;
};

/// Options of a run that its needs depend on.
struct Means {
  unsigned threads = 1;
  std::optional<Shard> shard;
  std::uint64_t stored = 0;  ///< realisations whose rows are on the disk already
  bool page = true;          ///< whether the page is drawn
};

[[nodiscard]] Needs needs_of(const Experiment& experiment, const Means& means);

/// Longest time that a sample for an estimate takes [s].
inline constexpr double longest_sample_s = 2.0;

/// Measured speed of a run, from a sample of its realisations.
struct TimeEstimate {
  double seconds = 0.0;            ///< that the run will take, by wall clock
  std::uint64_t realisations = 0;  ///< of the sample
  double horizon_share = 1.0;      ///< share of their periods that the sample ran; 1: all
  /// Realisations of the sample that were unresolved; absent if it had shorter horizons.
  std::optional<std::uint64_t> unresolved = std::nullopt;
};

/// What a measurement of speed takes from its caller.
struct Sampling {
  std::function<double()> elapsed_seconds;  ///< wall-clock time since some instant [s]; called by two threads
  base::StopRequest stop = {};
};

/// Runs a sample of the pairs of realisations, with reruns and label checks, on as many threads as the run will have,
/// for at most `longest_sample_s`, and extrapolates by the number of periods. The sample is spread evenly over the
/// conditions. If full horizons take too long, the sample has shorter ones. Absent if not even the shortest sample was
/// finished in that time, or if it is asked to stop. With `until` the estimate is that of the largest number of
/// realisations; with `until_classified` it is that of the fixed horizon.
[[nodiscard]] std::optional<TimeEstimate> estimate_time(const Experiment& experiment, const Means& means,
                                                        const Sampling& sampling);

/// Size of a run before it starts.
struct Plan {
  std::string title;
  std::uint64_t conditions = 0;
  std::uint64_t realisations = 0;   ///< of all conditions
  bool at_most = false;             ///< some conditions may stop earlier
  std::uint64_t periods = 0;        ///< of all realisations together
  std::uint64_t most_periods = 0;   ///< the same if every realisation goes on to its limit; `periods` without a limit
  std::uint64_t least_periods = 0;  ///< the same if each is classified at once: with the windows that hold and watch it
  bool has_record = false;          ///< periods are those of the strobe, not of an excitation
  Needs needs;
  std::optional<TimeEstimate> time;  ///< absent: not measured, or not to be had
  std::vector<std::string> effects;  ///< that are on in at least one condition
  std::vector<std::string> omitted;  ///< effects that are off in every condition
  std::string impacts;               ///< what they leave of the tilt rate, in a sentence
  std::string thresholds;            ///< of uplift and of sliding, in sentences
};

/// The plan of a run without its time.
[[nodiscard]] Plan plan_of(const Experiment& experiment, const Means& means);

/// Time [s] if this share of the realisations goes on to its limit and the others are classified at once. The time of the
/// plan is known.
[[nodiscard]] double seconds_if_continued(const Plan& plan, double share);

/// Clamps of the first random numbers of some realisations of a condition.
struct SampledClamps {
  std::size_t condition = 0;
  std::uint64_t realisations = 0;
  Clamps clamps = {};
};

/// What the laws of an experiment clamp, before it is run: of realisations 0, 1, ... what they draw at the start and the
/// first number of each source along the way. Of the conditions that draw, and of at most a hundred, evenly spread.
[[nodiscard]] std::vector<SampledClamps> sample_clamps(const Experiment& experiment);

/// From which base acceleration a block lifts, and below which friction it slides at rest, in an impact and when it begins to
/// rock: sentences for the mean blocks and the mean friction of all conditions (lib/docs/model.md, sections 3 and 4).
[[nodiscard]] std::string thresholds_text(const Experiment& experiment);

/// The least scale of the motion at which a block leaves full contact by rocking if it cannot slide: abs(alpha) reaches
/// tan(psi) (1 + alpha_v) at some sample, `tangents` being those of the left and of the right edge. Absent if no scale does.
[[nodiscard]] std::optional<double> least_uplift_scale(const std::vector<dynamics::GroundMotionSample>& samples,
                                                       const std::array<double, 2>& tangents);

/// The least intensity at which the excitation of a scene lifts a block that is at rest: abs(alpha) reaches
/// tan(psi) (1 + alpha_v) at some instant, for the most slender block that the scene may draw. `intensity`: that of the
/// scene, > 0, a multiple of its accelerations.
///
/// Friction does not lower it: a block that slides because the static coefficient is below tan(psi) does not tip, since
/// kinetic friction is limited to the static friction in force. Infinite where no intensity lifts the block. Absent where
/// none is known: the block does not start at rest, or the amplitude is random.
[[nodiscard]] std::optional<double> least_uplift(const Scene& scene, double intensity);

/// Least intensity at which it lifts the block, or makes it slide: abs(alpha) reaches the static friction times
/// (1 + alpha_v). Absent also where friction may be drawn as small as one likes.
[[nodiscard]] std::optional<double> least_sliding(const Scene& scene, double intensity);

/// Transient and sampled periods in proportion; at least one sampled period.
[[nodiscard]] Horizon shortened(const Horizon& horizon, double share);

}  // namespace rocking

#include "rocking/studies/plan/needs.hpp"

#include <algorithm>

#include "rocking/ensemble/work_list.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/period.hpp"

namespace rocking {
namespace {

// Bytes, measured with 10^4 and 10^5 conditions (lib/docs/scale.md).
constexpr std::uint64_t page = 450'000;          ///< without what grows with the conditions
constexpr std::uint64_t row = 200;               ///< of the store; 155 to 270
constexpr std::uint64_t reported_alone = 6'900;  ///< in the report, of a condition of one realisation
/// Of one of several, which has more response modes and a non-recurrence.
constexpr std::uint64_t reported_together = 10'300;
constexpr std::uint64_t drawn_alone = 1'400;  ///< on the page
constexpr std::uint64_t drawn_together = 2'400;
constexpr std::uint64_t program_itself = 15'000'000;  ///< in memory
constexpr std::uint64_t kept_alone = 7'700;           ///< in memory, of a condition of one realisation
constexpr std::uint64_t kept_together = 13'500;
constexpr std::uint64_t kept_in_shard = 700;  ///< a shard makes no report

std::uint64_t parameters_in(const Condition& condition) {
  constexpr std::uint64_t spaces_and_quotes = 14;
  std::uint64_t bytes = 0;
  for (const Parameter& parameter : condition.parameters) {
    bytes += parameter.pointer.size() + parameter.value.size() + spaces_and_quotes;
  }
  return bytes;
}

/// Memory of the strobe points of realisations in progress.
std::uint64_t strobe_points(const Experiment& experiment, std::uint64_t realisations, unsigned threads) {
  constexpr std::uint64_t a_point =
      sizeof(section::Period) + sizeof(section::StrobePoint);  // in progress, and in its result
  std::uint64_t longest = 0;
  for (const Condition& condition : experiment.conditions) {
    const auto transient = condition.horizon.transient_periods;
    const auto sampled = condition.horizon.sampled_periods;
    const std::uint64_t longer = condition.label_check ? condition.label_check->times_longer : 1;
    longest = std::max(longest, static_cast<std::uint64_t>(transient) + static_cast<std::uint64_t>(sampled) * longer);
  }
  const auto side_by_side = 6 * static_cast<std::uint64_t>(lanes::available_kernels().back().lanes) + 2;
  return longest * a_point * std::min(realisations, threads * side_by_side);
}

}  // namespace

Needs needs_of(const Experiment& experiment, const Means& means) {
  Needs needs{.disk_bytes = page, .memory_bytes = program_itself};
  std::uint64_t rows = 0;
  for (const Condition& condition : experiment.conditions) {
    const std::uint64_t realisations = effective_realisations(condition);
    rows += realisations;
    if (means.shard) {
      needs.memory_bytes += kept_in_shard;
      continue;
    }
    const bool alone = realisations == 1;
    needs.disk_bytes +=
        (alone ? reported_alone + drawn_alone : reported_together + drawn_together) + parameters_in(condition);
    needs.memory_bytes += (alone ? kept_alone : kept_together) + 2 * parameters_in(condition);
  }
  if (means.shard) rows = (rows + means.shard->parts - 1) / means.shard->parts;
  needs.disk_bytes += row * (rows - std::min(rows, means.stored));
  needs.memory_bytes += strobe_points(experiment, rows, means.threads);
  return needs;
}

}  // namespace rocking

#include "rocking/plan/plan.hpp"

#include <algorithm>

#include "rocking/ensemble/work_list.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t row = 200;                    ///< bytes of the store; 155 to 270
constexpr std::uint64_t page_itself = 450'000;        ///< bytes of the page, without what grows with the conditions
constexpr std::uint64_t program_itself = 15'000'000;  ///< bytes of memory
constexpr std::uint64_t kept_in_shard = 700;          ///< bytes of memory of a condition; a shard makes no report

/// Bytes of a condition, measured with 10^3 to 10^5 conditions (reports/evidence/scale.md).
struct PerCondition {
  std::uint64_t at_least;
  std::uint64_t of_several;    ///< more, of several realisations: they have more response modes and a non-recurrence
  std::uint64_t with_sliding;  ///< more, where the block can slide

  [[nodiscard]] std::uint64_t bytes(const Condition& condition) const {
    return at_least + (effective_realisations(condition) > 1 ? of_several : 0) +
           (condition.scene.friction ? with_sliding : 0);
  }
};
constexpr PerCondition reported{.at_least = 6'600, .of_several = 1'100, .with_sliding = 2'500};
constexpr PerCondition drawn_shaking{.at_least = 1'300, .of_several = 1'300, .with_sliding = 1'500};
constexpr PerCondition kept_for_report{.at_least = 7'700, .of_several = 1'300, .with_sliding = 2'100};
constexpr PerCondition kept_for_page{.at_least = 6'500, .of_several = 4'500, .with_sliding = 7'000};

std::uint64_t bytes_of(const SweptValue& value) {
  constexpr std::uint64_t digits = 4;  // of most numbers
  if (const auto* word = std::get_if<std::string>(&value)) return word->size() + 2;
  if (const auto* part = std::get_if<WrittenPart>(&value)) return part->text.size();
  return digits;
}

std::uint64_t parameters_in(const Condition& condition) {
  constexpr std::uint64_t spaces_and_quotes = 14;
  std::uint64_t bytes = 0;
  for (const Parameter& parameter : condition.parameters) {
    bytes += parameter.pointer.size() + bytes_of(parameter.value) + spaces_and_quotes;
  }
  return bytes;
}

/// Memory of the strobe points of realisations in progress.
std::uint64_t strobe_points(const Experiment& experiment, std::uint64_t realisations, unsigned threads) {
  constexpr std::uint64_t a_point =
      sizeof(section::Period) + sizeof(section::StrobePoint);  // in progress, and in its result
  std::uint64_t longest = 0;
  for (const Condition& condition : experiment.conditions) {
    longest = std::max(longest, static_cast<std::uint64_t>(condition.horizon.periods()));
  }
  // Which kernel is the fastest is measured, and may differ from run to run: the widest needs the most.
  const int widest = std::ranges::max(lanes::available_kernels(), {}, &lanes::Kernels::lanes).lanes;
  const auto side_by_side = 6 * static_cast<std::uint64_t>(widest) + 2;
  return longest * a_point * std::min(realisations, threads * side_by_side);
}

}  // namespace

Needs needs_of(const Experiment& experiment, const Means& means) {
  const bool has_page = means.page && !means.shard;
  Needs needs{.disk_bytes = has_page ? page_itself : 0, .memory_bytes = program_itself};
  std::uint64_t rows = 0;
  for (const Condition& condition : experiment.conditions) {
    rows += effective_realisations(condition);
    if (means.shard) {
      needs.memory_bytes += kept_in_shard;
      continue;
    }
    needs.disk_bytes += reported.bytes(condition) + parameters_in(condition);
    needs.memory_bytes += kept_for_report.bytes(condition) + 2 * parameters_in(condition);
    if (!has_page) continue;
    needs.disk_bytes += drawn_shaking.bytes(condition);
    needs.memory_bytes += kept_for_page.bytes(condition);
  }
  if (means.shard) rows = (rows + means.shard->parts - 1) / means.shard->parts;
  needs.disk_bytes += row * (rows - std::min(rows, means.stored));
  needs.memory_bytes += strobe_points(experiment, rows, means.threads);
  return needs;
}

}  // namespace rocking

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/output/report.hpp"

/// What a reader of a result must know before using it, and what to do about it.
namespace rocking {

/// Clamped draws are reported as an alarm above this share of the realisations of a condition, or of its draws: below
/// it they change a probability by less than the usual half-width of an interval.
inline constexpr double tolerable_clamped_share = 0.01;

/// The number of a condition's realisations with a clamped draw, and of its clamped draws.
struct ClampedShare {
  std::uint64_t realisations = 0;
  std::uint64_t of_realisations = 0;
  std::uint64_t draws = 0;
  std::uint64_t of_draws = 0;

  [[nodiscard]] double share_of_realisations() const;
  [[nodiscard]] double share_of_draws() const;
  [[nodiscard]] bool is_alarming() const;
};

/// `12.0 % of the realisations and 0.8 % of the draws`.
[[nodiscard]] std::string in_words(const ClampedShare& share);

/// The condition with the largest alarming share of clamped draws.
struct WorstClamps {
  std::size_t condition = 0;
  ClampedShare share;
  std::string remedy;  ///< what the most frequent kind of clamp means, what would avoid it, and which law it leaves
};

/// Absent if no condition has an alarming share.
[[nodiscard]] std::optional<WorstClamps> worst_clamps(const Report& report);

/// Names of the records of a suite that could not be read, in a sentence; absent if none was left out.
[[nodiscard]] std::optional<std::string> left_out_records(const std::vector<std::string>& names);

/// That a restitution is likely a measured ratio of the rates (RateRatios::doubt), in a sentence; absent: it is not.
[[nodiscard]] std::optional<std::string> restitution_alarm(const Report& report);

/// What to do if response modes change with the tolerance: the key and its value, or what is left if `tolerance` is at
/// the limit of double precision.
[[nodiscard]] std::string tolerance_remedy(double tolerance);

/// What is alarming in the numbers of an experiment, each with its JSON pointer: numbers that have another unit than their
/// key more likely than not, and blocks wider than high or that swing back at an impact.
[[nodiscard]] std::vector<std::string> suspicious_numbers(const Experiment& experiment);

/// Sampled periods that are too few to classify a response (section::fewest_periods), likewise. Overturning needs none.
[[nodiscard]] std::vector<std::string> too_few_periods(const Experiment& experiment);

/// The clamps that a run would raise an alarm for, one sentence a kind (plan's sample_clamps).
[[nodiscard]] std::vector<std::string> foreseen_clamps(const Experiment& experiment);

/// The alarms of a run, each a sentence or two: records left out, a restitution that is likely a ratio, contact lost
/// before a final fall, clamped draws.
[[nodiscard]] std::vector<std::string> alarms_of(const Report& report);

}  // namespace rocking

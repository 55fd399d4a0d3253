#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/report.hpp"

/// What a reader of a result must know before using it, and what to do about it.
namespace rocking {

enum class Rating : std::uint8_t { fine, note, look };
inline constexpr std::array<std::string_view, 3> rating_names{"fine", "note", "look"};

/// A possible reason why a result is wrong, and what was found about it.
struct Finding {
  std::string name;  ///< what was looked at: `contact with the base`
  Rating rating = Rating::look;
  std::string text{};    ///< without a full stop
  std::string remedy{};  ///< what to do; empty: nothing
  std::string place{};  ///< JSON pointer, or flags of `rocking trajectory` for the first such realisation; may be empty
};

[[nodiscard]] const StructType& fields_of(const Finding*);

/// Text, place and remedy.
[[nodiscard]] std::string in_words(const Finding& finding);
/// The same; empty without one.
[[nodiscard]] std::string in_words(const std::optional<Finding>& finding);

/// `warning: ...`, a line for each that needs a look.
[[nodiscard]] std::string warning_lines(const std::vector<Finding>& findings);

inline constexpr std::string_view tolerance_check = "sensitivity to tolerance";
inline constexpr std::string_view late_settling_check = "settled late";

/// All for which a report has numbers, also those that are fine: numerical error, unresolved responses, precision,
/// departures from the model, responses still in the transient, clamped numbers, ground motions, restitution. They follow
/// from the rest of the report.
[[nodiscard]] std::vector<Finding> findings_of(const Report& report);

/// Of these: sensitivity to the tolerance, unresolved responses, and whether intervals are as narrow as was wanted.
[[nodiscard]] std::vector<Finding> precision_findings(const Report& report);

/// Clamped numbers are looked at above this share of the realisations of a condition, or of its draws: below it they
/// change a probability by less than the usual half-width of an interval.
inline constexpr double tolerable_clamped_share = 0.01;
/// What they mean, what would avoid them, and which law they leave, in the condition that has most of them.
[[nodiscard]] Finding clamped_numbers(const Report& report);

/// The records of a suite that could not be read; absent if none was left out.
[[nodiscard]] std::optional<Finding> left_out_records(const std::vector<std::string>& names);

/// The records that are multiplied by more than `largest_usual_scale`; absent if there are none.
[[nodiscard]] std::optional<Finding> far_scaled(const std::vector<UsedGroundMotion>& motions);

/// What is alarming in the numbers of an experiment, each place once: numbers that have another unit than their key more
/// likely than not, and blocks wider than high or that swing back at an impact.
[[nodiscard]] std::vector<Finding> suspicious_numbers(const Experiment& experiment);

/// Sampled periods that are too few to classify a response (section::fewest_periods). Overturning needs none.
[[nodiscard]] std::vector<Finding> too_few_periods(const Experiment& experiment);

/// The clamps that a run would find, one of each kind (plan's sample_clamps).
[[nodiscard]] std::vector<Finding> foreseen_clamps(const Experiment& experiment);

}  // namespace rocking

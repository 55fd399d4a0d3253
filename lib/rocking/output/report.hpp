#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/shaking.hpp"

namespace rocking {

/// A condition with what it found.
struct ReportedCondition {
  /// Its parameters are the same pointers in every condition. In a report that was read it has no ground motion, nor
  /// what follows from one: the scale, and a horizon that is not stated.
  Condition asked;
  bool states_horizon = true;       ///< the experiment; otherwise the horizon follows from the condition's base motion
  std::optional<Shaking> shaking;   ///< absent under a ground motion
  std::optional<double> scale;      ///< of a ground motion, otherwise absent
  std::optional<FloorPeaks> floor;  ///< on a floor of a building, otherwise absent
  ConditionResult result;
};

/// A run: what was asked and what was found.
struct Report {
  InputFacts input;
  base::Sha256 digest{};
  std::optional<ToleranceSensitivity> tolerance_sensitivity;  ///< absent where nothing was rerun
  std::vector<ReportedCondition> conditions;                  ///< at least one
  std::vector<UsedGroundMotion> ground_motions;
  SystemFacts system;
  std::vector<std::string> swept;     ///< pointers of the parameters
  std::vector<std::string> left_out;  ///< Experiment::left_out

  [[nodiscard]] std::string title() const { return input.title(); }
  /// Whether the conditions have the records of a suite of ground motions, named in the experiment.
  [[nodiscard]] bool has_suite() const { return conditions.front().asked.record_stream != 0; }
  /// Transient and sampled periods of a realisation; absent if they differ between the conditions, or follow from the
  /// base motion of each.
  [[nodiscard]] std::optional<std::uint64_t> periods() const;
  /// The confidence of the intervals, `95 %`; if it is swept, a text that says so.
  [[nodiscard]] std::string level(const std::string& swept_text = "each condition's own confidence") const;
  /// Response modes that occur in any condition, with their counts.
  [[nodiscard]] std::map<section::ResponseMode, std::uint64_t> occurring() const;
  /// Response modes that any condition lists; some of them may not occur.
  [[nodiscard]] std::set<section::ResponseMode> listed() const;
  /// Largest number of realisations of a condition.
  [[nodiscard]] std::uint64_t most_realisations() const;
  /// Whether any condition is random.
  [[nodiscard]] bool is_random() const;
  /// Whether the base of every condition moves periodically, so that its periods mean something.
  [[nodiscard]] bool is_periodic() const;
  /// Whether realisations were run until they were classified.
  [[nodiscard]] bool has_settling() const;
};

/// Where the blocks stand that are not on the ground: `on a floor at 0.8 of the height of a building of 1.5 Hz, 5 % damping:
/// peak 0.6 g, of the ground 0.3 g`. Empty where all are on the ground.
[[nodiscard]] std::string floor_in_words(const Report& report);

/// The share of a mode that a condition may not list.
struct AnyShare {
  std::uint64_t count = 0;
  double estimate = 0.0;
  /// Absent if nothing is random, or if the result cannot have one.
  std::optional<stats::Interval> interval;
};

/// Share of a mode in a condition. A condition does not list modes that did not occur in it; their interval is the one
/// that a report would have for a count of 0.
[[nodiscard]] AnyShare share_of(const ReportedCondition& condition, const section::ResponseMode& mode);

/// The share that overturned to one side.
[[nodiscard]] AnyShare share_of(const ReportedCondition& condition, const SideEstimate& side);
/// Whether the two sides of the mean block of some condition differ.
[[nodiscard]] bool has_unlike_edges(const Report& report);

/// The report of a complete run.
[[nodiscard]] Report report_of(Experiment experiment, ExperimentResult result, SystemFacts system);

/// Whether the conditions have the records of a suite of ground motions.
[[nodiscard]] bool sweeps_records(const Report& report);

[[nodiscard]] const StructType& fields_of(const Report*);

/// report.json.
[[nodiscard]] const DocumentOf<Report>& report_document();

/// The text of report.json. All but `system` has the same bytes for equal input.
[[nodiscard]] std::string report_text(const Experiment& experiment, const ExperimentResult& result,
                                      const SystemFacts& system);

/// The report in a document of the right form, whose parts are not compared. Throws base::InputError with every key that
/// is missing, unknown or wrong, also of a condition.
[[nodiscard]] Report report_in(const Json& document);

/// Reads and checks the text of a report.json. Throws base::InputError if it is no report, or if its parts contradict
/// each other: the digest of the experiment, the points of its sweep, the counts, the intervals.
[[nodiscard]] Report parse_report(std::string_view text);

}  // namespace rocking

#pragma once

#include <string>
#include <vector>

#include "rocking/output/findings.hpp"
#include "rocking/output/report.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking::analysis {

/// HTML: whether the block overturns, how likely, and from which to which value of the swept parameter.
[[nodiscard]] std::string overturning_in_brief(const Report& report);

/// HTML: the most likely response in each stretch of the swept parameter.
[[nodiscard]] std::string responses_in_brief(const Report& report);

/// HTML: how many runs of a condition diverge, and after which time; or why none can be compared.
[[nodiscard]] std::string recurrence_in_brief(const Report& report);

/// HTML: the response modes that occur, each in words and with a schematic drawing.
[[nodiscard]] std::string modes_in_brief(const Report& report);

/// HTML: the response modes of the only condition, each with a bar for its probability.
[[nodiscard]] std::string shares_in_brief(const Report& report);

/// HTML: with which probability two runs of a condition respond differently; or why none can be compared.
[[nodiscard]] std::string repeatability(const Report& report);

/// HTML: the answer of a page, made of the above; of one condition with a bar for each response mode.
[[nodiscard]] std::string answer_in_brief(const Report& report);

/// HTML: the answer of a page about a suite of ground motions, a sentence, above its options.
[[nodiscard]] std::string suite_in_brief(const Report& report, const std::string& sentence);

/// The experiment in two or three sentences of HTML: block, excitation, friction, what is random and what is varied.
[[nodiscard]] std::string question_at_once(const Report& report);

/// The same with the impacts and the number of realisations.
[[nodiscard]] std::string question_in_brief(const Report& report);

/// What question_at_once omits, and a list of all settings, followed by the experiment file.
[[nodiscard]] std::string question_in_full(const Report& report);

/// HTML: when the responses of a run with `until_classified` settled: a table with a row for each condition, which limit
/// would do where it was too short, and the rates at which settled responses were left. Empty for another run.
[[nodiscard]] std::string settling_html(const Report& report);

/// HTML: what the model leaves out, and what this means for the results, with literature. Independent of a report.
[[nodiscard]] std::string limits_html();

/// Inline SVG: a schematic time history of a response mode, tilt above base acceleration. For (m,n): m rocks in n
/// periods, repeated. Empty for `unresolved`, which has no typical form.
[[nodiscard]] std::string mode_drawing(const section::ResponseMode& mode);

/// Inline SVG: what the sweep makes of the block, at most five options side by side to one scale, with their sizes.
[[nodiscard]] std::string object_drawings(const Report& report);
/// Their numbers as a table: centre of mass, base, and the tilts of balance, or of a share of it, in degrees.
[[nodiscard]] std::string object_facts(const Report& report, const std::optional<double>& share_of_balance);

/// HTML: how many findings are fine, and those that need attention.
[[nodiscard]] std::string trust_in_brief(const std::vector<Finding>& findings);

/// All findings as a list.
[[nodiscard]] std::string trust_in_full(const std::vector<Finding>& findings);

/// How to repeat the run and where it came from: seed, digest, version, machine.
[[nodiscard]] std::string provenance(const Report& report);

}  // namespace rocking::analysis

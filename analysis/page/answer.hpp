#pragma once

#include <string>

#include "rocking/output/report.hpp"

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

/// HTML: the answer of a page, made of the above; of one condition with a bar for each response mode. `suite`: sentences
/// about a suite of ground motions, a line each, which replace the places of overturning; empty if there are none.
[[nodiscard]] std::string answer_in_brief(const Report& report, const std::string& suite = "");

}  // namespace rocking::analysis

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/run_report.hpp"

namespace rocking::analysis {

enum class Verdict : std::uint8_t { fine, note, look };

/// Something that could make a result untrue, and what the report says of it.
struct Check {
  std::string name;
  Verdict verdict = Verdict::fine;
  std::string finding;  ///< HTML
  std::string where;    ///< the first realisation to look at: HTML; empty where there is none
};

/// Every check that the report has the numbers for: arithmetic, what was not named, what left the model, what was clamped,
/// what was still moving, whether there was enough.
[[nodiscard]] std::vector<Check> checks_of(const RunReport& report);

/// How many of them find nothing, and those that ask for a look: HTML.
[[nodiscard]] std::string trust_in_brief(const std::vector<Check>& checks);

/// All of them as a table.
[[nodiscard]] std::string trust_in_full(const std::vector<Check>& checks);

/// How to make the run again and where it came from: seed, digest, version, machine.
[[nodiscard]] std::string provenance(const RunReport& report);

}  // namespace rocking::analysis

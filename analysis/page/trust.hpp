#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rocking/output/report.hpp"

namespace rocking::analysis {

enum class Rating : std::uint8_t { fine, note, look };

/// A possible reason why a result is wrong, and what the report shows about it.
struct Check {
  std::string name;
  Rating rating = Rating::fine;
  std::string finding;  ///< HTML
  std::string where;    ///< the first realisation to inspect, HTML; empty if there is none
};

/// All checks for which the report has numbers: numerical error, unresolved responses, departures from the model,
/// clamped draws, responses still in the transient, precision.
[[nodiscard]] std::vector<Check> checks_of(const Report& report);

/// HTML: how many checks have no finding, and those that need attention.
[[nodiscard]] std::string trust_in_brief(const std::vector<Check>& checks);

/// All checks as a list.
[[nodiscard]] std::string trust_in_full(const std::vector<Check>& checks);

/// How to repeat the run and where it came from: seed, digest, version, machine.
[[nodiscard]] std::string provenance(const Report& report);

}  // namespace rocking::analysis

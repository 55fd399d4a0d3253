#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "needs.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/report/write_facts.hpp"

namespace rocking::program {

/// What a run would do.
struct Plan {
  std::string title;
  std::uint64_t conditions = 0;
  std::uint64_t realisations = 0;    ///< of all conditions
  bool at_most = false;              ///< some conditions may stop before
  std::uint64_t periods = 0;         ///< of all realisations together
  bool has_record = false;           ///< a period is then that of the strobe, not of an excitation
  Needs needs;
  std::vector<std::string> effects;  ///< that are on in at least one condition
};

[[nodiscard]] Plan plan_of(const experiment::Experiment& experiment, const Means& means);
[[nodiscard]] std::string to_text(const Plan& plan);
[[nodiscard]] std::vector<report::Fact> facts_of(const Plan& plan);

}  // namespace rocking::program

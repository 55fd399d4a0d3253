#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/rare/rare.hpp"

namespace rocking {

inline constexpr std::string_view rare_format = "rocking.rare/1";

/// The probabilities of a rare event for the conditions of an experiment.
struct FoundRare {
  const Experiment* experiment;
  RareQuestion question;
  rare::Score score;
  std::size_t particles;                 ///< of a repetition
  std::vector<RareEstimate> conditions;  ///< of the experiment
};

/// `rocking.rare/1` (lib/docs/formats.md).
[[nodiscard]] std::string rare_text(const FoundRare& found);

/// The probabilities as text: a row for each condition, and what is to be known about them.
[[nodiscard]] std::string rare_table(const FoundRare& found);

}  // namespace rocking

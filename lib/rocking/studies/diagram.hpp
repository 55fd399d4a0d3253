#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rocking/dynamics/contact.hpp"
#include "rocking/section/classification.hpp"

/// What a bifurcation diagram consists of.
namespace rocking {

/// Start of the steps of a branch: the initial state of the file, or the end of the previous step, with the parameter
/// increasing or decreasing from step to step.
enum class Branch : std::uint8_t { initial, upwards, downwards };
inline constexpr std::array all_branches{Branch::initial, Branch::upwards, Branch::downwards};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(Branch branch);

/// One value of the parameter on one branch.
struct DiagramStep {
  std::size_t condition = 0;  ///< of the experiment
  bool continued = false;     ///< started at the end of the previous step, not from the initial state of the file
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Classification classification;
  std::vector<section::StrobePoint> points;  ///< of the sampled periods; none where the horizon was not reached
};

/// A diagram: the values of the first entry of a sweep, at fixed values of the others.
struct Diagram {
  std::vector<std::size_t> conditions;  ///< of the experiment, by increasing value of the parameter
  /// By Branch, then as `conditions`.
  std::array<std::vector<DiagramStep>, all_branches.size()> branches;
};

}  // namespace rocking

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking {

/// Response modes that the tester counts together.
struct ModeGroup {
  std::string name;
  std::vector<section::ResponseMode> modes;  ///< none: all that no other group has
};

/// The modes that a name means: `(1,1)`, `(1,1)|(3,3)`, or `other`, for which there are none. Throws base::InputError
/// with the place and the part of the name that is no mode.
[[nodiscard]] std::vector<section::ResponseMode> modes_in_group(std::string_view name, const std::string& place);

/// The group that has a mode: its own, or the last one.
[[nodiscard]] std::size_t group_of(const std::vector<ModeGroup>& groups, const section::ResponseMode& mode);

/// Of one condition: more would take the memory of numbers, not of a laboratory.
inline constexpr std::uint64_t most_tests = 1'000'000;
inline constexpr std::size_t most_tested_conditions = 1000;

/// Tests under one condition.
struct TestedCondition {
  std::vector<Parameter> parameters;  ///< in which it differs from the experiment
  std::vector<std::uint64_t> counts;  ///< of tests by group; none of a candidate
};

/// Tests that were counted, and conditions of which one may be tested next.
struct CountedTests {
  std::vector<ModeGroup> groups;  ///< the last one has all modes that no other has
  std::vector<TestedCondition> conditions;
  std::vector<TestedCondition> candidates = {};
};

}  // namespace rocking

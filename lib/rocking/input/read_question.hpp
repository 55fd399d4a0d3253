#pragma once

#include <cstdint>
#include <string>

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/object_reader.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Value of `format` in an experiment file.
inline constexpr std::string_view experiment_format = "rocking.experiment/1";

/// An experiment file, its sweep left aside: one condition.
struct Question {
  std::string title;
  std::uint64_t seed = 0;
  Condition condition;
  Json canonical;  ///< every default written out, keys in their fixed order; `sweep` holds its place as it was written
};

/// Reads each key by itself; what values demand of each other is for check_relations.
/// `files`: of recorded motion. Throws std::system_error where one is named that cannot be read.
[[nodiscard]] Question read_question(const Json& document, GroundMotionFiles& files, Problems& problems);

}  // namespace rocking

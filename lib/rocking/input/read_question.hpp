#pragma once

#include <span>
#include <string>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Value of `format` in an experiment file.
inline constexpr std::string_view experiment_format = "rocking.experiment/1";

/// An experiment file, its sweep left aside, and its canonical text: every default written out, keys in their fixed
/// order; `sweep` holds its place as it was written.
struct QuestionAsRead {
  UnsweptExperiment question;
  Json canonical;
};

/// Reads each key by itself; what values demand of each other is for check_relations.
/// `written`: the keys of the file that the canonical text has; none: all.
[[nodiscard]] QuestionAsRead read_question(const Json& document, RecordFields& records, Problems& problems,
                                           std::span<const std::string> written = {});

/// The same with the files of recorded motion; null: none is looked at. Throws std::system_error where one is named that
/// cannot be read.
[[nodiscard]] inline QuestionAsRead read_question(const Json& document, GroundMotionFiles* files, Problems& problems,
                                                  std::span<const std::string> written = {}) {
  FiledRecords records(files);
  return read_question(document, records, problems, written);
}

}  // namespace rocking

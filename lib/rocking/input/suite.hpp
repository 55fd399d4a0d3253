#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"

/// A suite of ground motions: `excitation.suite` in an experiment file, each record a point of the sweep. While a
/// condition is read, its record stands in the place of the suite, as `file` and what belongs to it.
namespace rocking {

/// The swept place.
inline constexpr std::string_view suite_place = "/excitation/file";

struct Suite {
  std::vector<Json> records;  ///< each an object with `file` and perhaps `sha256`, `component`, `vertical_file`, ...
  std::vector<std::string> left_out;  ///< names of files that could not be read
};

/// Takes `excitation.suite` and `excitation.left_out` out of an experiment and puts its first record there. No records where
/// there is no suite or a bad one. A record whose file has the bytes of another one's is refused. A file that
/// cannot be read throws std::system_error. With `skips_unreadable` it is left out, as is one without a motion.
[[nodiscard]] Suite take_suite(Json& document, const FileMatches& matches, GroundMotionFiles& files,
                               bool skips_unreadable, Problems& problems);

/// Whether a problem is one of the files of a record, whose place is the name of the file, perhaps with a line.
[[nodiscard]] bool is_of_record(const base::Problem& problem, const Json& record);

/// Puts a record into `excitation`, in place of the one before.
void put_record(Json& document, const Json& record);

/// The record that a condition in canonical form has.
[[nodiscard]] Json record_of(const Json& canonical);

/// Condition::record_stream of a record in canonical form: the number that the first 16 digits of its `sha256` write. The
/// components of one file have streams of their own.
[[nodiscard]] std::uint64_t stream_of(const Json& record);

/// A record as a point of the sweep: the name of its file, and the component and the level if it
/// has them: `a.V1A, N10E`, `b.at2, level 0.4`.
[[nodiscard]] Json name_of_record(const Json& record);

/// The suite of a canonical experiment as an entry of its sweep, with the names of the records; absent if it has none.
[[nodiscard]] std::optional<SweepAxis> suite_axis(const Json& canonical);

/// The canonical experiment without its suite: put_record puts a record there.
[[nodiscard]] Json without_suite(Json canonical);

/// Writes a suite, with records in canonical form, in place of the one record that a canonical experiment has.
void write_suite(Json& canonical, const Suite& suite);

/// Names of the records that a canonical experiment leaves out.
[[nodiscard]] std::vector<std::string> left_out_of(const Json& canonical);

/// The experiment with the suite as an entry of its sweep, so that defaults that follow from a record are not written.
[[nodiscard]] Json with_suite_as_sweep(Json document);

/// Gives a recorded excitation the first value of a sweep of a measure of its strength, if it has none, nor a scale:
/// otherwise the standard scale would contradict the sweep.
void take_strength_from_sweep(Json& document);

/// Samples of a ground motion are those of another one if they differ by at most this share of its peak: above what is
/// lost by rounding, or by another value of g, and far below any two records of an earthquake.
inline constexpr double same_series_tolerance = 2e-3;

/// Reports the records of a suite that are vertical components (record_component.hpp), and those that are a former one
/// once more: in another format, under another name, in other units. A factor between two series is that of two units,
/// and counts only where one of the two units was assumed; also records of boreholes beside others. `motions`: of the records, without null.
void check_suite(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems);

}  // namespace rocking

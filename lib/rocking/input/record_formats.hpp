#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/ground_motion_reading.hpp"

/// Formats of files with recorded accelerations (lib/docs/ground-motions.md).
namespace rocking {

enum class RecordFormat : std::uint8_t {
  columns,
  peer_at2,
  esm_asc,
  knet,
  smc,
  geonet,
  cosmos,
  csmip,
  afad,
  timeseries
};

/// A line of numbers for each sample.
[[nodiscard]] std::optional<GroundMotion> read_columns(std::string_view text, const GroundMotionReading& how,
                                                       Problems& problems);

/// A header whose last line has NPTS and DT, in any of the wordings of the PEER databases, and evenly spaced
/// accelerations in g.
[[nodiscard]] std::optional<GroundMotion> read_peer_at2(std::string_view text, const GroundMotionReading& how,
                                                        Problems& problems);
[[nodiscard]] bool is_line_of_peer_header(std::string_view line);

/// A header of lines `KEY: value` of the European strong-motion database, of which SAMPLING_INTERVAL_S and UNITS are
/// needed and NDATA is checked, and evenly spaced accelerations.
[[nodiscard]] std::optional<GroundMotion> read_esm_asc(std::string_view text, const GroundMotionReading& how,
                                                       Problems& problems);
[[nodiscard]] bool is_line_of_esm_header(std::string_view line);

/// K-NET and KiK-net: a header of 17 lines with a scale factor in gal, and counts, whose mean is removed.
[[nodiscard]] std::optional<GroundMotion> read_knet(std::string_view text, const GroundMotionReading& how,
                                                    Problems& problems);
[[nodiscard]] bool is_line_of_knet_header(std::string_view line);

/// SMC of the USGS: headers of text, whole numbers and numbers in columns, and accelerations in cm/s^2.
[[nodiscard]] std::optional<GroundMotion> read_smc(std::string_view text, const GroundMotionReading& how,
                                                   Problems& problems);
[[nodiscard]] bool is_line_of_smc_header(std::string_view line);

/// V1A and V2A of GeoNet: three components, accelerations in mm/s^2.
[[nodiscard]] std::optional<GroundMotion> read_geonet(std::string_view text, const GroundMotionReading& how,
                                                      Problems& problems);
[[nodiscard]] bool is_line_of_geonet_header(std::string_view line);

/// V1 and V2 of COSMOS, one or several components.
[[nodiscard]] std::optional<GroundMotion> read_cosmos(std::string_view text, const GroundMotionReading& how,
                                                      Problems& problems);
[[nodiscard]] bool is_line_of_cosmos_header(std::string_view line);

/// V1 and V2 of CSMIP, one or several components.
[[nodiscard]] std::optional<GroundMotion> read_csmip(std::string_view text, const GroundMotionReading& how,
                                                     Problems& problems);
[[nodiscard]] bool is_line_of_csmip_header(std::string_view line);

/// AFAD: the layout of esm_asc, or the older one with three columns.
[[nodiscard]] std::optional<GroundMotion> read_afad(std::string_view text, const GroundMotionReading& how,
                                                    Problems& problems);
[[nodiscard]] bool is_line_of_afad_header(std::string_view line);

/// SLIST and TSPAIR of ObsPy and of the web services of data centers: one line of header for a segment.
[[nodiscard]] std::optional<GroundMotion> read_timeseries(std::string_view text, const GroundMotionReading& how,
                                                          Problems& problems);
[[nodiscard]] bool is_line_of_timeseries_header(std::string_view line);

/// How a format is read: as read_ground_motion.
struct RecordReader {
  RecordFormat format;
  std::string_view name;                   ///< in experiments
  bool (*is_line)(std::string_view line);  ///< a line of the header by which the format is recognised; null: none
  std::optional<GroundMotion> (*read)(std::string_view text, const GroundMotionReading& how, Problems& problems);
};

/// In the order of RecordFormat; a file that is not recognised has the first.
inline constexpr std::array record_readers{
    RecordReader{RecordFormat::columns, "columns", nullptr, read_columns},
    RecordReader{RecordFormat::peer_at2, "peer_at2", is_line_of_peer_header, read_peer_at2},
    RecordReader{RecordFormat::esm_asc, "esm_asc", is_line_of_esm_header, read_esm_asc},
    RecordReader{RecordFormat::knet, "knet", is_line_of_knet_header, read_knet},
    RecordReader{RecordFormat::smc, "smc", is_line_of_smc_header, read_smc},
    RecordReader{RecordFormat::geonet, "geonet", is_line_of_geonet_header, read_geonet},
    RecordReader{RecordFormat::cosmos, "cosmos", is_line_of_cosmos_header, read_cosmos},
    RecordReader{RecordFormat::csmip, "csmip", is_line_of_csmip_header, read_csmip},
    RecordReader{RecordFormat::afad, "afad", is_line_of_afad_header, read_afad},
    RecordReader{RecordFormat::timeseries, "timeseries", is_line_of_timeseries_header, read_timeseries}};
static_assert(std::ranges::is_sorted(record_readers, {}, &RecordReader::format) &&
                  record_readers.back().format == static_cast<RecordFormat>(record_readers.size() - 1),
              "the order of RecordFormat");

/// Their names, and `auto` after them: recognised by the first lines.
inline constexpr auto record_format_choices = [] {
  std::array<std::string_view, record_readers.size() + 1> choices;
  std::ranges::transform(record_readers, choices.begin(), &RecordReader::name);
  choices.back() = "auto";
  return choices;
}();
inline constexpr std::size_t automatic_record_format = record_readers.size();

/// Of a `std::optional<RecordFormat>`: one of these choices. The canonical text does not state `auto`.
[[nodiscard]] const ValueType& record_format_type();

/// The format of a file by its first lines.
[[nodiscard]] RecordFormat recognised_format(std::string_view text);

/// Most bytes that the file of a ground motion may have.
inline constexpr std::size_t most_ground_motion_bytes = 64'000'000;

/// Reads a recorded base motion in one of the formats of lib/docs/ground-motions.md. `columns`: lines of numbers, `#`
/// before comments; with a time step `horizontal[, vertical]`, without one `time, horizontal[, vertical]`. Two equal
/// times are a jump. `vertical_name` is not read here.
///
/// Absent where anything is wrong. Every bad line is a problem with file, line and value, up to five of them.
[[nodiscard]] std::optional<GroundMotion> read_ground_motion(std::string_view text, const GroundMotionReading& how,
                                                             Problems& problems);

/// Adds the horizontal component of another file as the vertical one. The times of the two must agree; where one has
/// fewer samples, it is at rest from its end on, and the motion has a warning. False where anything is wrong.
[[nodiscard]] bool add_vertical(const GroundMotion& vertical, GroundMotion& motion, Problems& problems);

}  // namespace rocking

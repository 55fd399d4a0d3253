#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rocking/rocking.hpp"

/// \file
/// Pages, figures and tables of runs. A library that was built without fmt does not have them.
namespace rocking {

/// For what figures are drawn.
enum class Column : std::uint8_t {
  screen,          ///< pages and slides
  journal_single,  ///< the column of a journal: 84 mm, 8 points, no titles
  journal_double,  ///< 174 mm
};

/// Writes the page of a complete run, one HTML file without external resources, as the program's `report.html`. Runs
/// gnuplot for its pictures. Uses `threads` and `stop` of the execution. `hazard`: the page of a suite then tells its annual
/// rates. Throws std::invalid_argument if the run is not complete, base::InputError if its experiment was made in C++ (the
/// page shows the text of the experiment) or a hazard curve does not fit, base::Stopped if it is asked to stop, and
/// std::system_error with the path where the file cannot be written.
[[nodiscard]] ROCKING_API Written write_page(const StoredRun& stored, const std::filesystem::path& file,
                                             const Provenance& provenance = {}, const Execution& execution = {},
                                             const std::optional<HazardCurve>& hazard = {});

/// How figures are drawn.
struct Drawn {
  Column column = Column::screen;
  /// In what each is written beside its numbers: svg, png, pdf, or gp, gnuplot's script. Empty: svg, or pdf for a journal.
  std::vector<std::string> pictures;
};

/// Draws the figures of a complete run in a folder, which is created if necessary: numbers (tsv) and pictures. Throws
/// base::InputError for a kind of picture that there is not; otherwise as write_page.
[[nodiscard]] ROCKING_API Written write_figures(const StoredRun& stored, const std::filesystem::path& folder,
                                                const Drawn& drawn = {}, const Execution& execution = {},
                                                const std::optional<HazardCurve>& hazard = {});

/// Writes the tables of a complete run into a folder, which is created if necessary, in CSV and LaTeX: those of
/// `rocking report --format csv,latex`. Otherwise as write_page.
[[nodiscard]] ROCKING_API Written write_tables(const StoredRun& stored, const std::filesystem::path& folder);

/// Writes the page of a realisation: one HTML file without external resources, in which the block moves, as `rocking
/// trajectory --html` does. `samples_per_period` of the request: 0 for as many as the eye needs. Throws base::InputError
/// and base::Stopped as trajectory(), and the former also if the block overturns before two samples were taken;
/// std::system_error with the path where the file cannot be written.
ROCKING_API void write_trajectory_page(const Experiment& experiment, const TrajectoryRequest& request,
                                       const std::filesystem::path& file, const Execution& execution = {});

/// A text that a study returned or the program printed, such as `rocking.fragility/1`, and its name in errors.
struct StudyText {
  std::string name;
  std::string text;
};

/// Excitation periods of trajectories.
struct ShownPeriods {
  double from = 0.0;
  std::optional<double> to = {};  ///< absent: the last
};

/// Draws trajectories, and what studies found that has figures, from their JSON text, in a folder. Throws
/// base::InputError with the name of a text that is none of these, and otherwise as write_page.
[[nodiscard]] ROCKING_API Written draw(const std::vector<StudyText>& texts, const std::filesystem::path& folder,
                                       const Drawn& drawn = {}, const Execution& execution = {},
                                       const ShownPeriods& shown = {});

}  // namespace rocking

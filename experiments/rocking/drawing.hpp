#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/gnuplot.hpp"
#include "analysis/run_report.hpp"
#include "exit_code.hpp"
#include "run_folder.hpp"

namespace rocking::program {

/// The figures of a run, with its realisations where its folder has them. Throws as RunFolder::open_sound_store
/// does.
[[nodiscard]] std::vector<analysis::Figure> figures_of(const RunFolder& folder, const analysis::RunReport& report);

/// What a picture is to a command whose machine could not draw it: `report` and `figure` are there to draw, and fail. To `run`,
/// `resume` and `merge` it is an addition: their results are complete, and a cluster that saw a failure would run them again.
enum class PictureRole : std::uint8_t { purpose, addition };

/// What kept figures from being drawn: each reason once.
class DrawingFailures {
 public:
  void add(const analysis::Drawing& drawing);

  /// Says every reason on standard error; also where a command is to be quiet. Returns the code to exit with: done where only
  /// gnuplot is missing, which leaves data and scripts; input_output where the machine stopped gnuplot and pictures are the
  /// purpose, done where they are an addition; our_bug where gnuplot refused a script.
  [[nodiscard]] ExitCode tell(std::string_view consequence, PictureRole role) const;

 private:
  std::map<std::string, analysis::DrawingEnd> reasons_;
};

/// What a failure means to whoever wanted figures, and to a page.
inline constexpr std::string_view no_figure = "a figure was not drawn";
inline constexpr std::string_view no_page_picture = "report.html has no pictures for printing";

struct WrittenFigures {
  std::vector<std::string> files;
  DrawingFailures failures;
};

/// Writes figures into a folder, which is made if need be. Without a picture, its data and script are written all the same.
/// Throws std::system_error with the path.
[[nodiscard]] WrittenFigures write_figures(const std::vector<analysis::Figure>& figures,
                                           const std::filesystem::path& folder);

}  // namespace rocking::program

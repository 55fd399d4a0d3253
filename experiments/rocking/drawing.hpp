#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/draw.hpp"
#include "analysis/look.hpp"
#include "exit_code.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/study/study.hpp"

namespace rocking::program {

/// The figures of a run, with its realisations if its folder has them; of a suite also its fragility and incremental
/// dynamic analysis, with annual rates if there is a hazard curve. Throws as RunFolder::open_valid_store does, and
/// base::InputError if that is one of another intensity.
[[nodiscard]] std::vector<analysis::Figure> figures_of(const RunFolder& folder, const Report& report,
                                                       const std::optional<HazardCurve>& hazard = std::nullopt);

/// The tables of the fragility of a run with a suite, in the formats `csv` and `latex`; throws likewise.
[[nodiscard]] std::vector<TextFile> tables_of(const RunFolder& folder, const Report& report,
                                              const std::optional<HazardCurve>& hazard,
                                              const std::set<std::string>& formats);

/// The importance of a picture to a command. The purpose of `report` is to draw, so that it fails without
/// it. For `run` and `resume` it is an addition: the results are complete, and a cluster would run them again
/// after a failure.
enum class PictureRole : std::uint8_t { purpose, addition };

/// Prints why figures could not be drawn on standard error, also if the command is quiet. Returns the exit code: done if
/// only gnuplot is missing (data and scripts are written), or if the machine stopped gnuplot and pictures are an addition;
/// input_output if the machine stopped gnuplot and pictures are the purpose; our_bug if gnuplot rejected a script.
[[nodiscard]] ExitCode tell(const std::vector<analysis::Drawing>& failures, std::string_view consequence,
                            PictureRole role);

/// What a failure means for a command that draws figures, and for a page.
inline constexpr std::string_view no_figure = "a figure was not drawn";
inline constexpr std::string_view no_page_picture = "report.html has no pictures for printing";

/// The flags `--style`, `--width` and `--pictures`.
struct StyleRequest {
  std::string style = "screen";
  std::string width;                  ///< empty: not given
  std::vector<std::string> pictures;  ///< of analysis::figure_formats(); empty: what the style needs
};

void add_style(CLI::App& command, StyleRequest& request);

/// Throws UsageError if a width is given that the style does not have.
[[nodiscard]] analysis::FigureLook look_for(const StyleRequest& request);

/// Writes the page of a report into its folder. Returns which pictures could not be drawn; the page omits them.
/// Throws base::Stopped when a signal asks to stop, std::system_error where the page cannot be written.
[[nodiscard]] std::vector<analysis::Drawing> write_page(const RunFolder& folder, const Report& report,
                                                        const std::optional<HazardCurve>& hazard = std::nullopt);

}  // namespace rocking::program

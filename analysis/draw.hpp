#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/gnuplot.hpp"

namespace rocking::analysis {

/// The picture formats there are: svg, png, pdf.
[[nodiscard]] const std::vector<std::string>& picture_formats();

/// Writes NAME.tsv and NAME.gp into `folder`, which must be there, and draws the pictures in these formats beside them.
/// Where a picture cannot be drawn, the two files are there all the same, no picture of the figure is (one of before would
/// show other data), and the drawing says why. Equal figures give equal bytes. Throws std::system_error with the path.
[[nodiscard]] Drawing write_figure(const Figure& figure, const std::filesystem::path& folder,
                                   const std::vector<std::string>& formats = picture_formats(),
                                   base::StopRequest stop = {});

/// The figure as SVG text, drawn in a temporary folder; empty where it cannot be drawn, `drawing` says why. Throws base::Stopped
/// once it is asked to stop.
[[nodiscard]] std::string svg_of(const Figure& figure, Drawing& drawing, base::StopRequest stop = {});

}  // namespace rocking::analysis

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/gnuplot.hpp"
#include "analysis/look.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// The available picture formats: svg, png, pdf.
[[nodiscard]] const std::vector<std::string>& picture_formats();

/// Endings of the files of a figure that need no gnuplot: tsv, gp, py.
[[nodiscard]] const std::vector<std::string>& text_formats();

/// Writes NAME.tsv, NAME.gp and NAME.py into the existing folder `folder` and draws the pictures in these formats there.
/// If a picture cannot be drawn, the three files are written all the same, existing pictures of the figure are removed
/// (they would show other data), and the result says why. Equal figures give equal bytes. Throws std::system_error with the
/// path.
[[nodiscard]] Drawing write_figure(const Figure& figure, const std::filesystem::path& folder,
                                   const std::vector<std::string>& formats = picture_formats(),
                                   base::StopRequest stop = {}, const FigureLook& look = screen_look());

/// The bytes of the figure in a format, `svg`, `png` or `pdf`, drawn in a temporary folder. Empty if it cannot be drawn;
/// `drawing` says why. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::string picture_of(const Figure& figure, const std::string& format, Drawing& drawing,
                                     base::StopRequest stop = {}, const FigureLook& look = screen_look());

}  // namespace rocking::analysis

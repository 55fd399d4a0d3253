#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/look.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// How an attempt to draw ended.
enum class DrawingEnd : std::uint8_t {
  drawn,
  not_installed,  ///< the program that draws is missing
  broken_off,  ///< prevented by this machine: a signal, a full disk, a gnuplot without the format or without a message
  refused,     ///< gnuplot did not understand the script: an error of this program
};

struct Drawing {
  DrawingEnd end = DrawingEnd::refused;
  std::string reason;  ///< why there is no picture, and what to do; empty if it was drawn

  [[nodiscard]] bool is_drawn() const { return end == DrawingEnd::drawn; }
};

/// In what a figure can be written beside its numbers: svg, png, pdf, and gp, gnuplot's script.
[[nodiscard]] const std::vector<std::string>& figure_formats();

/// Writes NAME.tsv into the existing folder `folder`, and NAME.FORMAT in these formats. Where the numbers have changed,
/// files of the figure in other formats are removed. If a picture cannot be drawn, the numbers and the script are written
/// all the same, and the result says why. Equal figures give equal bytes. Throws std::system_error with the path.
[[nodiscard]] Drawing write_figure(const Figure& figure, const std::filesystem::path& folder,
                                   const std::vector<std::string>& formats, base::StopRequest stop = {},
                                   const FigureLook& look = screen_look());

/// Figures in a folder.
struct WrittenFigures {
  std::vector<std::string> files;
  std::vector<Drawing> failures;  ///< attempts to draw that failed, each reason once
};

/// Adds an attempt that failed, unless one with this reason is there.
void note_failure(const Drawing& drawing, std::vector<Drawing>& failures);

/// Writes figures as write_figure does, into a folder that is created if necessary. Without formats: svg for pages and
/// slides, pdf for a journal.
[[nodiscard]] WrittenFigures write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                                           const std::vector<std::string>& formats, base::StopRequest stop,
                                           const FigureLook& look);

/// The bytes of the figure in a format, `svg`, `png` or `pdf`, drawn in a temporary folder. Empty if it cannot be drawn;
/// `drawing` says why. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::string picture_of(const Figure& figure, const std::string& format, Drawing& drawing,
                                     base::StopRequest stop = {}, const FigureLook& look = screen_look());

/// A page of HTML, without scripts and external resources, as PDF: by WeasyPrint, which is looked up in PATH. Empty where
/// that is missing or fails; `printing` says why. Equal pages give equal bytes. Throws base::Stopped if it is asked to
/// stop.
[[nodiscard]] std::string pdf_of(std::string_view html, Drawing& printing, base::StopRequest stop);

/// Which pictures to draw.
struct Pictures {
  std::vector<std::string> formats;  ///< of `svg`, `png`, `pdf`
  std::string ending;                ///< suffix after each name NAME.FORMAT
};

/// Runs gnuplot on `folder/NAME.gp` for these pictures and waits for it. gnuplot is looked up in PATH. If it is asked
/// to stop, gnuplot is killed and base::Stopped is thrown.
[[nodiscard]] Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                                  const Pictures& pictures, base::StopRequest stop = {});

}  // namespace rocking::analysis

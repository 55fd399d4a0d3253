#include "analysis/draw.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/wait.h>

#include "analysis/child_process.hpp"
#include "analysis/figure_scripts.hpp"
#include "rocking/text/files.hpp"

namespace rocking::analysis {

const std::vector<std::string>& figure_formats() {
  static const std::vector<std::string> formats{"svg", "png", "pdf", "gp"};
  return formats;
}

namespace {

namespace fs = std::filesystem;

/// Suffix of the name of a picture while gnuplot draws it.
const std::string unfinished = ".unfinished";

/// Whether a file of this format is complete, judged by its end.
bool is_whole(std::string_view picture, std::string_view format) {
  const std::size_t last = picture.find_last_not_of("\r\n");
  const std::string_view end = format == "svg" ? "</svg>" : format == "png" ? "IEND\xAE\x42\x60\x82" : "%%EOF";
  return last != std::string_view::npos && picture.substr(0, last + 1).ends_with(end);
}

/// Replaces the creation date in a PDF by gnuplot with a fixed one of the same length, so that no offset in the file
/// changes.
void forget_the_day(std::string& pdf) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view day = "20000101000000";
  const std::size_t place = pdf.find(key);
  if (place == std::string::npos || pdf.size() < place + key.size() + day.size()) return;
  pdf.replace(place + key.size(), day.size(), day);
}

fs::path file_of(const fs::path& folder, const Figure& figure, const std::string& format) {
  return folder / (figure.name + '.' + format);
}

/// Renames a picture that gnuplot finished; false if it is incomplete, as on a full disk.
bool keep_picture(const fs::path& drawn, const fs::path& kept, const std::string& format) {
  if (!fs::exists(drawn)) return false;
  std::string content = read_file(drawn);
  if (!is_whole(content, format)) return false;
  if (format == "pdf") forget_the_day(content);
  write_atomically(kept, content);
  return true;
}

/// Keeps the pictures if gnuplot drew all of them.
void keep_pictures(const Figure& figure, const fs::path& folder, const std::vector<std::string>& formats,
                   Drawing& drawing) {
  for (const std::string& format : formats) {
    const fs::path kept = file_of(folder, figure, format);
    const fs::path drawn = kept.string() + unfinished;
    if (drawing.is_drawn() && !keep_picture(drawn, kept, format)) {
      drawing = {.end = DrawingEnd::broken_off,
                 .reason = kept.string() + ": gnuplot left this file unfinished; check whether the disk is full"};
    }
    fs::remove(drawn);
  }
}

/// Writes the numbers. If they have changed, removes what was written of others.
void write_numbers(const Figure& figure, const fs::path& folder) {
  const fs::path path = file_of(folder, figure, "tsv");
  const std::string text = data_text(figure);
  if (fs::exists(path) && read_file(path) == text) return;
  for (const std::string& format : figure_formats()) fs::remove(file_of(folder, figure, format));
  write_atomically(path, text);
}

}  // namespace

Drawing write_figure(const Figure& figure, const fs::path& folder, const std::vector<std::string>& formats,
                     base::StopRequest stop, const FigureLook& look) {
  write_numbers(figure, folder);
  const fs::path script = file_of(folder, figure, "gp");
  write_atomically(script, script_text(figure, look));
  std::vector<std::string> pictures = formats;
  const bool is_script_wanted = std::erase(pictures, "gp") > 0;
  Drawing drawing{.end = DrawingEnd::drawn, .reason = {}};
  if (!pictures.empty()) {
    drawing = run_gnuplot(folder, figure.name, {.formats = pictures, .ending = unfinished}, stop);
    keep_pictures(figure, folder, pictures, drawing);
  }
  if (drawing.is_drawn() && !is_script_wanted) fs::remove(script);
  return drawing;
}

void note_failure(const Drawing& drawing, std::vector<Drawing>& failures) {
  const bool is_known = std::ranges::find(failures, drawing.reason, &Drawing::reason) != failures.end();
  if (!drawing.is_drawn() && !is_known) failures.push_back(drawing);
}

WrittenFigures write_figures(const std::vector<Figure>& figures, const fs::path& folder,
                             const std::vector<std::string>& formats, base::StopRequest stop, const FigureLook& look) {
  ensure_writable(folder);
  const std::vector<std::string> usual{look.style == FigureStyle::journal ? "pdf" : "svg"};
  const std::vector<std::string>& wanted = formats.empty() ? usual : formats;
  WrittenFigures written;
  for (const Figure& figure : figures) {
    const Drawing drawing = write_figure(figure, folder, wanted, stop, look);
    note_failure(drawing, written.failures);
    written.files.push_back(file_of(folder, figure, "tsv").string());
    for (const std::string& format : drawing.is_drawn() ? wanted : std::vector<std::string>{"gp"}) {
      written.files.push_back(file_of(folder, figure, format).string());
    }
  }
  return written;
}

std::string picture_of(const Figure& figure, const std::string& format, Drawing& drawing, base::StopRequest stop,
                       const FigureLook& look) {
  try {
    const TemporaryFolder folder;
    drawing = write_figure(figure, folder.path(), {format}, stop, look);
    return drawing.is_drawn() ? read_file(folder.path() / (figure.name + '.' + format)) : std::string();
  } catch (const std::system_error& error) {
    drawing = {
        .end = DrawingEnd::broken_off,
        .reason = std::string(error.what()) + "; set TMPDIR to a writable folder, and check that the disk is not full"};
    return {};
  }
}

namespace {

/// Interprets the exit status and the message of gnuplot.
Drawing drawing_from(const ChildEnd& child, const std::string& script) {
  const int status = child.status;
  const std::string& words = child.words;
  if (child.is_success()) return {.end = DrawingEnd::drawn, .reason = {}};
  if (WIFSIGNALED(status)) {
    return {.end = DrawingEnd::broken_off,
            .reason = script + ": gnuplot was ended by signal " + std::to_string(WTERMSIG(status))};
  }
  if (words.find("unknown or ambiguous terminal type") != std::string::npos) {
    return {.end = DrawingEnd::broken_off,
            .reason = script + ": this gnuplot cannot draw a format: " + words +
                      "; install a gnuplot with svg, pngcairo and pdfcairo (Debian: gnuplot-nox)"};
  }
  // gnuplot itself names the line that it does not understand.
  if (words.empty()) {
    return {
        .end = DrawingEnd::broken_off,
        .reason = script + ": gnuplot ended with code " + std::to_string(WEXITSTATUS(status)) + " and said nothing"};
  }
  return {.end = DrawingEnd::refused, .reason = script + ": gnuplot failed: " + words};
}

}  // namespace

Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& name, const Pictures& pictures,
                    base::StopRequest stop) {
  std::string wanted = "formats='";
  for (const std::string& format : pictures.formats) wanted += (wanted.back() == '\'' ? "" : " ") + format;
  std::vector<std::string> arguments{"gnuplot", "-d", "-e", wanted + "'; ending='" + pictures.ending + '\'',
                                     name + ".gp"};
  const ChildEnd child = run_child(folder, std::move(arguments), stop);
  if (child.error == ENOENT) {
    return {.end = DrawingEnd::not_installed,
            .reason = "gnuplot is not installed, so no picture was drawn; install it (Debian: gnuplot-nox)"};
  }
  if (child.error != 0)
    return {.end = DrawingEnd::broken_off,
            .reason = "gnuplot cannot be started: " + std::generic_category().message(child.error)};
  return drawing_from(child, (folder / (name + ".gp")).string());
}

namespace {

constexpr std::size_t most_pdf_bytes = 100'000'000;

Drawing ending_of(const ChildEnd& child) {
  if (child.error == ENOENT) {
    return {
        .end = DrawingEnd::not_installed,
        .reason = "WeasyPrint is not installed, so no PDF was made; install it (Debian: weasyprint), or write HTML"};
  }
  if (child.error != 0) {
    return {.end = DrawingEnd::broken_off,
            .reason = "WeasyPrint cannot be started: " + std::generic_category().message(child.error)};
  }
  if (!child.is_success()) return {.end = DrawingEnd::broken_off, .reason = "WeasyPrint failed: " + child.words};
  return {.end = DrawingEnd::drawn, .reason = {}};
}

}  // namespace

std::string pdf_of(std::string_view html, Drawing& printing, base::StopRequest stop) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "page.html", html);
  printing = ending_of(run_child(folder.path(), {"weasyprint", "--quiet", "page.html", "page.pdf"}, stop));
  return printing.is_drawn() ? read_file(folder.path() / "page.pdf", most_pdf_bytes) : "";
}

}  // namespace rocking::analysis

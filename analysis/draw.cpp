#include "analysis/draw.hpp"

#include <system_error>

#include "analysis/child_process.hpp"
#include "analysis/data_file.hpp"
#include "analysis/gnuplot_script.hpp"
#include "analysis/matplotlib_script.hpp"
#include "rocking/text/files.hpp"

namespace rocking::analysis {
const std::vector<std::string>& picture_formats() {
  static const std::vector<std::string> formats{"svg", "png", "pdf"};
  return formats;
}

const std::vector<std::string>& text_formats() {
  static const std::vector<std::string> formats{"tsv", "gp", "py"};
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

fs::path picture(const fs::path& folder, const Figure& figure, const std::string& format) {
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

/// Keeps the pictures if gnuplot drew all of them; otherwise removes existing ones, which show other data.
void keep_or_remove(const Figure& figure, const fs::path& folder, const std::vector<std::string>& formats,
                    Drawing& drawing) {
  for (const std::string& format : formats) {
    const fs::path kept = picture(folder, figure, format);
    const fs::path drawn = kept.string() + unfinished;
    if (drawing.is_drawn() && !keep_picture(drawn, kept, format)) {
      drawing = {.end = DrawingEnd::broken_off,
                 .reason = kept.string() + ": gnuplot left this file unfinished; check whether the disk is full"};
    }
    fs::remove(drawn);
  }
  if (drawing.is_drawn()) return;
  for (const std::string& format : formats) fs::remove(picture(folder, figure, format));
}

}  // namespace

Drawing write_figure(const Figure& figure, const fs::path& folder, const std::vector<std::string>& formats,
                     base::StopRequest stop, const FigureLook& look) {
  write_atomically(folder / (figure.name + ".tsv"), data_text(figure));
  write_atomically(folder / (figure.name + ".gp"), script_text(figure, look));
  write_atomically(folder / (figure.name + ".py"), matplotlib_text(figure, look));
  Drawing drawing = run_gnuplot(folder, figure.name, {.formats = formats, .ending = unfinished}, stop);
  keep_or_remove(figure, folder, formats, drawing);
  return drawing;
}

std::string picture_of(const Figure& figure, const std::string& format, Drawing& drawing, base::StopRequest stop,
                       const FigureLook& look) {
  try {
    const TemporaryFolder folder;
    drawing = write_figure(figure, folder.path(), {format}, stop, look);
    return drawing.is_drawn() ? read_file(folder.path() / (figure.name + '.' + format)) : std::string();
  } catch (const std::system_error& error) {
    drawing = {.end = DrawingEnd::broken_off,
               .reason = std::string(error.what()) +
                         "; set TMPDIR to a writable folder, and check that the disk "
                         "is not full"};
    return {};
  }
}

}  // namespace rocking::analysis

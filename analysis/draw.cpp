#include "analysis/draw.hpp"

#include <system_error>

#include "analysis/data_file.hpp"
#include "analysis/gnuplot_script.hpp"
#include "analysis/temporary_folder.hpp"
#include "rocking/report/files.hpp"

namespace rocking::analysis {
const std::vector<std::string>& picture_formats() {
  static const std::vector<std::string> formats{"svg", "png", "pdf"};
  return formats;
}

namespace {

/// Sets back the day on which gnuplot's pdf says it was made, digit for digit, so that no place in the file moves.
void forget_the_day(const std::filesystem::path& pdf) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view day = "20000101000000";
  std::string content = report::read_file(pdf);
  const std::size_t place = content.find(key);
  if (place == std::string::npos || content.size() < place + key.size() + day.size()) return;
  content.replace(place + key.size(), day.size(), day);
  report::write_atomically(pdf, content);
}

}  // namespace

Drawing write_figure(const Figure& figure, const std::filesystem::path& folder,
                     const std::vector<std::string>& formats, base::StopRequest stop) {
  report::write_atomically(folder / (figure.name + ".tsv"), data_text(figure));
  report::write_atomically(folder / (figure.name + ".gp"), script_text(figure));
  Drawing drawing = run_gnuplot(folder, figure.name, formats, stop);
  const std::filesystem::path pdf = folder / (figure.name + ".pdf");
  if (drawing.drawn && std::filesystem::exists(pdf)) forget_the_day(pdf);
  return drawing;
}

std::string svg_of(const Figure& figure, Drawing& drawing, base::StopRequest stop) {
  try {
    const TemporaryFolder folder;
    drawing = write_figure(figure, folder.path(), {"svg"}, stop);
    return drawing.drawn ? report::read_file(folder.path() / (figure.name + ".svg")) : std::string();
  } catch (const std::system_error& error) {
    drawing = {.reason = std::string(error.what()) + "; set TMPDIR to a folder that can be written to, and see that the disk "
                                                     "is not full"};
    return {};
  }
}

}  // namespace rocking::analysis

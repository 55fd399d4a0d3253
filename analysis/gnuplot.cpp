#include "analysis/gnuplot.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/wait.h>

#include "analysis/child_process.hpp"

namespace rocking::analysis {
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

}  // namespace rocking::analysis

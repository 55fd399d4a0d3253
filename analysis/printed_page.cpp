#include "analysis/printed_page.hpp"

#include <cerrno>
#include <system_error>

#include "analysis/child_process.hpp"
#include "analysis/temporary_folder.hpp"
#include "rocking/text/files.hpp"

namespace rocking::analysis {
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

// What gnuplot is given, and what is left where it fails.

#include "analysis/gnuplot_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/draw.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/text/files.hpp"
#include "support/sample_report.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace rocking::analysis;
using ::testing::HasSubstr;

TEST(GnuplotText, IsPlainLettersAndOctalNumbersInDoubleQuotes) {
  EXPECT_EQ(gnuplot_quoted("A_h = 4.2 (ψ)"), "\"A_h = 4.2 (ψ)\"");
  EXPECT_EQ(gnuplot_quoted("'\"`\\{}@$#%&"), R"("\047\042\140\134\173\175\100\044\043\045\046")");
}

TEST(GnuplotText, LeavesNoDigitBehindAnOctalNumber) { EXPECT_EQ(gnuplot_quoted("'12a3"), R"("\047\061\062a3")"); }

TEST(GnuplotText, IsValidUtf8OnOneLine) {
  EXPECT_EQ(printable("a\nb\tc\x7f\xC2\x85"), "a b c  ");
  EXPECT_EQ(printable("ψ€\xF0\x9F\x98\x80"), "ψ€\xF0\x9F\x98\x80");
  for (const char* wrong :
       {"\xff", "\x80", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82"}) {
    EXPECT_EQ(printable(wrong).substr(0, 3), "\uFFFD") << wrong;
    EXPECT_EQ(printable(printable(wrong)), printable(wrong));
  }
  EXPECT_EQ(printable("\xEF\xBF\xBE"), "\uFFFD");
}

TEST(GnuplotText, ShowsControlsOfWritingDirection) {
  EXPECT_EQ(printable("a\u202e2ta.exe"), "a\\u202e2ta.exe");
  EXPECT_EQ(gnuplot_quoted("\u2066x"), R"("\134u2066x")");
}

TEST(GnuplotText, IsCutBetweenLetters) {
  EXPECT_EQ(cut("ψψψψ", 4), "ψψψψ");
  EXPECT_EQ(cut("ψψψψψ", 4), "ψψψ…");
}

Figure sample_figure() {
  const auto figures = run_figures(rocking::report_in(rocking::support::sample_report()));
  return *std::ranges::find(figures, "mode_bands", &Figure::name);
}

/// Replaces gnuplot by a script during its lifetime.
class OtherGnuplot {
 public:
  explicit OtherGnuplot(const std::string& script) : path_(std::getenv("PATH")) {
    rocking::write_atomically(folder_ / "gnuplot", "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder_ / "gnuplot", std::filesystem::perms::owner_all);
    ::setenv("PATH", ((folder_ / "").string() + ":" + path_).c_str(), 1);
  }
  OtherGnuplot(const OtherGnuplot&) = delete;
  OtherGnuplot& operator=(const OtherGnuplot&) = delete;
  ~OtherGnuplot() { ::setenv("PATH", path_.c_str(), 1); }

 private:
  rocking::support::TemporaryFolder folder_;
  std::string path_;
};

TEST(Drawing, LeavesNoPictureBehindWhereGnuplotFails) {
  using rocking::analysis::DrawingEnd;
  struct Case {
    std::string script;
    DrawingEnd end;
    std::string reason;
  };
  const std::string half = "for format in svg png pdf; do echo half >mode_bands.$format.unfinished; done\n";
  for (const auto& [script, end, reason] :
       {Case{half + "echo no such word >&2; exit 1", DrawingEnd::refused, "no such word"},
        Case{half + "kill -9 $$", DrawingEnd::broken_off, "signal 9"}, Case{half, DrawingEnd::broken_off, "unfinished"},
        Case{"exit 0", DrawingEnd::broken_off, "unfinished"},
        Case{"echo unknown or ambiguous terminal type; exit 1", DrawingEnd::broken_off, "gnuplot-nox"}}) {
    const rocking::support::TemporaryFolder folder;
    for (const char* ending : {".svg", ".png", ".pdf"}) {
      rocking::write_atomically(folder / (std::string("mode_bands") + ending), "of before");
    }
    const OtherGnuplot gnuplot(script);
    const auto drawing = write_figure(sample_figure(), folder / "", {"svg", "png", "pdf"});
    EXPECT_EQ(drawing.end, end) << script;
    EXPECT_THAT(drawing.reason, HasSubstr(reason));
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) left.push_back(entry.path().filename());
    EXPECT_THAT(left, ::testing::UnorderedElementsAre("mode_bands.tsv", "mode_bands.gp")) << script;
  }
}

TEST(Drawing, SaysWhatIsMissingAndLeavesTheData) {
  const rocking::support::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const auto drawing = write_figure(sample_figure(), folder / "", {"svg"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(drawing.is_drawn());
  EXPECT_THAT(drawing.reason, HasSubstr("gnuplot-nox"));
  EXPECT_THAT(rocking::read_file(folder / "mode_bands.tsv"), HasSubstr("amplitude"));
}

}  // namespace

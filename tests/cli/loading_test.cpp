// The snippets of lib/docs/loading.md for pandas, R and Octave, run where these are installed. Tutorial.Works/loading follows
// the rest of it.

#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::Outcome;
using ::testing::HasSubstr;

/// pandas is a package of the system's Python, which may not be the first one in PATH.
const std::string debian_python = "PATH=/usr/bin:$PATH python3";

class Loading : public rocking::support::ProgramTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(rocking("run quick.json -o out -q").exit_code, 0);
    ASSERT_EQ(rocking("report out --format csv -q").exit_code, 0);
  }

  /// The snippet of this language, run by `command`.
  Outcome run_snippet(const std::string& language, const std::string& command) const {
    std::ifstream page(ROCKING_SOURCE_DIR "/lib/docs/loading.md");
    std::string snippet;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
      if (line == "```") inside = false;
      if (inside) snippet += line + '\n';
      if (line == "```" + language) inside = true;
    }
    EXPECT_NE(snippet, "");
    write("snippet", snippet);
    return shell(command + " snippet");
  }

  /// `condition mode count` of the whole run, one line each, from the store.
  std::string counts() const {
    std::ostringstream lines;
    const Json conditions = Json::parse(read("out/report.json"))["result"]["conditions"];
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      for (const auto& [mode, count] : conditions[i]["counts"].items()) {
        if (count > 0) lines << i << ' ' << mode << ' ' << count << '\n';
      }
    }
    return lines.str();
  }

  void expect_every_count(const std::string& output) const {
    std::istringstream lines(counts());
    for (std::string line; std::getline(lines, line);) EXPECT_THAT(output, HasSubstr(line));
  }
};

TEST_F(Loading, WorksInPandas) {
  if (shell(debian_python + " -c 'import pandas'").exit_code != 0)
    GTEST_SKIP() << "pandas was not found (Debian: python3-pandas)";
  const Outcome outcome = run_snippet("python-pandas", debian_python);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("condition"));
}

TEST_F(Loading, WorksInR) {
  if (shell("command -v Rscript").exit_code != 0) GTEST_SKIP() << "R was not found (Debian: r-base-core)";
  const Outcome outcome = run_snippet("r", "Rscript");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("estimate"));
}

TEST_F(Loading, WorksInOctave) {
  if (shell("command -v octave-cli").exit_code != 0) GTEST_SKIP() << "Octave was not found (Debian: octave)";
  const Outcome outcome = run_snippet("octave", "octave-cli");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  expect_every_count(outcome.output);
}

}  // namespace

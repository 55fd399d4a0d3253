// The functions of tests/support/setup.sh, sourced by a shell whose package tools are stand-ins.

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// What a shell prints that has sourced setup.sh and runs `commands`.
std::string output_of(const std::string& commands) {
  const std::string line = "bash -c 'source " ROCKING_SOURCE_DIR "/tests/support/setup.sh; " + commands + "' 2>&1";
  std::FILE* shell = popen(line.c_str(), "r");
  if (shell == nullptr) return "no shell";
  std::string output;
  std::array<char, 256> chunk{};
  while (std::fgets(chunk.data(), chunk.size(), shell) != nullptr) output += chunk.data();
  pclose(shell);
  return output;
}

/// A folder of headers as one Boost would leave it.
fs::path headers(const std::string& name, const std::string& version, bool with_math) {
  const fs::path root = fs::path(testing::TempDir()) / ("rocking_setup_" + name);
  fs::create_directories(root / "boost/math/distributions");
  std::ofstream(root / "boost/version.hpp") << "//  #define BOOST_VERSION 1\n#define BOOST_VERSION " << version << "\n";
  fs::remove(root / "boost/math/distributions/beta.hpp");
  if (with_math) std::ofstream(root / "boost/math/distributions/beta.hpp") << "\n";
  return root;
}

TEST(Setup, InstallsNoBoostBesideOneThatWillDo) {
  EXPECT_EQ(output_of("missing_boost /nowhere " + headers("new", "108100", true).string()), "");
  EXPECT_EQ(output_of("missing_boost " + headers("oldest", "107400", true).string() + " /nowhere"), "");
}

TEST(Setup, InstallsBoostWhereThereIsNoneOrNoneThatWillDo) {
  EXPECT_EQ(output_of("missing_boost /nowhere"), "libboost1.81-dev\n");
  EXPECT_EQ(output_of("missing_boost " + headers("old", "106700", true).string()), "libboost1.81-dev\n");
  EXPECT_EQ(output_of("missing_boost " + headers("no_math", "108100", false).string()), "libboost1.81-dev\n");
}

TEST(Setup, InstallsNoNodeBesideOneThatIsThere) {
  EXPECT_EQ(output_of("command() { return 0; }; missing_browser"), "");
  EXPECT_EQ(output_of("command() { [[ $2 != npm ]]; }; missing_browser"), "nodejs\nnpm\n");
  EXPECT_EQ(output_of("command() { [[ $2 != chromium ]]; }; missing_browser"), "chromium\n");
}

TEST(Setup, NamesTheMissingPackagesOnly) {
  EXPECT_EQ(output_of("dpkg-query() { if [[ ${@: -1} == here ]]; then echo installed; else return 1; fi; };"
                      "missing_of here gone here lost"),
            "gone\nlost\n");
}

TEST(Setup, TouchesNothingWhereAllIsThere) {
  EXPECT_EQ(output_of("dpkg-query() { echo installed; }; missing_boost() { :; }; apt-get() { echo touched; };"
                      "sudo() { echo touched; }; install_missing anything"),
            "-- packages: all there\n");
}

TEST(Setup, ShowsTheLogOfAStepThatFailsAndStops) {
  const std::string output =
      output_of("logs=$(mktemp -d); drop_root=(); step name words sh -c \"echo trouble; exit 3\"; echo went on");
  EXPECT_NE(output.find("trouble"), std::string::npos) << output;
  EXPECT_NE(output.find("step 'words' failed"), std::string::npos) << output;
  EXPECT_EQ(output.find("went on"), std::string::npos) << output;
}

}  // namespace

// The functions of tests/support/setup.sh, run in a shell whose package tools are stubs.

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// Output of a shell that has sourced setup.sh and runs `commands`.
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

/// A folder of headers, as an installed Boost has it.
fs::path headers(const std::string& name, const std::string& version, bool with_math) {
  const fs::path root = fs::path(testing::TempDir()) / ("rocking_setup_" + name);
  fs::create_directories(root / "boost/math/distributions");
  std::ofstream(root / "boost/version.hpp") << "//  #define BOOST_VERSION 1\n#define BOOST_VERSION " << version << "\n";
  fs::remove(root / "boost/math/distributions/beta.hpp");
  if (with_math) std::ofstream(root / "boost/math/distributions/beta.hpp") << "\n";
  return root;
}

TEST(Setup, FindsABoostThatWillDo) {
  EXPECT_EQ(output_of("has_boost /nowhere " + headers("new", "108100", true).string() + " && echo yes"), "yes\n");
  EXPECT_EQ(output_of("has_boost " + headers("oldest", "107400", true).string() + " /nowhere && echo yes"), "yes\n");
}

TEST(Setup, FindsNoBoostWhereItIsTooOldOrIncomplete) {
  EXPECT_EQ(output_of("has_boost /nowhere || echo no"), "no\n");
  EXPECT_EQ(output_of("has_boost " + headers("old", "106700", true).string() + " || echo no"), "no\n");
  EXPECT_EQ(output_of("has_boost " + headers("no_math", "108100", false).string() + " || echo no"), "no\n");
}

/// The packages of a system whose names or versions differ between systems. Others are available on every system.
struct PackageSystem {
  std::string name;
  std::string boost;  ///< cases of `case $package in` that set the version that the system offers
  std::string chosen;
  std::string left_out;
};

// Output of `apt-cache policy` on each system.
const std::vector<PackageSystem> systems = {
    {"Debian 12",
     "libboost-dev) v=1.74.0.3 ;; libboost1.74-dev) v=1.74.0+ds1-21 ;; libboost1.81-dev) v=1.81.0-5+deb12u1 ;;",
     "libboost1.81-dev", ""},
    {"Debian 13",
     "libboost-dev) v=1.83.0.2+b2 ;; libboost1.83-dev) v=1.83.0-4.2 ;; libboost1.88-dev) v=1.88.0-1.1 ;; "
     "libboost1.81-dev) v= ;;",
     "libboost-dev", ""},
    {"Ubuntu 24.04",
     "libboost-dev) v=1.83.0.1ubuntu2 ;; libboost1.83-dev) v=1.83.0-2.1ubuntu3.1 ;; libboost1.81-dev) v=\"(none)\" ;; "
     "chromium) v=\"(none)\" ;;",
     "libboost-dev", "chromium"},
};

/// Shell functions that replace the package tools of a system on which nothing is installed. `apt-get` prints the
/// packages that it is asked to install.
std::string nothing_installed_on(const std::string& versions) {
  return "apt-cache() { local v=1.0-1; case $2 in " + versions +
         " esac; [[ $v ]] && printf \"%s:\\n  Installed: (none)\\n  Candidate: %s\\n\" $2 \"$v\"; };"
         "dpkg-query() { return 1; }; has_boost() { return 1; }; drop_root=(); sudo() { \"$@\"; };"
         "step() { [[ $1 == packages ]] && printf \"%s\\n\" \"${@: 3}\"; return 0; };";
}

TEST(Setup, InstallsThePackagesThatEachSupportedSystemOffers) {
  for (const PackageSystem& system : systems) {
    SCOPED_TRACE(system.name);
    const std::string output = output_of(nothing_installed_on(system.boost) +
                                         "install_missing \"${build_packages[@]}\" -- \"${test_packages[@]}\" "
                                         "\"${release_packages[@]}\" chromium; echo done");
    EXPECT_NE(output.find("\nlibfmt-dev\n"), std::string::npos) << output;
    EXPECT_NE(output.find("\nslurm-wlm\n"), std::string::npos) << output;
    EXPECT_NE(output.find("\n" + system.chosen + "\ndone\n"), std::string::npos) << output;
    EXPECT_EQ(output.find("libboost"), output.rfind("libboost")) << "one Boost only: " << output;
    const bool without_chromium = output.find("\nchromium\n") == std::string::npos;
    EXPECT_EQ(without_chromium, system.left_out == "chromium") << output;
    EXPECT_EQ(output.find("-- chromium: not offered here") != std::string::npos, without_chromium) << output;
  }
}

TEST(Setup, SaysWhichSystemsAreSupportedWhereBoostIsTooOld) {
  const std::string output = output_of(nothing_installed_on("libboost-dev) v=1.71.0.0ubuntu2 ;; libboost1.*) v= ;;") +
                                       "install_missing make; echo went on");
  EXPECT_NE(output.find("no Boost 1.74 or later"), std::string::npos) << output;
  EXPECT_NE(output.find("Supported: Debian 12, Debian 13, Ubuntu 24.04"), std::string::npos) << output;
  EXPECT_EQ(output.find("went on"), std::string::npos) << output;
}

TEST(Setup, ReadsThePackageListsBeforeItChoosesAPackage) {
  const std::string output = output_of(nothing_installed_on("libboost1.81-dev) v= ;; libboost-dev) v=$offered ;;") +
                                       "offered=; step() { offered=1.83.0; printf \"%s \" \"$1\" \"${@: -1}\"; };"
                                       "install_missing make");
  EXPECT_EQ(output, "package-lists update packages libboost-dev ");
}

TEST(Setup, ReadmeNamesTheSupportedSystems) {
  std::ifstream file(ROCKING_SOURCE_DIR "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  std::istringstream names(output_of("printf \"%s\\n\" \"${supported_systems[@]}\""));
  int known = 0;
  for (std::string name; std::getline(names, name); ++known) {
    EXPECT_NE(readme.find(name), std::string::npos) << name;
    EXPECT_TRUE(std::any_of(systems.begin(), systems.end(), [&](const PackageSystem& one) { return one.name == name; }))
        << name;
  }
  EXPECT_EQ(known, 3);
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
  EXPECT_EQ(output_of("dpkg-query() { echo installed; }; has_boost() { :; }; apt-get() { echo touched; };"
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

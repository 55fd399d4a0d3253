#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "rocking/text/json.hpp"

namespace rocking::support {

/// Result of a run of the program.
struct Outcome {
  int exit_code = -1;  ///< -1 if a signal ended it
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// An experiment that runs quickly, with a sweep and with random numbers.
inline Json quick_experiment() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "title": "quick",
    "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0 },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "friction": { "sigma": 0.03, "refreshes_per_period": 20 } },
    "horizon": { "transient_periods": 20, "sampled_periods": 40 },
    "sweep": [ { "parameter": "/excitation/amplitude", "values": [3.0, 4.2, 6.0] } ],
    "realisations": 4, "seed": "0x2012" })");
}

/// A test with its own folder, in which the program is run; quick.json in it is the quick experiment.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() {
    std::string name = (std::filesystem::temp_directory_path() / "rocking-cli-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("quick.json", quick_experiment().dump());
  }
  ~ProgramTest() override { std::filesystem::remove_all(folder_); }

  /// Runs `rocking` with these arguments, as interpreted by a shell.
  Outcome rocking(const std::string& arguments) const { return shell("exec '" ROCKING_PROGRAM "' " + arguments); }

  /// Runs it so, without a page, and expects it to succeed.
  void run_quietly(const std::string& arguments) const {
    const Outcome outcome = rocking(arguments + " -q --no-page");
    ASSERT_EQ(outcome.exit_code, 0) << arguments << outcome.errors;
  }

  /// The part of a report that must not depend on how it was made.
  std::string lasting_part(const std::string& report) const {
    Json json = Json::parse(read(report));
    json.erase("system");
    return json.dump();
  }

  /// The Python for which the module `rocking` was built, with the module on its path; empty if it is not built.
  static std::string python_with_module() {
    const auto folder = std::filesystem::path(ROCKING_PROGRAM).parent_path() / "python";
    return std::filesystem::exists(folder / "python3") ? "'" + (folder / "python3").string() + "'" : "";
  }

  /// A script that starts the program in the background, where a shell makes its children ignore SIGINT, and waits until
  /// it handles signals and a condition is met, or it has ended. No test waits for a time, which may be too short or too
  /// long on another machine.
  static std::string in_background(const std::string& arguments, const std::string& condition = "true") {
    return "env --default-signal=INT '" ROCKING_PROGRAM "' " + arguments +
           " & child=$!; until grep -q 'SigCgt.*[2367abef]..$' /proc/$child/status && " + condition +
           " || ! kill -0 $child; do sleep 0.01; done 2>/dev/null; ";
  }

  /// A condition: finished realisations of this folder are on disk.
  static std::string has_realisations(const std::string& folder) {
    return "'" ROCKING_PROGRAM "' run --status " + folder + " | grep -q 'done *[1-9]'";
  }

  /// Runs a script that disturbs a command, again as long as the exit code is 0: on a busy machine the command may have
  /// ended before.
  Outcome until_disturbed(const std::string& script) const {
    Outcome outcome = shell(script);
    for (int attempt = 1; attempt < 100 && outcome.exit_code == 0; ++attempt) outcome = shell(script);
    return outcome;
  }

  /// Runs a script in the folder and returns its output. After two minutes it is ended, with exit code 124.
  Outcome shell(const std::string& script) const {
    write("script", script + '\n');
    const std::string command =
        "cd '" + folder_.string() +
        "' && timeout 120 env --default-signal=HUP,INT,TERM,USR1 sh script >stdout 2>stderr </dev/null";
    const int status = std::system(command.c_str());
    return {
        .exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .output = read("stdout"), .errors = read("stderr")};
  }

  void write(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }

  std::string read(const std::string& name) const {
    std::ostringstream content;
    content << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return content.str();
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  std::filesystem::path folder_;
};

/// An experiment with a recorded excitation, from `pulse.txt` in the same folder.
inline Json recorded_experiment() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 8.0 },
    "excitation": { "kind": "recorded", "file": "pulse.txt", "columns": ["time", "horizontal"] },
    "sweep": [ { "parameter": "/excitation/scale", "values": [0.1, 1.0, 10.0] } ] })");
}

/// 0.2 s of 2 m/s^2: the block of that experiment rocks, and overturns if it is scaled by 10.
inline const char* recorded_pulse() { return "# time, horizontal\n0.5, 0\n0.5, 2\n0.7, 2\n0.7, 0\n"; }

}  // namespace rocking::support

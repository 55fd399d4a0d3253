// What each study prints and writes, to the byte, with its help and its typical errors. A file studies/NAME.txt is a
// transcript: lines with `$ ` are commands, and below each stands what it gave. The commands run in one folder, a copy of
// studies/input.
//
//     exit N     exit code
//     > LINE     standard output
//     ! LINE     standard error
//     file PATH  a text file that is new or other than before: its lines, with `: `, or its length and SHA-256
//
// `ROCKING_WRITE_GOLDEN=1 build/release/tests/golden_test --gtest_filter='*Studies*'` writes the transcripts anew; a new
// call is a new line with `$ `. What is known to depend on machine, time or build is replaced, as listed in
// `of_this_machine`. A file whose bytes differ is seen by the same command of both programs.

#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/text/files.hpp"

namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

const fs::path transcripts = fs::path(ROCKING_SOURCE_DIR) / "tests/golden/studies";

/// Whether a file stands in a transcript as its SHA-256: if it is long, or belongs to a figure or a page.
bool is_digested(const std::string& name, const std::string& text) {
  constexpr std::size_t longest = 3000;
  const std::string ending = fs::path(name).extension().string();
  return text.size() > longest || (ending != ".json" && ending != ".csv" && ending != ".tex");
}

/// Without what follows from the machine, the time or the build.
std::string of_every_machine(const std::string& text) {
  static const std::vector<std::pair<std::regex, std::string>> of_this_machine{
      {std::regex("<dt>(program|built with|machine|begun|time)</dt><dd>.*</dd>"), "<dt>$1</dt>*"},  // page
      {std::regex(R"((; rocking )\S+ \S+(\. Made by))"), "$1*$2"},                                  // sheet
  };
  // Of "system", an object of a document, the keys are kept.
  static const std::regex value(R"(("[a-z_]+": )?("[^\n]*"|-?\d[-+0-9.e]*)(,?)$)");
  constexpr std::size_t longest_line = 2000;  // for an expression; longer ones are pictures and series
  std::istringstream lines(text);
  std::string result;
  std::string end;
  for (std::string line; std::getline(lines, line); result += line + '\n') {
    if (line.size() > longest_line) continue;
    for (const auto& [pattern, replacement] : of_this_machine) line = std::regex_replace(line, pattern, replacement);
    if (line.ends_with("\"system\": {")) end = line.substr(0, line.find('"')) + '}';
    if (!end.empty()) line = std::regex_replace(line, value, "$1*$3");
    if (!end.empty() && line.starts_with(end)) end.clear();
  }
  return result;
}

std::string indented(const std::string& text, const std::string& mark) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += mark + line + '\n';
  return result;
}

/// A command, and what it gave.
struct Call {
  std::string command;
  std::string given;
};

/// The calls of a transcript; what stands above the first is the given text of a call without a command.
std::vector<Call> calls_of(const std::string& transcript) {
  std::vector<Call> calls(1);
  std::istringstream lines(transcript);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$ ")) {
      calls.push_back({.command = line.substr(2), .given = ""});
    } else {
      calls.back().given += line + '\n';
    }
  }
  return calls;
}

class Studies : public rocking::support::ProgramTest, public testing::WithParamInterface<std::string> {
 protected:
  Studies() {
    fs::copy(transcripts / "input", folder_, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }

  /// Text files in the folder.
  Files files() const {
    Files found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
      static const std::vector<std::string> endings{".json", ".csv", ".tsv", ".tex", ".html", ".gp", ".py"};
      if (std::ranges::find(endings, entry.path().extension().string()) == endings.end()) continue;
      found[fs::relative(entry.path(), folder_).string()] = rocking::read_file(entry.path());
    }
    return found;
  }

  /// What a command gives, as in a transcript.
  std::string given_by(const std::string& command) {
    const Files before = files();
    const auto outcome =
        shell("PATH='" + transcripts.string() + "':\"$PATH\"\nrocking() { '" ROCKING_PROGRAM "' \"$@\"; }\n" + command);
    std::string given = "exit " + std::to_string(outcome.exit_code) + '\n';
    given += indented(of_every_machine(outcome.output), "> ") + indented(of_every_machine(outcome.errors), "! ");
    for (const auto& [name, content] : files()) {
      if (before.contains(name) && before.at(name) == content) continue;
      const std::string text = of_every_machine(content);
      given += "file " + name;
      if (!is_digested(name, text)) {
        given += '\n' + indented(text, ": ");
      } else {
        const std::string digest = rocking::base::to_hex(rocking::base::sha256(text));
        given += ": " + std::to_string(text.size()) + " bytes, " + digest + '\n';
      }
    }
    return given + '\n';
  }
};

TEST_P(Studies, GiveWhatTheyGave) {
  const fs::path path = transcripts / (GetParam() + ".txt");
  std::vector<Call> calls = calls_of(rocking::read_file(path));
  const bool write_anew = std::getenv("ROCKING_WRITE_GOLDEN") != nullptr;
  std::string transcript = calls.front().given;
  for (const Call& call : std::vector(calls.begin() + 1, calls.end())) {
    const std::string given = given_by(call.command);
    if (!write_anew) {
      EXPECT_EQ(call.given, given) << "of " << path << "\n$ " << call.command;
    }
    transcript += "$ " + call.command + '\n' + given;
  }
  if (write_anew) std::ofstream(path) << transcript;
}

INSTANTIATE_TEST_SUITE_P(Each, Studies, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const fs::directory_entry& entry : fs::directory_iterator(transcripts)) {
                             if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
                           }
                           std::ranges::sort(names);
                           return names;
                         }()),
                         [](const auto& instance) { return instance.param; });

}  // namespace

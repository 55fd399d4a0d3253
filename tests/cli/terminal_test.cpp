// Interactive use at a terminal: progress, help, completion and suggestions.

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/record_text.hpp"

namespace {

using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StartsWith;

std::set<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    found.insert(match->str(1));
  }
  return found;
}

class Terminal : public rocking::support::ProgramTest {
 protected:
  /// The commands that `rocking --help` lists.
  std::set<std::string> commands() const {
    const std::string help = rocking("--help").output;
    return all_matches(help.substr(help.find("Run:")), R"(\n  ([a-z][a-z-]*) +[A-Z])");
  }

  /// Completions that bash offers at the end of a line.
  std::vector<std::string> offered(const std::string& line) const {
    const Outcome outcome =
        shell("'" ROCKING_PROGRAM "' completion bash >completion; bash -c '. ./completion; line=\"" + line +
              "\"; COMP_WORDS=($line); [[ $line == *\" \" ]] && COMP_WORDS+=(\"\"); "
              "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rocking; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.errors, "") << line;
    std::vector<std::string> words;
    std::istringstream lines(outcome.output);
    for (std::string word; std::getline(lines, word);) {
      if (!word.empty()) words.push_back(word);
    }
    return words;
  }
};

// Sixty conditions, and a table of settling as long as they.
TEST_F(Terminal, ShowsARunInOneScreenUnlessAllIsAsked) {
  auto many = quick_experiment();
  many["sweep"] =
      rocking::Json::parse(R"([{ "parameter": "/excitation/amplitude", "from": 0.1, "to": 6.0, "step": 0.1 }])");
  many["horizon"]["until_classified"] = {{"at_most_periods", 200}};
  many["realisations"] = 2;
  write("many.json", many.dump());
  const auto lines = [](const Outcome& outcome) { return std::ranges::count(outcome.output, '\n'); };
  const Outcome short_form = rocking("run many.json -q --no-page -o out");
  ASSERT_EQ(short_form.exit_code, 0) << short_form.errors;
  EXPECT_LE(lines(short_form), 62) << short_form.output;
  EXPECT_THAT(short_form.output,
              AllOf(HasSubstr("all 60 conditions with their intervals: --all"), HasSubstr("its share")));
  const Outcome all = rocking("resume out -q --no-page --all");
  EXPECT_GE(lines(all), 62) << all.output << all.errors;
  EXPECT_THAT(all.output, Not(HasSubstr("--all")));
}

// The answer in lines of a screen; --all prints more.
TEST_F(Terminal, ShowsEveryStudyInOneScreenUnlessAllIsAsked) {
  auto many = quick_experiment();
  many["sweep"] = rocking::Json::parse(
      R"([{ "parameter": "/friction/static", "values": [0.5, 0.45, 0.4] },
          { "parameter": "/excitation/amplitude", "from": 0.5, "to": 7.5, "step": 0.25 }])");
  many["realisations"] = 3;
  write("many.json", many.dump());
  auto calm = many;
  calm["fluctuation"] = rocking::Json::object();
  calm.erase("friction");
  calm["realisations"] = 1;
  calm["sweep"] =
      rocking::Json::parse(R"([{ "parameter": "/excitation/amplitude", "from": 0.5, "to": 2.0, "step": 0.025 }])");
  write("calm.json", calm.dump());
  ASSERT_EQ(rocking("run many.json -q --no-page -o first").exit_code, 0);
  auto changed = many;
  changed["restitution"] = 0.3;
  write("changed.json", changed.dump());
  ASSERT_EQ(rocking("run changed.json -q --no-page -o second").exit_code, 0);
  ASSERT_EQ(shell("mkdir a-folder-with-a-long-name").exit_code, 0);
  std::string motions = "motion";
  for (int i = 0; i < 30; ++i) {
    const std::string name = "a-folder-with-a-long-name/record_" + std::to_string(i) + ".at2";
    write(name, rocking::support::peer_at2({0.1, -0.2 - 0.01 * i, 0.05}, ".01"));
    motions += ' ' + name;
  }
  const auto lines = [](const Outcome& outcome) { return std::ranges::count(outcome.output, '\n'); };
  for (const std::string& study :
       {std::string("compare first second"), std::string("fragility first"),
        std::string("bifurcation many.json -q -o drawn --overwrite"),
        std::string("orbits calm.json -q --periods 1 --no-branches -o drawn --overwrite"), motions}) {
    const Outcome short_form = rocking(study);
    ASSERT_EQ(short_form.exit_code, 0) << study << short_form.errors;
    EXPECT_LE(lines(short_form), 60) << study << '\n' << short_form.output;
    EXPECT_THAT(short_form.output, HasSubstr("--all")) << study;
    const Outcome all = rocking(study + " --all");
    EXPECT_GT(lines(all), 60) << study << '\n' << all.output << all.errors;
    EXPECT_THAT(all.output, Not(HasSubstr("--all"))) << study;
  }
}

/// A terminal simulated by `script`. Skipped with a message if that is impossible, for example in a container without
/// /dev/pts.
class PseudoTerminal : public Terminal {
 protected:
  void SetUp() override {
    const Outcome trial = shell("TERM=xterm script -qec 'stty cols 80' typescript");
    if (trial.exit_code != 0) GTEST_SKIP() << "no pseudo-terminal can be had here: " << trial.output << trial.errors;
  }

  /// Standard error of the program on a terminal with this number of columns.
  std::string seen(int columns, const std::string& arguments, const std::string& environment = "") const {
    const Outcome outcome = shell("TERM=xterm script -qec \"stty cols " + std::to_string(columns) + "; " + environment +
                                  " '" + ROCKING_PROGRAM + "' " + arguments + " >table\" typescript >shown");
    EXPECT_EQ(outcome.exit_code, 0) << read("shown");
    return read("shown");
  }

  /// The same of a command that is interrupted as soon as this pattern is seen.
  std::string seen_until(const std::string& pattern, const std::string& arguments) const {
    shell("TERM=xterm script -qfec \"stty cols 120; echo \\$\\$ >process; exec '" ROCKING_PROGRAM "' " + arguments +
          " >table\" typescript >shown & until grep -qE '" + pattern +
          "' shown || ! kill -0 $!; do sleep 0.02; done; kill -TERM $(cat process); wait");
    return read("shown");
  }

  /// Standard output of the program on such a terminal.
  std::string printed(int columns, const std::string& arguments, const std::string& environment) const {
    const Outcome outcome = shell("TERM=xterm script -qec \"stty cols " + std::to_string(columns) + "; " + environment +
                                  " '" + ROCKING_PROGRAM + "' " + arguments + " 2>notices\" typescript >shown");
    EXPECT_EQ(outcome.exit_code, 0) << read("notices");
    return read("shown");
  }
};

TEST_F(PseudoTerminal, ShowsABarTheRestTheConditionAndItsEstimateOnOneLine) {
  auto longer = quick_experiment();
  longer["realisations"] = 1'000'000;
  write("longer.json", longer.dump());
  const std::string shown = seen_until("amplitude", "run longer.json -j 1 -o out");
  EXPECT_THAT(shown, ContainsRegex("\r\\[.*\x1b\\[32m[=>].* *.*\\] [0-9]+/[0-9]+.*; amplitude [0-9.]+: [a-z(].* "
                                   "[0-9]+ of [0-9]+, [0-9.]+ % \\[[0-9.]+, [0-9.]+\\]\x1b\\[K"));
  EXPECT_THAT(shown, HasSubstr("\r\x1b[Krocking: ")) << "the line is left as it was found";
}

TEST_F(PseudoTerminal, ShowsNoColourWhereNoneIsWanted) {
  const std::string shown = seen(120, "run quick.json -o out", "NO_COLOR=1");
  EXPECT_THAT(shown, AllOf(HasSubstr("\r["), Not(HasSubstr("\x1b[3")), Not(HasSubstr("\x1b[0m"))));
  EXPECT_THAT(seen(120, "run quick.json -o other", "NO_COLOR="), HasSubstr("\x1b[32m")) << "empty is not set";
}

TEST_F(PseudoTerminal, ShowsNoShareOfASearchWhoseEndIsNotKnown) {
  auto calm = quick_experiment();
  calm["fluctuation"] = rocking::Json::object();
  calm.erase("friction");
  calm["realisations"] = 1;
  calm["sweep"] = rocking::Json::parse(R"([{ "parameter": "/excitation/amplitude", "values": [1.5, 2.0] }])");
  write("calm.json", calm.dump());
  EXPECT_THAT(seen(120, "orbits calm.json --periods 1 --branches 2 -o out", "NO_COLOR=1"),
              AllOf(HasSubstr("/2, "), HasSubstr("; then points of branches"), Not(HasSubstr("remaining")),
                    Not(HasSubstr("\r["))));  // no bar
  EXPECT_THAT(seen(120, "orbits calm.json --periods 1 --no-branches -o without", "NO_COLOR=1"),
              AllOf(HasSubstr("\r["), HasSubstr("/2, "), Not(HasSubstr("points of branches"))));
}

// All is drawn once, and the block never overturns: there are hundreds of stages of the search.
TEST_F(PseudoTerminal, ShowsProgressOfRareAlsoInPilotRuns) {
  auto once = quick_experiment();
  once.erase("fluctuation");
  once["block"]["width_m"] = {{"normal", {{"mean", 1.0}, {"sigma", 0.01}}}};
  once["sweep"][0]["values"] = {2.0};
  write("once.json", once.dump());
  const std::string shown = seen_until("[0-9]+ realisations so far, [0-9]+/s", "rare once.json -o out -j 1");
  EXPECT_THAT(shown, ContainsRegex("[0-9]+ realisations so far, [0-9]+/s"));
  EXPECT_THAT(shown, Not(HasSubstr("0/0")));
}

TEST_F(PseudoTerminal, ShowsARunBeforeItsFirstRealisation) {
  EXPECT_THAT(seen(120, "run quick.json -o out", "NO_COLOR=1"), HasSubstr("0/12, "));
}

TEST_F(PseudoTerminal, IsNeverWrappedByProgress) {
  for (const int columns : {2, 12, 40, 80}) {
    const std::string shown =
        seen(columns, "run quick.json --overwrite -o out" + std::to_string(columns), "NO_COLOR=1");
    const auto lines = all_matches(shown, "\r([^\r\n\x1b]+)\x1b\\[K");
    ASSERT_THAT(lines, Not(IsEmpty())) << columns;
    for (const std::string& line : lines) EXPECT_LT(line.size(), static_cast<std::size_t>(columns)) << line;
  }
}

TEST_F(PseudoTerminal, IsLeftAloneWhereItCannotRewriteOrIsAskedNotTo) {
  EXPECT_THAT(seen(80, "run quick.json -o a", "TERM=dumb"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(seen(80, "run quick.json -o b --no-progress"), Not(HasSubstr("\x1b")));
  EXPECT_EQ(seen(80, "run quick.json -o c -q"), "");
  EXPECT_THAT(rocking("run quick.json -o d").errors, Not(AnyOf(HasSubstr("\x1b"), HasSubstr(" of 12 "))));
}

TEST_F(PseudoTerminal, SeesBarsInTheTableInTheLettersOfItsLocale) {
  auto two_modes = quick_experiment();
  two_modes["sweep"][0]["values"] = {0.5, 4.2};  // the first value never lifts
  write("two.json", two_modes.dump());
  EXPECT_THAT(printed(120, "run two.json -o out", "LC_ALL=C.UTF-8"),
              AllOf(HasSubstr("█ rest"), HasSubstr("  ████████")));
  const auto again = [this](const std::string& locale) { return printed(120, "report out --format text", locale); };
  EXPECT_THAT(again("LC_ALL=C.UTF-8"), HasSubstr("█ rest"));
  EXPECT_THAT(again("LC_ALL=C"), AllOf(HasSubstr("# rest"), HasSubstr("  ########"), Not(HasSubstr("█"))));
  EXPECT_THAT(again("LC_ALL=no_SUCH.UTF-8"), HasSubstr("# rest"));
  EXPECT_THAT(rocking("report out --format text").output, AllOf(HasSubstr("  rest"), Not(HasSubstr("shares"))));
}

TEST_F(PseudoTerminal, SeesATableNoWiderThanItself) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  for (const int columns : {40, 60, 80}) {
    std::istringstream lines(printed(columns, "report out --format text", "LC_ALL=C"));
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), static_cast<std::size_t>(columns) + 1) << line << "and a carriage return";
  }
}

TEST_F(PseudoTerminal, SeesABifurcationInSteps) {
  EXPECT_THAT(seen(80, "bifurcation quick.json -o out"), HasSubstr("/9"));
}

TEST_F(Terminal, GetsHelpOnEveryCommandWithAnExample) {
  EXPECT_GT(commands().size(), 12U);
  for (const std::string& command : commands()) {
    const Outcome help = rocking(command + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_EQ(help.errors, "") << command;
    EXPECT_THAT(help.output,
                AnyOf(HasSubstr("\nExample: rocking " + command), HasSubstr("\nExample: eval \"$(rocking " + command)));
    std::istringstream lines(help.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 125U) << command << ": " << line;
  }
}

TEST_F(Terminal, IsToldByTheDocumentsWhatHelpTells) {
  if (shell("command -v python3").exit_code != 0) GTEST_SKIP() << "python3 was not found (Debian: python3)";
  const std::string document = ROCKING_SOURCE_DIR "/lib/docs/commands.md";
  const std::string script = ROCKING_SOURCE_DIR "/experiments/rocking/flag_tables";
  ASSERT_EQ(shell("cp '" + document + "' commands.md").exit_code, 0);
  const Outcome outcome = shell("'" + script + "' '" ROCKING_PROGRAM "' commands.md");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(shell("diff '" + document + "' commands.md").output, "")
      << "experiments/rocking/flag_tables build/release/rocking lib/docs/commands.md";
}

TEST_F(Terminal, IsCompletedWithCommandsFlagsAndChoices) {
  EXPECT_THAT(offered("rocking "), IsSupersetOf({"run", "resume", "check-normal", "--version"}));
  EXPECT_EQ(offered("rocking bif"), std::vector<std::string>{"bifurcation"});
  EXPECT_EQ(offered("rocking run --dr"), std::vector<std::string>{"--dry-run"});
  EXPECT_THAT(offered("rocking run quick.json --se"), Contains("--seed"));
  EXPECT_EQ(offered("rocking check-normal --sampler b"), std::vector<std::string>{"box-muller"});
  EXPECT_EQ(offered("rocking check-normal --sampler = z"), std::vector<std::string>{"ziggurat"});
  EXPECT_EQ(offered("rocking schema rep"), std::vector<std::string>{"report"});
  EXPECT_THAT(offered("rocking run --seed "), IsEmpty());
}

TEST_F(Terminal, IsCompletedWithFilesAndFoldersWhereTheyBelong) {
  ASSERT_EQ(shell("mkdir 'out one' other; touch notes.txt").exit_code, 0);
  EXPECT_THAT(offered("rocking run q"), std::vector<std::string>{"quick.json"});
  EXPECT_THAT(offered("rocking run "),
              AllOf(IsSupersetOf({"quick.json", "out one", "other"}), Not(Contains("notes.txt"))));
  EXPECT_EQ(offered("rocking resume ot"), std::vector<std::string>{"other"});
  EXPECT_EQ(offered("rocking run quick.json -o ot"), std::vector<std::string>{"other"});
  EXPECT_EQ(offered("rocking resume whole ot"), std::vector<std::string>{"other"});
}

TEST_F(Terminal, IsCompletedForEveryCommand) {
  for (const std::string& command : commands()) EXPECT_THAT(offered("rocking " + command + " --h"), Contains("--help"));
}

TEST_F(Terminal, IsToldWhatWasProbablyMeant) {
  const std::map<std::string, std::string> meant{{"rnu quick.json", "run"},
                                                 {"--vesrion", "--version"},
                                                 {"run quick.json --sed 4", "--seed"},
                                                 {"run quick.json --realisation=4", "--realisations"},
                                                 {"check-normal --sampler ziggurrat", "ziggurat"},
                                                 {"schema reprot", "report"},
                                                 {"completion bsh", "bash"}};
  for (const auto& [written, right] : meant) {
    const Outcome outcome = rocking(written);
    EXPECT_EQ(outcome.exit_code, 64) << written;
    EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"" + right + "\"?"));
  }
  EXPECT_THAT(rocking("completion tcsh").errors, AllOf(HasSubstr("bash"), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(rocking("run quick.json --sed 4").errors, HasSubstr("Try `rocking run --help`."));
  for (const auto& [written, right] : std::map<std::string, std::string>{
           {"help", "--help"}, {"version", "--version"}, {"plot out", "report"}, {"simulate quick.json", "run"}}) {
    EXPECT_THAT(rocking(written).errors, HasSubstr("that is `rocking " + right + "`"));
  }
}

TEST_F(Terminal, KnowsFormerCommandsAndTellsTheirNames) {
  for (const char* flags : {"-o part1 --shard 1/2", "-o part2 --shard 2/2", "-o out"}) {
    ASSERT_EQ(rocking(std::string("run quick.json -q --no-page ") + flags).exit_code, 0);
  }
  for (const auto& [former, now] : std::map<std::string, std::string>{
           {"status out", "run --status out"},
           {"merge whole part1 part2 --overwrite --no-page", "resume whole part1 part2 --overwrite --no-page"},
           {"replay out --condition 1 --realisation 2", "trajectory out --condition 1 --realisation 2"},
           {"figure one.json -o drawn", "report one.json -o drawn"}}) {
    if (former.starts_with("figure")) write("one.json", rocking("trajectory quick.json").output);
    const Outcome by_former = rocking(former), by_now = rocking(now);
    EXPECT_EQ(by_former.exit_code, 0) << former;
    EXPECT_EQ(by_former.output, by_now.output);
    EXPECT_THAT(by_former.errors, HasSubstr("is now `rocking " + now.substr(0, now.find(' '))));
    EXPECT_THAT(by_now.errors, Not(HasSubstr("is now")));
    EXPECT_EQ(rocking(former.substr(0, former.find(' ')) + " --help").exit_code, 0) << former;
  }
}

TEST_F(Terminal, IsToldWhichFlagsWouldBeIgnored) {
  ASSERT_EQ(rocking("run quick.json -q --no-page -o out").exit_code, 0);
  for (const char* command : {"run --status out --seed 3", "run --status out -o other", "run quick.json --status out",
                              "resume whole out -j 2", "resume whole out --max-time 1h", "resume whole out --levels 1",
                              "report out --from 3", "report one.json -o drawn --format csv"}) {
    EXPECT_EQ(rocking(command).exit_code, 64) << command;
  }
  EXPECT_EQ(rocking("run --status out --json -q").exit_code, 0);
}

TEST_F(Terminal, TakesAFileOfARunForItsFolder) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  for (const char* file : {"report.json", "report.html", "realisations.sqlite"}) {
    EXPECT_EQ(rocking(std::string("verify -q out/") + file).exit_code, 0) << file;
  }
  EXPECT_EQ(rocking("trajectory out/report.json --condition 1 --realisation 2").output,
            rocking("trajectory out --condition 1 --realisation 2").output);
  // An experiment beside a report stays an experiment.
  ASSERT_EQ(shell("cp quick.json out/").exit_code, 0);
  EXPECT_EQ(rocking("trajectory out/quick.json --periods 3").exit_code, 0);
}

TEST_F(Terminal, HasCompletionsThatZshAndFishCanRead) {
  for (const std::string name : {"zsh", "fish"}) {
    const Outcome script = rocking("completion " + name);
    EXPECT_EQ(script.exit_code, 0);
    for (const std::string& command : commands()) EXPECT_THAT(script.output, HasSubstr(command)) << name;
    EXPECT_THAT(script.output, AllOf(HasSubstr("dry-run"), HasSubstr("box-muller")));
    if (shell("command -v " + name).exit_code != 0) continue;
    write("script", script.output);
    const Outcome check = shell(name + " -n script");
    EXPECT_EQ(check.exit_code, 0) << check.errors;
  }
}

TEST_F(Terminal, InterruptsABifurcationCleanlyAndIsToldHowToBeginAnew) {
  auto endless = quick_experiment();
  endless["horizon"]["transient_periods"] = 100'000'000;
  write("endless.json", endless.dump());
  for (const std::string signal : {"INT", "TERM"}) {
    const std::string folder = "out" + signal;
    const Outcome outcome =
        shell(in_background("bifurcation endless.json -o " + folder) + "kill -" + signal + " $child; wait $child");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("The same command starts again"));
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / folder));
  }
}

}  // namespace

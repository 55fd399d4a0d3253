// Changed copies of files that rocking wrote: every command that reads them uses them or refuses them by name.

#include <functional>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "fuzz/file_targets.hpp"
#include "fuzz/mutate_json.hpp"

namespace {

using rocking::Json;
using rocking::fuzz::JsonMutator;
using rocking::fuzz::Reading;
using rocking::fuzz::sealed;
using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int mutations = 300;

class ChangedFiles : public rocking::support::ProgramTest {
 protected:
  std::string report_of_a_run(const Json& experiment) const {
    write("quick.json", experiment.dump());
    const Outcome outcome = rocking("run quick.json -o out -q");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return read("out/report.json");
  }

  std::string printed(const std::string& arguments) const {
    const Outcome outcome = rocking(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.errors;
    return outcome.output;
  }
};

/// Tests that every change of `text` is used or refused; returns how many were refused.
int refused(const std::string& text, const std::function<Reading(const std::string&)>& use) {
  EXPECT_EQ(use(text), Reading::used);
  const Json document = Json::parse(text);
  int count = 0;
  for (int seed = 0; seed < mutations; ++seed) {
    JsonMutator mutator(static_cast<std::uint64_t>(seed));
    const std::string changed =
        seed % 4 == 0 ? mutator.damaged_text(text)
                      : sealed(mutator.damaged(document)).dump(1, ' ', false, Json::error_handler_t::replace);
    try {
      if (use(changed) == Reading::refused) ++count;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
  }
  return count;
}

Reading use_report(const std::string& text) { return rocking::fuzz::try_report(text); }
Reading use_output(const std::string& text) { return rocking::fuzz::try_output(text); }

TEST_F(ChangedFiles, ThatAreReportsAreUsedOrRefused) {
  const std::string report = report_of_a_run(quick_experiment());
  EXPECT_GT(refused(report, use_report), mutations / 2);
  refused(report, [](const std::string& text) { return rocking::fuzz::try_claims(text); });
}

TEST_F(ChangedFiles, ThatAreReportsOfGridsAreUsedOrRefused) {
  Json experiment = quick_experiment();
  experiment["sweep"] = Json::parse(R"([ { "parameter": "/friction", "values": [ {"static": 0.4, "kinetic": 0.3},
      {"static": 0.5, "kinetic": 0.3} ] }, { "parameter": "/confidence", "values": [0.9, 0.99] } ])");
  EXPECT_GT(refused(report_of_a_run(experiment), use_report), mutations / 2);
}

TEST_F(ChangedFiles, ThatCommandsPrintedAreDrawnOrRefused) {
  printed("bifurcation quick.json -o b -q");
  Json experiment = quick_experiment();
  experiment["realisations"] = 20;
  report_of_a_run(experiment);
  for (const std::string& text : {printed("trajectory quick.json --periods 4 --samples 10"), read("b/bifurcation.json"),
                                  printed("fragility out --json"), printed("check-normal --n 1000 --json"),
                                  printed("cost quick.json --sample 2 --json -q --no-progress")}) {
    EXPECT_GT(refused(text, use_output), mutations / 4) << text.substr(0, 60);
  }
}

TEST_F(ChangedFiles, AreRefusedWithTheFileTheLineAndThePointer) {
  const std::string text = report_of_a_run(quick_experiment());
  std::filesystem::remove(folder_ / "out/realisations.sqlite");  // it is compared first
  const auto complaint = [&](const std::function<void(Json&)>& change) {
    Json report = Json::parse(text);
    change(report);
    write("out/report.json", sealed(report).dump(2));
    const Outcome outcome = rocking("report out --format html,csv,text");
    EXPECT_EQ(outcome.exit_code, 65) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("out/report.json, line "));
    return outcome.errors;
  };
  Json::json_pointer first("/result/conditions/0");
  EXPECT_THAT(complaint([&](Json& report) { report[first]["parameters"]["/seed"] = 1; }),
              HasSubstr("/result/conditions/0/parameters"));
  EXPECT_THAT(complaint([&](Json& report) { report[first]["parameters"] = Json::object(); }),
              HasSubstr("/result/conditions/0/parameters"));
  EXPECT_THAT(complaint([](Json& report) { report["result"].erase("digest"); }), HasSubstr("/result"));
  EXPECT_THAT(complaint([](Json& report) { report["system"].erase("threads"); }), HasSubstr("/system"));
  EXPECT_THAT(complaint([&](Json& report) { report[first]["validity"].erase("clamped"); }),
              HasSubstr("/result/conditions/0/validity"));
  EXPECT_THAT(complaint([&](Json& report) { report[first]["counts"]["(1,1)"] = 77; }),
              HasSubstr("/result/conditions/0/counts"));
  EXPECT_THAT(complaint([](Json& report) { report["input"]["experiment"]["friction"]["static"] = "<script>"; }),
              HasSubstr("/input/experiment/friction/static"));
  EXPECT_THAT(complaint([](Json& report) { report["input"]["experiment"]["fluctuation"]["\x1b[31m<b>"] = 1; }),
              AllOf(HasSubstr("/input/experiment/fluctuation"), Not(HasSubstr("\x1b"))));
  EXPECT_THAT(complaint([](Json& report) { report["result"]["conditions"].erase(1); }),
              HasSubstr("/result/conditions"));
}

TEST_F(ChangedFiles, WithAnExperimentOfAnotherDigestAreRefused) {
  Json report = Json::parse(report_of_a_run(quick_experiment()));
  report["input"]["experiment"]["title"] = "another";
  EXPECT_EQ(use_report(report.dump()), Reading::refused);
  EXPECT_EQ(use_report(sealed(report).dump()), Reading::used);
}

}  // namespace

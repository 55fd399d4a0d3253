// `rocking rare`: probabilities of rare overturning.

#include <cmath>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/studies/rare/study.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Rare : public rocking::support::ProgramTest {
 protected:
  Rare() {
    Json experiment = quick_experiment();
    experiment.erase("friction");
    experiment["fluctuation"] = {{"amplitude", {{"sigma", 0.5}}}};
    experiment["horizon"] = {{"transient_periods", 5}, {"sampled_periods", 10}};
    experiment["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "values": [4.2, 5.0]}])");
    write("quick.json", experiment.dump());
  }

  /// Options with which it is quick.
  static constexpr const char* quickly = " --particles 40 --relative-error 1 --event 'tilt > 0.5 psi' --no-progress ";

  /// Two records, of which the second is the stronger one.
  [[nodiscard]] Json suite_experiment() {
    for (const double strength : {2.0, 3.0}) {
      std::string record;
      for (int i = 0; i < 80; ++i) record += std::to_string(strength * std::sin(0.06 * i)) + "\n";
      write("record" + std::to_string(static_cast<int>(strength)) + ".txt", record);
    }
    Json experiment = quick_experiment();
    experiment.erase("friction");
    experiment["block"]["width_m"] = {{"normal", {{"mean", 1.0}, {"sigma", 0.12}}}};
    experiment["fluctuation"] = {{"restitution", {{"sigma", 0.05}}}};
    experiment["excitation"] = {{"kind", "recorded"}, {"suite", "record*.txt"}, {"time_step_s", 0.01}};
    experiment["horizon"] = {{"transient_periods", 0}, {"sampled_periods", 3}};
    experiment.erase("sweep");
    return experiment;
  }
};

TEST_F(Rare, IsWrittenAndPrinted) {
  const auto outcome = rocking(std::string("rare quick.json -o out") + quickly);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("quick"), HasSubstr("amplitude"), HasSubstr("probability"),
                                    HasSubstr("tilts beyond 0.5 psi (7.02 degrees) within"), HasSubstr("out/rare.json"),
                                    HasSubstr("plain sampling")));
  const std::string text = read("out/rare.json");
  EXPECT_EQ(objections("rare", text), "");
  const Json json = Json::parse(text);
  ASSERT_EQ(json["conditions"].size(), 2U);
  for (const Json& condition : json["conditions"]) {
    const auto probability = condition["probability"].get<double>();
    EXPECT_LE(condition["interval"][0].get<double>(), probability);
    EXPECT_GE(condition["interval"][1].get<double>(), probability);
    EXPECT_GT(condition["work"].get<double>(), 0.0);
    EXPECT_EQ(condition["method"], "twisted_run");
    double sum = 0.0;
    for (const Json& repetition : condition["repetitions"]) sum += repetition[0].get<double>();
    EXPECT_NEAR(sum / static_cast<double>(condition["repetitions"].size()), probability, 1e-12);
    EXPECT_TRUE(condition["levels"].empty());
  }
}

TEST_F(Rare, HasTheSameBytesOnAnyNumberOfThreadsAndAsJson) {
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o one -j 1") + quickly).exit_code, 0);
  const auto printed = rocking(std::string("rare quick.json -q -o two -j 3 --json") + quickly);
  EXPECT_EQ(printed.output, read("one/rare.json"));
  EXPECT_EQ(read("two/rare.json"), read("one/rare.json"));
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o three --seed 5") + quickly).exit_code, 0);
  EXPECT_NE(Json::parse(read("three/rare.json"))["digest"], Json::parse(read("one/rare.json"))["digest"]);
}

TEST_F(Rare, GoesOnFromWhatAnEarlierCallHasFinished) {
  ASSERT_EQ(rocking("rare quick.json -q -o all --particles 40 --relative-error 0.2 --event 'tilt > 0.5 psi'").exit_code,
            0);
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o part") + quickly).exit_code, 0);
  ASSERT_NE(read("part/rare.json"), read("all/rare.json"));
  const std::string more = " --particles 40 --relative-error 0.2 --event 'tilt > 0.5 psi' --resume";
  const auto outcome = rocking("rare quick.json -q -o part" + more);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(read("part/rare.json"), read("all/rare.json"));
  const auto other = rocking("rare quick.json -q -o part --seed 6" + more);
  EXPECT_EQ(other.exit_code, 65);
  EXPECT_THAT(other.errors, HasSubstr("/input: is not that of the earlier estimate"));
  write("part/rare.json", "{ \"format\": \"rocking.rare/1\",\n  \"seed\": }");
  const auto damaged = rocking("rare quick.json -q -o part" + more);
  EXPECT_EQ(damaged.exit_code, 65);
  EXPECT_THAT(damaged.errors, AllOf(HasSubstr("part/rare.json"), HasSubstr("line 2"), Not(HasSubstr("quick.json")),
                                    HasSubstr("`--overwrite` without `--resume` begins anew")));
}

// Each is killed when it has written its first repetitions; a file with fewer is never put in place of one with more.
TEST_F(Rare, LosesToAKillOnlyItsLastSeconds) {
  const std::string options = " -q -j 1 --particles 40 --event 'tilt > 0.5 psi' --relative-error ";
  ASSERT_EQ(rocking("rare quick.json -o all" + options + "0.05").exit_code, 0);
  const auto repetitions = [&] {
    std::size_t count = 0;
    const Json file = Json::parse(read("out/rare.json"));
    for (const Json& condition : file["conditions"]) {
      count += condition["repetitions"].size();
    }
    return count;
  };
  const std::string endless = "rare quick.json -o out" + options + "0.001";
  std::size_t before = 0;
  for (const char* resume : {"", " --resume", " --resume"}) {
    const auto killed =
        shell(in_background(endless + resume, "test out/rare.json -nt script") + "kill -9 $child; wait $child");
    EXPECT_EQ(killed.exit_code, 137) << killed.errors;
    EXPECT_EQ(objections("rare", read("out/rare.json")), "");
    EXPECT_GT(repetitions(), before);
    before = repetitions();
  }
  EXPECT_EQ(rocking("rare quick.json -o out" + options + "0.05").exit_code, 74) << "without --resume";
  EXPECT_EQ(rocking("rare quick.json -o out" + options + "0.05 --resume").exit_code, 0);
  EXPECT_EQ(read("out/rare.json"), read("all/rare.json"));
}

// A stop before a condition is reached again keeps what it had.
TEST_F(Rare, KeepsEarlierRepetitionsOfConditionsThatItDoesNotReach) {
  const std::string options =
      "rare quick.json -o out -q -j 1 --particles 200 --event 'tilt > 0.6 psi' --relative-error ";
  ASSERT_EQ(rocking(options + "0.5").exit_code, 0);
  const Json first = Json::parse(read("out/rare.json"))["conditions"];
  ASSERT_EQ(rocking(options + "0.001 --resume --max-time 0.001s").exit_code, 0);
  const Json second = Json::parse(read("out/rare.json"))["conditions"];
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(second[i]["repetitions"], first[i]["repetitions"]);
    EXPECT_EQ(second[i]["probability"], first[i]["probability"]);
    EXPECT_EQ(second[i]["ended"], "out_of_time");
  }
  EXPECT_EQ(rocking("verify out").exit_code, 0);
}

TEST_F(Rare, HasOneProbabilityForASuiteOfRecords) {
  write("suite.json", suite_experiment().dump());
  const auto outcome = rocking("rare suite.json -o out --particles 100 --relative-error 1 --event 'tilt > 0.3 psi'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("Under one of the records of the suite"));
  EXPECT_EQ(objections("rare", read("out/rare.json")), "");
  const Json json = Json::parse(read("out/rare.json"));
  ASSERT_EQ(json["suites"].size(), 1U);
  const Json& suite = json["suites"][0];
  EXPECT_EQ(suite["records"], 2);
  const double mean =
      0.5 * (json["conditions"][0]["probability"].get<double>() + json["conditions"][1]["probability"].get<double>());
  EXPECT_NEAR(suite["probability"].get<double>(), mean, 1e-15);
  EXPECT_GT(mean, 0.0);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
}

TEST_F(Rare, IsDrawnAlsoOnThePageOfItsRun) {
  ASSERT_EQ(rocking("run quick.json -o out -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o out") + quickly).exit_code, 0);
  EXPECT_EQ(rocking("report out/rare.json -o drawn").exit_code, 0);
  EXPECT_TRUE(exists("drawn/rare_paths.tsv"));
  EXPECT_THAT(read("drawn/rare_committor.tsv"), HasSubstr("tilt_from"));
  EXPECT_EQ(rocking("report out --format html -q").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), AllOf(HasSubstr("id=\"rare_committor\""), HasSubstr("id=\"rare_paths\"")));
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o out --overwrite --seed 5") + quickly).exit_code, 0);
  const auto other = rocking("report out --format html");
  EXPECT_THAT(other.errors, HasSubstr("another experiment"));
  EXPECT_THAT(read("out/report.html"), ::testing::Not(HasSubstr("rare_committor")));
}

// Each use of the file refuses it; `verify` says what is wrong.
TEST_F(Rare, IsNotVerifiedWithAChangedRepetition) {
  const std::string options = std::string("rare quick.json -q -o out") + quickly;
  ASSERT_EQ(rocking(options).exit_code, 0);
  Json json = Json::parse(read("out/rare.json"));
  Json& estimate = json["conditions"][1]["repetitions"][5][0];
  estimate = 1.25 * estimate.get<double>();
  write("out/rare.json", json.dump());
  EXPECT_THAT(rocking("verify out").output, HasSubstr("/conditions/1/probability is"));
  const auto outcome = rocking("verify out --json --sample 32");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("/conditions/1/repetitions/5/0 is"));
  const auto resumed = rocking(options + "--resume");
  EXPECT_EQ(resumed.exit_code, 65);
  EXPECT_THAT(resumed.errors, HasSubstr("/digest"));
  EXPECT_EQ(Json::parse(read("out/rare.json")), json) << "it is kept";
}

// A digit of what follows from the repetitions, of the digest, and of the experiment.
TEST_F(Rare, IsNotUsedWithAChangedDigit) {
  Json strong = Json::parse(read("quick.json"));
  strong["sweep"][0]["values"] = {6.0, 9.0};
  strong["realisations"] = 4;
  write("strong.json", strong.dump());
  write("hazard.csv", "amplitude, annual_rate\n1, 1e-2\n6, 1e-4\n12, 1e-6\n");
  ASSERT_EQ(rocking("run strong.json -o run -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o out") + quickly).exit_code, 0);
  const Json json = Json::parse(read("out/rare.json"));
  const std::string ask = "fragility run --hazard hazard.csv --event 'overturning,tilt > 0.5 psi' --rare out";
  ASSERT_EQ(rocking(ask).exit_code, 0);
  for (const char* pointer :
       {"/conditions/0/probability", "/conditions/1/interval/0", "/conditions/0/relative_error", "/digest",
        "/conditions/1/repetitions/3/0", "/input/sha256", "/input/experiment/block/width_m"}) {
    Json other = json;
    Json& value = other[Json::json_pointer(pointer)];
    value = value.is_string() ? Json(std::string(64, '0')) : Json(1.001 * value.get<double>());
    write("out/rare.json", other.dump());
    const auto outcome = rocking(ask);
    EXPECT_EQ(outcome.exit_code, 65) << pointer;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("rare.json"), HasSubstr("changed or damaged"))) << pointer;
    EXPECT_EQ(rocking("report out/rare.json -o drawn").exit_code, 65) << pointer;
    EXPECT_EQ(rocking(std::string("rare quick.json -q -o out --resume") + quickly).exit_code, 65) << pointer;
  }
}

// At the amplitude 4.2 the tilt exceeds 1e-6 in every realisation.
TEST_F(Rare, IsNotCertainOfAnEventThatAlwaysHappens) {
  const auto outcome = rocking("rare quick.json -q -o out --particles 40 --relative-error 1 --event 'tilt > 1e-6 psi'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(objections("rare", read("out/rare.json")), "");
  const Json sure = Json::parse(read("out/rare.json"))["conditions"][0];
  ASSERT_EQ(sure["probability"], 1.0);
  EXPECT_TRUE(sure["relative_error"].is_null());
  EXPECT_NEAR(sure["interval"][0].get<double>(), std::pow(0.025, 1.0 / 16.0), 1e-6);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
}

TEST_F(Rare, IsNotVerifiedWithOtherNumbersOrWithoutSense) {
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o out") + quickly).exit_code, 0);
  const Json json = Json::parse(read("out/rare.json"));
  const auto changed = [&](const char* pointer, const Json& value) {
    Json other = json;
    other[Json::json_pointer(pointer)] = value;
    write("out/rare.json", other.dump());
    return rocking("verify out");
  };
  EXPECT_EQ(changed("/conditions/0/work", 3.5).exit_code, 1);
  EXPECT_EQ(changed("/conditions/0/ended", "out_of_time").exit_code, 1);
  EXPECT_EQ(changed("/settings/particles", 41).exit_code, 1);
  EXPECT_THAT(changed("/input/experiment/block/width_m", 1.5).output, HasSubstr("digest of input.sha256"));
  EXPECT_THAT(changed("/conditions", Json::array()).output, HasSubstr("one estimate for each condition"));
  EXPECT_EQ(changed("/conditions/0/ended", "soon").exit_code, 65);
  EXPECT_EQ(rocking("verify nowhere").exit_code, 66);
}

TEST_F(Rare, HasNothingToVerifyWithoutRepetitions) {
  ASSERT_EQ(rocking("rare quick.json -q -o out --max-time 0.000001s").exit_code, 0);
  const auto outcome = rocking("verify out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "out/rare.json: has no repetition yet, so there is nothing to verify in it\n");
}

TEST_F(Rare, IsTheLowerTailOfAnAnnualRate) {
  Json strong = Json::parse(read("quick.json"));
  strong["sweep"][0]["values"] = {6.0, 9.0, 12.0};
  strong["realisations"] = 40;
  write("strong.json", strong.dump());
  write("hazard.csv", "amplitude, annual_rate\n1, 1e-2\n6, 1e-4\n12, 1e-6\n");
  ASSERT_EQ(rocking("run strong.json -o run -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking(std::string("rare quick.json -q -o tail") + quickly).exit_code, 0);
  const std::string ask = "fragility run --hazard hazard.csv --rare ";
  const auto outcome = rocking(ask + "tail --event 'overturning,tilt > 0.5 psi' --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(objections("fragility", outcome.output), "");
  const Json json = Json::parse(outcome.output);
  const Json& curve = json["curves"][1];
  const Json rare = Json::parse(read("tail/rare.json"))["conditions"];
  ASSERT_EQ(curve["rare"].size(), 2U);
  EXPECT_EQ(curve["rare"][0]["intensity"], 4.2);
  EXPECT_EQ(curve["rare"][1]["probability"], rare[1]["probability"]);
  EXPECT_EQ(curve["annual_rate"]["rare_below"], 9.0) << "the lowest level with ten events";
  EXPECT_FALSE(json["curves"][0].contains("rare")) << "another event";
  EXPECT_THAT(rocking(ask + "tail/rare.json --event 'overturning,tilt > 0.5 psi'").output, HasSubstr("rare estimates"));
  EXPECT_THAT(rocking(ask + "tail").errors, HasSubstr("no estimate of an event"));
  EXPECT_EQ(rocking(ask + "nowhere").exit_code, 66);
  Json other = Json::parse(read("quick.json"));
  other["block"]["width_m"] = 1.1;
  write("other.json", other.dump());
  ASSERT_EQ(rocking(std::string("rare other.json -q -o other") + quickly).exit_code, 0);
  EXPECT_THAT(rocking(ask + "other --event 'overturning,tilt > 0.5 psi'").errors, HasSubstr("same block"));
}

// A curve through both would be as steep as it likes there.
TEST_F(Rare, IsNotTheTailOfARateWhereAProbabilityIsEstimatedTwice) {
  write("hazard.csv", "amplitude, annual_rate\n1, 1e-2\n6, 1e-4\n12, 1e-6\n");
  ASSERT_EQ(rocking("run quick.json -o run -q --no-page").exit_code, 0);
  for (const auto& [key, values] :
       {std::pair{"/confidence", Json{0.9, 0.95}}, std::pair{"/realisations", Json{20, 30}}}) {
    Json twice = Json::parse(read("quick.json"));
    twice["sweep"].push_back({{"parameter", key}, {"values", values}});
    write("twice.json", twice.dump());
    ASSERT_EQ(rocking(std::string("rare twice.json -q -o twice --overwrite") + quickly).exit_code, 0);
    const auto outcome =
        rocking("fragility run --hazard hazard.csv --event 'overturning,tilt > 0.5 psi' --json --rare twice");
    EXPECT_EQ(outcome.exit_code, 65);
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("twice/rare.json"), HasSubstr("two estimates of one probability"),
                                      HasSubstr("/excitation/amplitude 4.2"), HasSubstr(key)));
  }
}

// The probabilities of the records differ: the mean with other weights is another number.
TEST_F(Rare, OfASuiteIsTheLowerTailOfItsAnnualRate) {
  Json experiment = suite_experiment();
  experiment["realisations"] = 40;
  experiment["sweep"] = {{{"parameter", "/excitation/scale"}, {"values", {1.0, 1.4, 2.0}}}};
  write("strong.json", experiment.dump());
  experiment["sweep"][0]["values"] = {0.75, 0.8};
  write("weak.json", experiment.dump());
  write("hazard.csv", "scale, annual_rate\n0.3, 1e-2\n1, 1e-4\n2, 1e-6\n");
  ASSERT_EQ(rocking("run strong.json -o run -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking("rare weak.json -q -o tail --particles 100 --relative-error 1 --event 'tilt > 0.3 psi'").exit_code,
            0);
  const std::string ask = "fragility run --hazard hazard.csv --event 'overturning,tilt > 0.3 psi' --json --rare ";
  const auto outcome = rocking(ask + "tail --figure drawn");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(objections("fragility", outcome.output), "");
  const Json json = Json::parse(outcome.output);
  const Json tail = Json::parse(read("tail/rare.json"));
  const Json& curve = json["curves"][1];
  ASSERT_EQ(curve["rare"].size(), 2U) << tail["suites"].dump();
  for (std::size_t level = 0; level < 2; ++level) {
    double sum = 0.0;
    for (const Json& condition : tail["conditions"]) {
      if (condition["parameters"]["/excitation/scale"] == curve["rare"][level]["intensity"]) {
        sum += condition["probability"].get<double>();
      }
    }
    EXPECT_NEAR(curve["rare"][level]["probability"].get<double>(), 0.5 * sum, 1e-15);
    double of_records = 0.0;
    for (const Json& record : curve["records"]) {
      for (const Json& rare : record.value("rare", Json::array())) {
        if (rare["intensity"] == curve["rare"][level]["intensity"]) of_records += rare["probability"].get<double>();
      }
    }
    EXPECT_NEAR(of_records, sum, 1e-15);
  }
  EXPECT_EQ(curve["annual_rate"]["rare_below"], 1.4) << "the lowest level with ten events";
  EXPECT_FALSE(json["curves"][0].contains("rare")) << "another event";
  EXPECT_THAT(read("drawn/fragility.svg"), HasSubstr("rare estimates"));
  Json part = tail;
  part["conditions"].erase(0);
  const auto& document = rocking::rare_document();
  write("part.json", document.text(document.read_unchecked(part)));  // with the digest of what is left
  EXPECT_THAT(rocking(ask + "part.json").errors, HasSubstr("does not fit the rest of the file"));
  experiment["excitation"]["suite"] = "record3*.txt";
  write("one.json", experiment.dump());
  ASSERT_EQ(rocking("rare one.json -q -o one --particles 100 --relative-error 1 --event 'tilt > 0.3 psi'").exit_code,
            0);
  EXPECT_THAT(rocking(ask + "one").errors, HasSubstr("same block"));
}

}  // namespace

// The calls of the library's interface that write or join files, or need more than an experiment.

#include "rocking/rocking.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/output/report.hpp"
#include "rocking/pages.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Interface : public ::testing::Test {
 protected:
  [[nodiscard]] static Experiment small_experiment(const std::string& keys = "") {
    return parse_experiment(R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
      "excitation": {"kind": "harmonic", "amplitude": 2, "frequency_ratio": 10, "phase_rad": {"uniform": [0, 6.28]}},
      "horizon": {"transient_periods": 5, "sampled_periods": 15}, "restitution": 0.9, "realisations": 12)" +
                            keys + "}");
  }

  /// The message of what `act` throws; empty if it throws nothing.
  template <class Act>
  [[nodiscard]] static std::string refusal(const Act& act) {
    try {
      act();
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "";
  }

  [[nodiscard]] fs::path in(const std::string& name) const { return folder_ / name; }
  /// Runs a part into a folder.
  [[nodiscard]] fs::path part(const std::string& name, std::optional<Shard> shard) const {
    Execution execution{.folder = in(name)};
    execution.shard = shard;
    static_cast<void>(run(small_experiment(), execution));
    return in(name);
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(Interface, JoinsPartsToTheBitsOfOneRun) {
  const std::vector<fs::path> parts{part("b", Shard{.part = 2, .parts = 2}), part("a", Shard{.part = 1, .parts = 2})};
  const StoredRun whole = merge(in("whole"), parts);
  ASSERT_TRUE(whole.run.is_complete());
  EXPECT_EQ(digest_of(whole.run), digest_of(run(small_experiment())));
}

TEST_F(Interface, RefusesPartsThatContradictEachOtherAndKeepsNothing) {
  const std::vector<fs::path> parts{part("a", {}), part("b", {})};
  {
    Store store = Store::open(parts[1] / "realisations.sqlite", sqlite::Access::write);
    Summary changed = *store.find({0, 7});
    changed.margin += 1.0;
    store.add({0, 7}, changed);
    store.close_up();
  }
  const std::string told = refusal([&] { static_cast<void>(merge(in("whole"), parts)); });
  EXPECT_THAT(told, HasSubstr("condition 0, realisation 7"));
  EXPECT_TRUE(fs::is_empty(in("whole")));
}

TEST_F(Interface, RefusesToMergeIntoAFolderWithARun) {
  const fs::path whole = part("a", {});
  EXPECT_THAT(refusal([&] { static_cast<void>(merge(whole, {whole})); }), HasSubstr("cannot be both"));
  EXPECT_THAT(refusal([&] { static_cast<void>(merge(whole, {part("b", {})})); }), HasSubstr("already contains a run"));
}

TEST_F(Interface, MergesInAFolderWhereAMergeWasKilled) {
  const fs::path whole = part("a", {});
  fs::create_directories(in("killed") / "replacement");
  for (const char* left : {"merging.sqlite", "merging.sqlite-wal", "merging.sqlite.new"}) {
    std::ofstream(in("killed") / "replacement" / left) << "part of a store";
  }
  EXPECT_TRUE(merge(in("killed"), {whole}).run.is_complete());
  const fs::directory_iterator files(in("killed"));
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "realisations.sqlite";
}

TEST_F(Interface, ExtendsARunToTheBitsOfALongOne) {
  const auto with = [](int realisations) {
    static const std::regex number(R"("realisations": ?12)");
    const std::string wanted = "\"realisations\": " + std::to_string(realisations);
    return parse_experiment(std::regex_replace(small_experiment().canonical_text, number, wanted));
  };
  ASSERT_EQ(with(17).conditions[0].realisations, 17U);
  static_cast<void>(run(with(12), {.folder = in("one")}));
  const RunResult longer = run(with(17), {.folder = in("one")});
  EXPECT_EQ(digest_of(longer), digest_of(run(with(17))));
  EXPECT_THAT(refusal([&] { static_cast<void>(run(with(12), {.folder = in("one")})); }), HasSubstr("17 realisations"));
  static_cast<void>(part("part", Shard{.part = 1, .parts = 2}));
  EXPECT_THAT(refusal([&] { static_cast<void>(run(with(17), {.folder = in("part")})); }),
              HasSubstr("merge the shards"));
}

// Each run looks, from its thread, whether another can begin in its folder.
TEST_F(Interface, RunsInOneFolderExcludeEachOther) {
  const fs::path whole = part("a", {});
  const Experiment experiment = small_experiment();
  int refused = 0;
  const auto look = [&](std::uint64_t, std::uint64_t) {
    for (const auto& other : {std::function<void()>([&] { static_cast<void>(run(experiment, {.folder = in("one")})); }),
                              std::function<void()>([&] { static_cast<void>(merge(in("one"), {whole})); })}) {
      try {
        other();
        ADD_FAILURE() << "both are at work in one folder";
      } catch (const std::system_error& error) {
        EXPECT_EQ(error.code(), std::errc::device_or_resource_busy);
        EXPECT_THAT(error.what(), HasSubstr("is working in this folder"));
        ++refused;
      }
    }
    return Decision::proceed;
  };
  const auto found = run(experiment, {.on_progress = look, .folder = in("one")});
  EXPECT_GT(refused, 0);
  EXPECT_EQ(digest_of(found), digest_of(run(experiment, {.folder = in("one")}))) << "the folder is free afterwards";
  EXPECT_FALSE(fs::exists(in("one") / ".lock"));
}

TEST_F(Interface, TellsOfProgressBeforeTheFirstRealisation) {
  std::vector<std::uint64_t> told;
  const auto look = [&told](std::uint64_t done, std::uint64_t) {
    told.push_back(done);
    return Decision::proceed;
  };
  const auto found = run(small_experiment(), Execution{.on_progress = look});
  ASSERT_GT(told.size(), 1U);
  EXPECT_EQ(told.front(), 0U);
  EXPECT_EQ(told.back(), found.all);
}

TEST_F(Interface, StopsATrajectoryAtARequest) {
  std::atomic<bool> stop{true};
  const Experiment experiment = small_experiment();
  EXPECT_THROW(static_cast<void>(trajectory(experiment, {}, {.stop = &stop})), base::Stopped);
  EXPECT_THROW(static_cast<void>(trajectory(experiment, {.samples_per_period = 5}, {.stop = &stop})), base::Stopped);
  const StoredRun stored{.experiment = experiment, .run = run(experiment)};
  EXPECT_THROW(static_cast<void>(replay(stored, {}, {.stop = &stop})), base::Stopped);
}

TEST_F(Interface, ComparesRunsInMemory) {
  const StoredRun first{.experiment = small_experiment(), .run = run(small_experiment())};
  const auto compared = compare(first, first).conditions;
  ASSERT_EQ(compared.size(), 1U);
  EXPECT_EQ(compared[0].realisations, 12U);
  EXPECT_EQ(compared[0].changed.counts.successes, 0U);
}

TEST_F(Interface, RefusesAnExperimentWithoutConditions) {
  const Experiment none;
  const RunResult some = run(small_experiment());
  const std::vector<std::function<void()>> calls{
      [&] { static_cast<void>(run(none)); },
      [&] { static_cast<void>(plan(none)); },
      [&] { static_cast<void>(trajectory(none, {})); },
      [&] { write_trajectory_page(none, {}, in("page.html")); },
      [&] { static_cast<void>(orbits(none)); },
      [&] { static_cast<void>(bifurcation(none, 0)); },
      [&] { static_cast<void>(rare_probabilities(none, {})); },
      [&] { static_cast<void>(fragility(none, some)); },
      [&] { static_cast<void>(verify(StoredRun{.experiment = none, .run = some})); }};
  for (std::size_t i = 0; i < calls.size(); ++i) EXPECT_THAT(refusal(calls[i]), HasSubstr("has no conditions")) << i;
  EXPECT_THROW(static_cast<void>(report(none, some)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(table(none, some)), std::invalid_argument);
}

TEST_F(Interface, RefusesARunThatNoCallHasReturned) {
  const Experiment swept = small_experiment(R"(, "sweep": [{"parameter": "/excitation/amplitude", "values": [3, 4]}])");
  const StoredRun none{.experiment = swept, .run = {}};
  const std::vector<std::function<void()>> calls{[&] { static_cast<void>(verify(none)); },
                                                 [&] { static_cast<void>(replay(none)); },
                                                 [&] { static_cast<void>(compare(none, none)); },
                                                 [&] { static_cast<void>(fragility(swept, none.run)); },
                                                 [&] { static_cast<void>(report(swept, none.run)); },
                                                 [&] { static_cast<void>(table(swept, none.run)); },
                                                 [&] { static_cast<void>(digest_of(none.run)); },
                                                 [&] { static_cast<void>(write_page(none, in("page.html"))); }};
  for (std::size_t i = 0; i < calls.size(); ++i) EXPECT_THROW(calls[i](), std::exception) << i;
}

TEST_F(Interface, ReadsTheBytesOfARunWithItsOwnExperiment) {
  const std::string bytes = bytes_of(run(small_experiment()));
  EXPECT_EQ(digest_of(run_of(small_experiment(), bytes)), digest_of(run(small_experiment())));
  const Experiment other = small_experiment(R"(, "title": "another")");
  EXPECT_THAT(refusal([&] { static_cast<void>(run_of(other, bytes)); }), HasSubstr("a run of another experiment"));
}

TEST_F(Interface, FollowsTheStepsOfADiagram) {
  const Experiment swept = small_experiment(R"(, "sweep": [{"parameter": "/excitation/amplitude", "values": [3, 1]}])");
  const auto found = bifurcation(swept, 2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].conditions, (std::vector<std::size_t>{1, 0})) << "by increasing value";
  EXPECT_EQ(found[0].branches.front()[0].points.size(), 15U);
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(bifurcation(swept, 2, {.stop = &stop})), base::Stopped);
}

TEST_F(Interface, VerifiesTheBitsOfARun) {
  const Experiment experiment = small_experiment();
  StoredRun stored{.experiment = experiment, .run = run(experiment)};
  EXPECT_EQ(verify(stored).checked, 12U);
  EXPECT_EQ(verify(stored, 4).checked, 4U);
  EXPECT_THAT(verify(stored).findings, ::testing::IsEmpty());
  EXPECT_EQ(replay(stored, {.realisation = 3}).strobe.size(), 20U);
  EXPECT_THAT(refusal([&] { static_cast<void>(replay(stored, {.realisation = 12})); }), HasSubstr("realisation"));
  EXPECT_THAT(refusal([&] { static_cast<void>(replay(stored, {.condition = 1})); }), HasSubstr("condition 1"));
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(verify(stored, {}, {.stop = &stop})), base::Stopped);

  stored.experiment.seed += 1;  // so that the stored bits are those of another experiment
  const RunCheck check = verify(stored);
  // Motions that start at rest and lift at the same phase of the base may have the same bits with either seed.
  const RunResult again = run(stored.experiment);
  std::uint64_t different = 0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    different += stored.run.store->find({0, i})->digest == again.store->find({0, i})->digest ? 0U : 1U;
  }
  EXPECT_GT(different, 0U);
  EXPECT_EQ(check.different, different);
  EXPECT_THAT(check.findings.at(0), HasSubstr("condition 0, realisation 0"));
  EXPECT_THROW(static_cast<void>(replay(stored)), DifferentBits);
}

TEST_F(Interface, VerifiesAFolderWithItsReport) {
  const Experiment experiment = small_experiment();
  const fs::path out = in("out");
  const RunResult result = run(experiment, {.folder = out});
  EXPECT_EQ(verify(out, 4).checked, 4U) << "without a report";
  std::string text = report(experiment, result);
  write_atomically(out / "report.json", text);
  EXPECT_THAT(verify(out).findings, ::testing::IsEmpty());
  Json of_earlier_program = Json::parse(text);
  of_earlier_program["result"].erase("findings");
  of_earlier_program["result"]["warnings"] = {"a sentence"};
  write_atomically(out / "report.json", of_earlier_program.dump());
  EXPECT_THAT(verify(out).findings, ::testing::IsEmpty());
  EXPECT_EQ(parse_report(of_earlier_program.dump()).conditions.size(), 1U);
  const std::size_t digest = text.find(digest_of(result));
  text[digest] = text[digest] == '0' ? '1' : '0';
  write_atomically(out / "report.json", text);
  EXPECT_THAT(verify(out, 4).findings, ::testing::ElementsAre(HasSubstr("report.json: ")));
  write_atomically(out / "report.json", report(small_experiment(R"(, "title": "other")"), result));
  const RunCheck other = verify(out);
  EXPECT_EQ(other.checked, 0U) << "the realisations are those of another experiment";
  EXPECT_THAT(other.findings, ::testing::ElementsAre(HasSubstr("another experiment")));
  EXPECT_THAT(refusal([&] { static_cast<void>(open_run(out)); }),
              AllOf(HasSubstr("out/report.json"), HasSubstr("out/realisations.sqlite"), HasSubstr("/title")));
  fs::remove(out / "realisations.sqlite");
  EXPECT_THAT(refusal([&] { static_cast<void>(run(experiment, {.folder = out})); }), HasSubstr("out/report.json"));
  EXPECT_EQ(verify(out).checked, 12U);
  EXPECT_THAT(refusal([&] { static_cast<void>(verify(out, 4)); }), HasSubstr("sample"));
  write_atomically(out / "report.json", "{}");
  EXPECT_THAT(refusal([&] { static_cast<void>(verify(out)); }), HasSubstr("report.json, line 1"));
}

TEST_F(Interface, EstimatesRareEventsAgain) {
  Experiment experiment = small_experiment();
  experiment.conditions[0].horizon = {.transient_periods = 1, .sampled_periods = 2};
  const RareQuestion request{.event = {rocking::EventName::tilt, 0.1}, .relative_error = 0.5, .particles = 20};
  std::uint64_t last = 0;
  std::uint64_t known = 0;
  const Execution execution{.on_progress = [&](std::uint64_t done, std::uint64_t all) {
    EXPECT_LE(last, done);
    EXPECT_TRUE(all == 0 || done <= all) << done << " of " << all;
    EXPECT_TRUE(all > 0 || known == 0) << "known before, and not any more";
    last = done;
    known = all;
    return Decision::proceed;
  }};
  const auto found = rare_probabilities(experiment, request, execution);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(last, known);
  EXPECT_GE(static_cast<double>(last) + 1.0, found[0].work);
  EXPECT_EQ(rare_probabilities(experiment, request, {.threads = 2}).at(0).probability, found[0].probability);
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(rare_probabilities(experiment, request, {.stop = &stop})), base::Stopped);
  EXPECT_THAT(refusal([&] { static_cast<void>(rare_probabilities(experiment, {.particles = 1})); }),
              HasSubstr("particles"));
}

TEST_F(Interface, InfersUnknownsFromCountedTests) {
  Experiment experiment = small_experiment(R"(, "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}])");
  InferQuestion request{.tests = {.groups = {{.name = "overturned", .modes = {{section::ResponseKind::overturned}}},
                                             {.name = "other", .modes = {}}},
                                  .conditions = {{.parameters = {{"/excitation/amplitude", 4.0}}, .counts = {1, 4}}}}};
  const Inference found = infer_unknowns(experiment, request, {.threads = 2});
  ASSERT_TRUE(found.answer);
  const std::vector<double>& shares = found.answer->predicted.at(0).shares;
  const double deviance = 2.0 * (std::log(1.0 / (5.0 * shares.at(0))) + 4.0 * std::log(4.0 / (5.0 * shares.at(1))));
  EXPECT_NEAR(found.answer->fit.statistic, deviance, 1e-9 * (1.0 + deviance));
  write_atomically(in("tests.csv"), "amplitude,overturned,other\n4,1,4\n");
  const Inference resumed =
      infer_unknowns(experiment, {.tests_file = in("tests.csv").string(), .earlier = found.design});
  ASSERT_TRUE(resumed.answer);
  EXPECT_EQ(resumed.realisations, found.realisations);
  EXPECT_EQ(resumed.answer->unknowns.at(0).estimate, found.answer->unknowns.at(0).estimate);
  EXPECT_EQ(resumed.answer->log_likelihood, found.answer->log_likelihood);
  request.next_tests = 0;
  EXPECT_THAT(refusal([&] { static_cast<void>(infer_unknowns(experiment, request)); }), HasSubstr("next_tests"));
  experiment.unknowns.clear();
  EXPECT_THAT(refusal([&] { static_cast<void>(infer_unknowns(experiment, request)); }), HasSubstr("/unknown"));
}

TEST_F(Interface, ExaminesRandomNumbersAndTheMachine) {
  const SamplerQuestion question{.n = 1000};
  EXPECT_EQ(check_normal(question).n, 1000U);
  EXPECT_THAT(refusal([] { static_cast<void>(check_normal({.sampler = "dice"})); }), HasSubstr("box-muller"));
  for (const base::ArithmeticCheck& check : check_arithmetic()) EXPECT_TRUE(check.passed) << check.name;
  EXPECT_EQ(check_arithmetic().size(), 5U);
}

/// What a file of a run with the responses of small_experiment() must have, by the end of its name.
void expect_content(const fs::path& file) {
  const std::map<std::string, std::vector<std::string>> parts{{".html", {"<svg", "(1,1)", "</html>"}},
                                                              {".svg", {"<svg", "<path", "</svg>"}},
                                                              {".gp", {"plot"}},
                                                              {".tsv", {"\t", "\n"}},
                                                              {".png", {"PNG", "IDAT", "IEND"}},
                                                              {".pdf", {"%PDF", "%%EOF"}},
                                                              {".csv", {",", "\n"}},
                                                              {".tex", {R"(\begin{tabular})"}}};
  const auto found = parts.find(file.extension().string());
  ASSERT_NE(found, parts.end()) << file << ": say what it must have";
  for (const std::string& part : found->second)
    EXPECT_THAT(read_file(file, std::size_t{1} << 24U), HasSubstr(part)) << file;
}

TEST_F(Interface, WritesTrajectoriesPagesAndFigures) {
  const Experiment experiment = small_experiment();
  const StoredRun stored{.experiment = experiment, .run = run(experiment)};
  const TrajectoryRequest request{.realisation = 2, .samples_per_period = 4};
  const std::string text = trajectory_text(request, trajectory(experiment, request));
  EXPECT_THAT(trajectory_csv(request, trajectory(experiment, request), TrajectoryUnits::si), HasSubstr("tilt_rad"));
  const auto label = realise(experiment.conditions[0], experiment.seed, 2).classification;
  EXPECT_EQ(Json::parse(text)["mode"], to_string(label.mode)) << "what a run calls it";
  EXPECT_EQ(Json::parse(text)["reason"], section::to_string(*label.reason));
  const auto part = trajectory(experiment, {.realisation = 2, .periods = 3});
  EXPECT_THAT(trajectory_text(request, part), Not(HasSubstr("\"mode\"")));
  const auto drawn = draw({{.name = "motion", .text = text}}, in("drawn"));
  for (const auto& written : {write_page(stored, in("page.html")),
                              write_figures(stored, in("figures"), {.pictures = {"svg", "png", "pdf", "gp"}}),
                              write_tables(stored, in("tables")), drawn}) {
    EXPECT_FALSE(written.files.empty());
    for (const fs::path& file : written.files) expect_content(file);
  }
  EXPECT_THAT(refusal([&] { static_cast<void>(draw({{.name = "none", .text = "{}"}}, in("drawn"))); }),
              HasSubstr("none"));
  EXPECT_THAT(refusal([&] { static_cast<void>(write_figures(stored, in("figures"), {.pictures = {"eps"}})); }),
              HasSubstr("svg, png, pdf or gp"));
  const Experiment made = experiment_of(experiment.conditions);
  EXPECT_THAT(refusal([&] {
                static_cast<void>(write_page({made, run(made)}, in("page.html")));
              }),
              HasSubstr("made in C++"));
  std::atomic<bool> stop{true};
  const Execution stopped{.stop = &stop};
  EXPECT_THROW(static_cast<void>(write_page(stored, in("page.html"), {}, stopped)), base::Stopped);
}

TEST_F(Interface, MeasuresCostByTheClocksOfItsCaller) {
  EXPECT_THROW(static_cast<void>(cost(small_experiment(), {}, {})), std::invalid_argument);
  double time = 0.0;
  double processor_time = 0.0;
  Execution with_clocks{.elapsed_seconds = [&time] { return time += 0.05; },
                        .processor_seconds = [&processor_time] { return processor_time += 1.0; }};
  const CostQuestion question{.seconds = 0.1, .sample = 3, .tolerances = {1e-6, 1e-14}};
  const Cost found = cost(small_experiment(), question, with_clocks);
  EXPECT_EQ(found.sample, 3U);
  EXPECT_EQ(found.curve.size(), 3U) << "with the experiment's own tolerance";
  EXPECT_GT(found.timing.seconds_per_period.front(), 0.0);
  std::atomic<bool> stop{true};
  with_clocks.stop = &stop;
  EXPECT_THROW(static_cast<void>(cost(small_experiment(), question, with_clocks)), base::Stopped);
}

}  // namespace
}  // namespace rocking

// Runs in folders: begun, resumed, extended, merged, and what is told of them.

#include "rocking/api/folder_run.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/rocking.hpp"
#include "rocking/text/files.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using base::FolderError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Property;
using ::testing::ThrowsMessage;

class FolderRuns : public ::testing::Test {
 protected:
  [[nodiscard]] static Experiment experiment() {
    return parse_experiment(R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
      "excitation": {"kind": "harmonic", "amplitude": 2, "frequency_ratio": 10, "phase_rad": {"uniform": [0, 6.28]}},
      "horizon": {"transient_periods": 5, "sampled_periods": 15}, "restitution": 0.9, "realisations": 12})");
  }

  /// A run that ends before it has that many realisations, or all of them.
  static void run_some(FolderRun begun, std::uint64_t most = 1000) {
    std::atomic<bool> stop{false};
    RunOptions options;
    options.stop_requested = &stop;
    options.on_progress = [&](std::uint64_t done, std::uint64_t) { stop = done >= most; };
    options.commit_is_due = [] { return true; };
    static_cast<void>(run_in_folder(begun, options));
  }

  [[nodiscard]] FolderMeans means() {
    return {.tell = [this](const std::string& notice) { told_.push_back(notice); }};
  }
  [[nodiscard]] fs::path in(const std::string& name) const { return folder_ / name; }

  std::vector<std::string> told_;

 private:
  support::TemporaryFolder folder_;
};

TEST_F(FolderRuns, TellHowFarTheyAre) {
  EXPECT_THROW(static_cast<void>(status_of(in("out"))), FolderError);
  {
    const FolderRun begun = begin_run(in("out"), experiment(), {}, means());
    EXPECT_EQ(status_of(in("out")).state, "running");
  }
  EXPECT_EQ(status_of(in("out")).state, "stopped");
  EXPECT_THAT(describe(status_of(in("out")), "out"), HasSubstr("done     0 of 12 realisations (0.0 %)\nmissing  12\n"));
  run_some(resume_run(in("out"), {}, means()));
  const RunStatus found = status_of(in("out"));
  EXPECT_EQ(found.missing(), 0U);
  EXPECT_EQ(found.state, "stopped") << "its report is not written";
  EXPECT_THAT(describe_as_json(found), HasSubstr(R"("done": 12)"));
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(FolderRuns, AreExtendedAndMergedToTheBitsOfOne) {
  run_some(begin_run(in("short"), experiment(), {}, means()));
  run_some(resume_run(in("short"), {.realisations = "20"}, means()));
  std::vector<fs::path> parts;
  for (const std::uint64_t part : {std::uint64_t{2}, std::uint64_t{1}}) {
    parts.push_back(in("part" + std::to_string(part)));
    run_some(begin_run(parts.back(), open_run(in("short")).experiment, {.shard = Shard{part, 2}}, means()));
  }
  const FolderRun whole = merge_runs(in("whole"), parts, false);
  EXPECT_EQ(complete_result(whole).digest, open_run(in("short")).run.result->digest);
  EXPECT_TRUE(whole.folder.is_replacement()) << "until its report is written";
}

TEST_F(FolderRuns, AreExtendedWhenTheyHaveAReport) {
  const Experiment short_one = experiment();
  const RunResult found = run(short_one, {.folder = in("out")});
  write_atomically(in("out") / "report.json", report(short_one, found));
  std::atomic<bool> stop{true};
  EXPECT_FALSE(resume(in("out"), {.realisations = "20"}, {.stop = &stop}).run.is_complete());
  EXPECT_EQ(digest_of(open_run(in("out")).run), digest_of(found)) << "it is kept until then";
  EXPECT_EQ(status_of(in("out")).missing(), 8U);
  const StoredRun extended = resume(in("out"));
  EXPECT_EQ(digest_of(extended.run), digest_of(run(extended.experiment)));
  EXPECT_EQ(digest_of(open_run(in("out")).run), digest_of(extended.run));
  EXPECT_FALSE(fs::exists(in("out") / "report.json"));
}

TEST_F(FolderRuns, AreNotReplacedUnlessAsked) {
  run_some(begin_run(in("out"), experiment(), {}, means()));
  EXPECT_THAT([&] { static_cast<void>(begin_run(in("out"), experiment(), {}, means())); },
              ThrowsMessage<FolderError>(HasSubstr("out: contains a run; `rocking resume ")));
  {
    const FolderRun other = begin_run(in("out"), experiment(), {.overwrite = true}, means());
    EXPECT_TRUE(other.folder.has_earlier_run());
    EXPECT_THAT([&] { static_cast<void>(resume_run(in("out"), {}, means())); },
                ::testing::Throws<FolderError>(Property(&FolderError::kind, FolderError::Kind::at_work)));
  }
  EXPECT_TRUE(open_run(in("out")).run.is_complete());
}

TEST_F(FolderRuns, TellOfWhatAKilledProcessLost) {
  fs::create_directories(in("out") / "replacement");
  static_cast<void>(begin_run(in("out"), experiment(), {}, means()));
  EXPECT_THAT(told_, ::testing::ElementsAre(HasSubstr("ended before its first realisation was stored")));
}

TEST_F(FolderRuns, AreRefusedWhereTheyDoNotFitTheMachine) {
  FolderMeans small = means();
  small.free_memory = 1;
  EXPECT_THROW(static_cast<void>(begin_run(in("out"), experiment(), {}, small)), std::system_error);
  EXPECT_FALSE(fs::exists(in("out")));
  small.is_limited = true;
  EXPECT_NO_THROW(static_cast<void>(begin_run(in("out"), experiment(), {}, small)));
}

TEST_F(FolderRuns, ReplayOneRealisation) {
  run_some(begin_run(in("out"), experiment(), {}, means()));
  EXPECT_EQ(replay(in("out"), {.realisation = 3}).strobe.size(), 20U);
  EXPECT_THAT([&] { static_cast<void>(replay(in("out"), {.realisation = 12})); },
              ThrowsMessage<FolderError>(HasSubstr("out contains no realisation 12 of condition 0")));
}

}  // namespace
}  // namespace rocking

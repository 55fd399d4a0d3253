// Runs every input of the corpora, and every input that once caused a failure. Needs no fuzzer.

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "fuzz/question_target.hpp"

namespace {

namespace fs = std::filesystem;

/// Runs the files of a folder of the corpus; returns their number.
int replay(const std::string& target, const std::function<void(std::string_view)>& play) {
  int played = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ROCKING_SOURCE_DIR) / "tests/fuzz/corpus" / target)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    SCOPED_TRACE(entry.path().string());
    EXPECT_NO_THROW(play(bytes));
    ++played;
  }
  return played;
}

TEST(FuzzCorpus, OfExperimentsHoldsNoSurprise) { EXPECT_GT(replay("experiment", rocking::fuzz::try_experiment), 40); }

TEST(FuzzCorpus, OfGroundMotionsHoldsNoSurprise) { EXPECT_GT(replay("record", rocking::fuzz::try_record), 20); }

TEST(FuzzCorpus, OfHazardCurvesHoldsNoSurprise) { EXPECT_GT(replay("hazard", rocking::fuzz::try_hazard), 15); }

TEST(FuzzCorpus, OfScenesHoldsNoSurprise) { EXPECT_GT(replay("scene", rocking::fuzz::try_scene), 10); }

TEST(FuzzCorpus, OfQuestionsHoldsNoSurprise) { EXPECT_GT(replay("question", rocking::fuzz::answer_question), 0); }

TEST(FuzzTargets, SeeWhatMustNotBe) {
  EXPECT_THROW(rocking::fuzz::demand(false, "sabotage"), rocking::fuzz::Finding);
  // A watch that receives an invalid state, and an event earlier than the last one.
  rocking::fuzz::Watch watch;
  rocking::dynamics::State state;
  state.tilt = std::nan("");
  EXPECT_THROW(watch.strobe(state), rocking::fuzz::Finding);
  watch.event(rocking::dynamics::EventKind::lift, 2.0, {});
  EXPECT_THROW(watch.event(rocking::dynamics::EventKind::lift, 1.0, {}), rocking::fuzz::Finding);
}

}  // namespace

// The experiments of this repository can be read, their canonical texts are their own, and none has a suspicious number, but
// for blocks as papers have them.

#include <filesystem>

#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

TEST(PublishedExperiment, IsValidUnsuspiciousAndItsCanonicalTextIsItsOwn) {
  int found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ROCKING_SOURCE_DIR "/experiments")) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "values.json") continue;
    const auto experiment = read_experiment_file(entry.path());
    const Surroundings beside_it{.files = files_seen_from(entry.path().parent_path())};
    EXPECT_EQ(experiment_in(experiment.canonical_text, {}, beside_it).canonical_text, experiment.canonical_text)
        << entry.path();
    const auto suspicious = suspicious_numbers(experiment);
    const bool is_of_papers = entry.path().parent_path().filename() == "published_results";
    EXPECT_TRUE(is_of_papers || suspicious.empty()) << entry.path() << suspicious.front().text;
    ++found;
  }
  EXPECT_GE(found, 10);
}

}  // namespace
}  // namespace rocking

// The account of false alarms is complete, documented and enforced.

#include "support/false_alarms.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace {

using namespace rocking::support;
namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string all_tests() {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(ROCKING_SOURCE_DIR "/tests")) {
    if (entry.path().extension() == ".cpp") text += text_of(entry.path());
  }
  return text;
}

TEST(FalseAlarms, AreAllowedToTestsThatExistOnly) {
  const std::string tests = all_tests();
  for (const Allowance& allowance : allowances) {
    std::string declared(allowance.test);
    declared.replace(declared.find('.'), 1, ", ");
    EXPECT_NE(tests.find('(' + declared + ')'), std::string::npos) << allowance.test;
  }
}

// Either the tests of a file use the account, or its first line says that nothing is left to chance.
TEST(FalseAlarms, AreAccountedForByEveryStatisticalTest) {
  for (const auto& entry : fs::recursive_directory_iterator(ROCKING_SOURCE_DIR "/tests/statistical")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = text_of(entry.path());
    const bool draws = text.find("FalseAlarms alarms;") != std::string::npos;
    const bool adds_up = text.find("no false alarm") != std::string::npos;
    EXPECT_NE(draws, adds_up) << entry.path();
  }
}

TEST(FalseAlarms, AreInTheDocumentsAsTheyAreCounted) {
  const std::string document = text_of(ROCKING_SOURCE_DIR "/reports/evidence/false-alarms.md");
  for (const Allowance& allowance : allowances) {
    const std::string row = "| `" + std::string(allowance.test) + "` | " + std::to_string(allowance.instances) + " x " +
                            std::to_string(allowance.comparisons) + " |";
    EXPECT_NE(document.find(row), std::string::npos) << row;
  }
  const std::string sum = "| all | " + std::to_string(all_comparisons()) + " |";
  EXPECT_NE(document.find(sum), std::string::npos) << sum;
}

TEST(FalseAlarms, AreNotGivenToWhomNoneAreAllowed) {
  EXPECT_NONFATAL_FAILURE(
      {
        FalseAlarms alarms;
        static_cast<void>(alarms.level());
      },
      "allows");
}

}  // namespace

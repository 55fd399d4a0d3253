// Published values of many sources, computed again as experiments/published_results/values.json says; its reader in
// Python, write.py, writes the same values to reports/evidence/published.md.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

const std::filesystem::path folder_of_values = ROCKING_SOURCE_DIR "/experiments/published_results";

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

/// Every value with the keys of its group, and its place in the list for %.
std::vector<Json> published_values() {
  std::vector<Json> values;
  const Json index = Json::parse(read_file(folder_of_values / "values.json"));
  for (const Json& group : index.at("groups")) {
    const Json& list = group.at("values");
    for (std::size_t i = 0; i < list.size(); ++i) {
      Json value = group;
      value.update(list[i]);
      for (const char* key : {"command", "at"})
        value[key] = replaced(value[key].get<std::string>(), "%", std::to_string(i));
      values.push_back(std::move(value));
    }
  }
  return values;
}

/// What the program prints; each command runs once.
const Json& output_of(const std::string& command) {
  static std::map<std::string, Json> known;
  if (const auto found = known.find(command); found != known.end()) return found->second;
  const support::TemporaryFolder folder;
  const std::string call = "cd '" + folder_of_values.string() + "' && '" ROCKING_PROGRAM "' " +
                           replaced(command, "OUT", (folder / "out").string()) + " --json -q >'" +
                           (folder / "printed").string() + "'";
  EXPECT_EQ(std::system(call.c_str()), 0) << call;
  return known[command] = Json::parse(read_file(folder / "printed"));
}

/// How far a number is from a published one, or from the interval of two.
double distance(double number, const Json& published) {
  const auto end = [&](std::size_t which) {
    return std::stod((published.is_array() ? published.at(which) : published).get<std::string>());
  };
  return std::max({end(0) - number, number - end(1), 0.0});
}

class PublishedResult : public ::testing::TestWithParam<Json> {};

TEST_P(PublishedResult, IsFoundAgain) {
  const Json& value = GetParam();
  const std::string claim = value.at("source").get<std::string>() + ", " + value.at("place").get<std::string>() + ": " +
                            value.at("quantity").get<std::string>() + ", " + value.at("of").get<std::string>();
  const Json& known = value.contains("independent") ? value.at("independent") : value.at("published");
  const Json& found = output_of(value.at("command")).at(Json::json_pointer(value.at("at").get<std::string>()));
  if (found.is_string()) {
    EXPECT_EQ(found, known) << claim;
    return;
  }
  const double ours = found.get<double>() * value.value("factor", 1.0);
  EXPECT_LE(distance(ours, known), value.at("within").get<double>()) << claim << ": " << ours << " for " << known;
}

INSTANTIATE_TEST_SUITE_P(OfAllSources, PublishedResult, ::testing::ValuesIn(published_values()));

TEST(PublishedResults, AreAtLeastSixty) { EXPECT_GE(published_values().size(), 60U); }

TEST(PublishedResults, StandOnTheirPage) {
  if (std::system("command -v python3 >/dev/null") != 0) GTEST_SKIP() << "skipped: there is no python3";
  const std::string script = (folder_of_values / "write.py").string();
  EXPECT_EQ(std::system(("python3 -B '" + script + "' --check --program '" ROCKING_PROGRAM "'").c_str()), 0);
}

}  // namespace
}  // namespace rocking

// `rocking trajectory` and `replay` in other units and as a table.

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::ElementsAre;
using ::testing::StartsWith;

class TrajectoryOutput : public rocking::support::ProgramTest {
 protected:
  std::string printed(const std::string& arguments) const {
    const auto outcome = rocking("trajectory quick.json --condition 1 --periods 6 --samples 5 " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome.output;
  }
};

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    auto& row = rows.emplace_back();
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

// psi and p of a block of 1 m by 4 m: tan(psi) = 1/4, R = sqrt(17)/2, p^2 = 3 g/(4 R).
TEST_F(TrajectoryOutput, InSiUnitsIsTheNormalisedOneTimesTheScalesOfTheBlock) {
  const std::string text = printed("--units si");
  EXPECT_EQ(objections("trajectory", text), "");
  const Json si = Json::parse(text);
  const Json normalised = Json::parse(printed(""));
  EXPECT_EQ(normalised["units"], "normalised");
  EXPECT_EQ(si["units"], "si");
  EXPECT_EQ(si["block"], normalised["block"]);
  const double psi = std::atan(0.25);
  const double radius = std::sqrt(17.0) / 2.0;
  const double p = std::sqrt(0.75 * 9.81 / radius);
  EXPECT_DOUBLE_EQ(si["block"]["shape_angle_rad"], psi);
  EXPECT_DOUBLE_EQ(si["block"]["half_diagonal_m"], radius);
  EXPECT_DOUBLE_EQ(si["block"]["frequency_parameter_rad_s"], p);
  for (const char* list : {"strobe", "events", "history"}) {
    ASSERT_EQ(si[list].size(), normalised[list].size());
    ASSERT_FALSE(si[list].empty());
    for (std::size_t i = 0; i < si[list].size(); ++i) {
      const Json& to = si[list][i];
      const Json& from = normalised[list][i];
      EXPECT_DOUBLE_EQ(to["tilt_rad"], psi * from["tilt"].get<double>());
      EXPECT_DOUBLE_EQ(to["tilt_rate_rad_s"], psi * p * from["tilt_rate"].get<double>());
      EXPECT_DOUBLE_EQ(to["slip_m"], radius * from["slip"].get<double>());
      EXPECT_DOUBLE_EQ(to["slip_rate_m_s"], radius * p * from["slip_rate"].get<double>());
      const double period = 2.0 * std::acos(-1.0) / 10.0;
      const double tau = from.contains("tau") ? from["tau"].get<double>() : from["period"].get<double>() * period;
      EXPECT_NEAR(to["time_s"].get<double>(), tau / p, 1e-14);
    }
  }
}

TEST_F(TrajectoryOutput, AsATableHasTheSameNumbersByTime) {
  for (const char* units : {"normalised", "si"}) {
    const std::string flag = std::string("--units ") + units;
    const Json json = Json::parse(printed(flag));
    const std::string csv = printed(flag + " --format csv");
    EXPECT_THAT(csv, StartsWith("# format: rocking.trajectory/1\n# condition: 1\n# realisation: 0\n# units: " +
                                std::string(units) + "\n# width_m: 1.0\n"));
    const auto rows = cells_of(csv);
    const bool si = units == std::string("si");
    EXPECT_THAT(
        rows.at(0),
        si ? ElementsAre("row", "time_s", "tilt_rad", "tilt_rate_rad_s", "slip_m", "slip_rate_m_s", "contact", "event")
           : ElementsAre("row", "tau", "tilt", "tilt_rate", "slip", "slip_rate", "contact", "event"));
    EXPECT_EQ(rows.size(), 1 + json["strobe"].size() + json["events"].size() + json["history"].size());
    std::size_t event = 0, sample = 0, strobe = 0;
    double last = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const auto& row = rows[i];
      ASSERT_EQ(row.size(), 8U);
      EXPECT_GE(std::stod(row[1]), last);
      last = std::stod(row[1]);
      const Json& from = row[0] == "event"    ? json["events"][event++]
                         : row[0] == "strobe" ? json["strobe"][strobe++]
                                              : json["history"][sample++];
      EXPECT_EQ(std::stod(row[2]), from[si ? "tilt_rad" : "tilt"].get<double>());
      EXPECT_EQ(std::stod(row[5]), from[si ? "slip_rate_m_s" : "slip_rate"].get<double>());
      EXPECT_EQ(row[6], from.value("contact", ""));
      EXPECT_EQ(row[7], from.value("kind", ""));
    }
    EXPECT_EQ(event, json["events"].size());
    EXPECT_EQ(strobe, json["strobe"].size());
  }
}

TEST_F(TrajectoryOutput, OfAReplayIsTheSame) {
  ASSERT_EQ(rocking("run quick.json -q --no-page -o out").exit_code, 0);
  EXPECT_EQ(rocking("trajectory out --condition 1 --realisation 2 --units si --format csv").output,
            rocking("trajectory quick.json --condition 1 --realisation 2 --units si --format csv").output);
}

TEST_F(TrajectoryOutput, InSiUnitsIsDrawnAsTheNormalisedOne) {
  write("a.json", printed(""));
  write("b.json", printed("--units si"));
  ASSERT_EQ(rocking("report a.json -o one").exit_code, 0);
  ASSERT_EQ(shell("mv a.json kept; mv b.json a.json; exec '" ROCKING_PROGRAM "' report a.json -o two").exit_code, 0);
  const auto one = cells_of(read("one/poincare.tsv"));
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one.size(), cells_of(read("two/poincare.tsv")).size());
}

TEST_F(TrajectoryOutput, RefusesOtherWords) {
  EXPECT_EQ(rocking("trajectory quick.json --units imperial").exit_code, 64);
  EXPECT_EQ(rocking("trajectory quick.json --format xml").exit_code, 64);
  EXPECT_EQ(rocking("trajectory quick.json --format csv --json").exit_code, 64);
}

}  // namespace

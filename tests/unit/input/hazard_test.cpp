// Hazard curves: what is read, and every fault with its line.

#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string complaint(const std::string& text, const HazardReading& reading = {}) {
  try {
    static_cast<void>(read_hazard(text, "h.csv", reading));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

HazardCurve hazard_of(const std::string& text, const HazardReading& reading = {}) {
  return read_hazard(text, "h.csv", reading);
}

const std::string two_points = "0.1,1e-2\n0.2,1e-3\n";

TEST(Hazard, IsReadWithHeaderCommentsAndAnySeparator) {
  const HazardCurve found = hazard_of("# PSHA\npga_g, rate\r\n0.1 , 1e-2\n\n0.2;2e-3 # far\n+0.4\t5e-4\n");
  EXPECT_EQ(found.intensity, "pga_g");
  ASSERT_EQ(found.points.size(), 3U);
  EXPECT_EQ(found.points[1].intensity, 0.2);
  EXPECT_EQ(found.points[2].rate, 5e-4);
  EXPECT_FALSE(found.years);
}

TEST(Hazard, HeaderMayBeQuotedAndFollowComments) {
  const HazardCurve found = hazard_of("# one\n\n\"sa_g[0.5]\",\"rate\"\n" + two_points);
  EXPECT_EQ(found.intensity, "sa_g[0.5]");
  EXPECT_EQ(found.header_line, 3U);
}

TEST(Hazard, HeaderNamesTheMeasureInEachSpelling) {
  for (const auto& [word, name] :
       {std::pair{"pga_g", "pga_g"}, std::pair{"PGA", "pga_g"}, std::pair{"PGA (g)", "pga_g"},
        std::pair{"/excitation/pga_g", "pga_g"}, std::pair{"SA(1.0)", "sa_g[1]"}, std::pair{"sa_g[1.0]", "sa_g[1]"},
        std::pair{"SA(0.20)", "sa_g[0.2]"}, std::pair{"SA0P2", "sa_g[0.2]"}, std::pair{"SA10P0", "sa_g[10]"},
        std::pair{"sa_g", "sa_g"}, std::pair{"avgsa_g[0.20-2.0]", "avgsa_g[0.2-2]"}, std::pair{"sa_p_g", "sa_p_g"},
        std::pair{"amplitude", "amplitude"}, std::pair{"scale", "scale"}}) {
    EXPECT_EQ(hazard_of(std::string(word) + ", annual_rate\n" + two_points).intensity, name) << word;
  }
  for (const std::string word : {"pgd_m", "SA", "SA(0)", "SA(x)", "SA(1", "pga_g[1]", "SA0P0", "SAP", "SA1",
                                 "PGA(cm/s2)", "annual_rate", "\"\""}) {
    EXPECT_THAT(complaint(word + ", annual_rate\n" + two_points), HasSubstr("line 1")) << word;
    EXPECT_THAT(complaint(word + ", annual_rate\n" + two_points), HasSubstr("is no known intensity measure")) << word;
  }
}

// OpenQuake's PGV is in cm/s.
TEST(Hazard, OfVelocitiesIsInMetresPerSecond) {
  for (const char* word : {"PGV", "pgv_cm_s", "PGV [cm/s]"}) {
    const HazardCurve found = hazard_of(std::string(word) + ", annual_rate\n5, 1e-2\n100, 1e-4\n");
    EXPECT_EQ(found.intensity, "pgv_m_s");
    EXPECT_EQ(found.points[0].intensity, 0.05);
    EXPECT_EQ(found.points[1].intensity, 1.0);
  }
}

TEST(Hazard, KindOfItsNumbersIsKnown) {
  for (const std::string word : {"annual_rate", "rate", "Annual Rate", "annual rate of exceedance",
                                 "rate of exceedance", "annual_exceedance_rate", "mean annual frequency of exceedance",
                                 "annual-frequency", "AFE", "annual_rate [1/year]", "rate per year"}) {
    EXPECT_EQ(hazard_of("pga_g, " + word + '\n' + two_points).points[0].rate, 1e-2) << word;
  }
  for (const std::string word : {"poe", "PoE", "probability", "probability of exceedance", "exceedance_probability"}) {
    EXPECT_EQ(hazard_of("pga_g, " + word + '\n' + two_points, {.years = 50.0}).years, 50.0) << word;
  }
  EXPECT_EQ(hazard_of("pga_g, poe[475]\n" + two_points).years, 475.0);
  EXPECT_EQ(hazard_of("pga_g, annual_poe\n" + two_points).years, 1.0);
  for (const std::string word : {"lambda", "return_period", "poe_50", "poe in 50 years", "annual", "exceedance", "g"}) {
    EXPECT_THAT(complaint("pga_g, " + word + '\n' + two_points),
                AllOf(HasSubstr("line 1 = " + word), HasSubstr("is neither a rate nor a probability")))
        << word;
  }
}

// -ln(1 - P)/T: of 10 % in 50 years once in 474.56 years, of a tiny P without the loss of digits of 1 - P.
TEST(Hazard, OfProbabilitiesGivesTheirRates) {
  const HazardCurve found = hazard_of("pga_g, poe\n0.1,0.1\n0.2,1e-12\n", {.years = 50.0});
  EXPECT_NEAR(1.0 / found.points[0].rate, 474.561079051495, 1e-10);
  EXPECT_NEAR(found.points[1].rate, 2.000000000001e-14, 1e-26);
}

TEST(Hazard, RefusesProbabilitiesWithoutOneTime) {
  EXPECT_THAT(complaint("pga_g, poe\n" + two_points),
              AllOf(HasSubstr("line 1 = poe"), HasSubstr("time that is not stated"), HasSubstr("--years 50")));
  EXPECT_THAT(complaint("pga_g, poe[50]\n" + two_points, {.years = 475.0}), HasSubstr("another time than --years 475"));
  EXPECT_THAT(complaint("pga_g, annual_rate\n" + two_points, {.years = 50.0}), HasSubstr("--years means nothing"));
  for (const double years : {0.0, -50.0, HUGE_VAL}) {
    EXPECT_THAT(complaint("pga_g, poe\n" + two_points, {.years = years}),
                HasSubstr("must be a positive number of years"));
  }
  EXPECT_THAT(complaint("pga_g, poe\n0.1,39\n0.2,10\n", {.years = 50.0}),
              AllOf(HasSubstr("line 2 = 39"), HasSubstr("is no probability")));
  EXPECT_THAT(complaint("pga_g, poe\n0.1,0.9\n0.2,1\n", {.years = 50.0}),
              HasSubstr("line 3 = 1: is a probability that"));
}

// OpenQuake writes 1 for what nearly always happens.
TEST(Hazard, LeavesOutTheProbabilityOneBeforeOthersAndCountsIt) {
  const HazardCurve found = hazard_of("pga_g, poe\n0.01,1\n0.02,1.0\n0.1,0.5\n0.2,0.1\n", {.years = 50.0});
  EXPECT_EQ(found.points.front().intensity, 0.1);
  EXPECT_EQ(found.certain, 2U);
  EXPECT_THAT(complaint("pga_g, poe\n0.1,1\n0.2,0.5\n", {.years = 50.0}), HasSubstr("at least two points"));
}

TEST(Hazard, WithoutAMeasureNeedsOne) {
  for (const std::string& text : {two_points, "iml, rate\n" + two_points}) {
    EXPECT_THAT(complaint(text), AllOf(HasSubstr("does not name its intensity measure"), HasSubstr("--imt pga_g")))
        << text;
    EXPECT_EQ(hazard_of(text, {.measure = "SA(1.0)"}).intensity, "sa_g[1]") << text;
  }
  EXPECT_EQ(hazard_of(two_points, {.years = 1.0, .measure = "PGA"}).points[0].rate, -std::log1p(-1e-2));
  EXPECT_EQ(hazard_of("pga_g, rate\n" + two_points, {.measure = "PGA"}).intensity, "pga_g");
  EXPECT_THAT(complaint("pga_g, rate\n" + two_points, {.measure = "SA(1)"}), HasSubstr("--imt asks for, sa_g[1]"));
  EXPECT_THAT(complaint(two_points, {.measure = "peak"}), HasSubstr("--imt = peak: is no known"));
}

// cm/s2 under a name in g, cm/s under one in m/s, m/s under OpenQuake's, which is in cm/s.
TEST(Hazard, IsRefusedInAnotherUnitThanThatOfItsName) {
  const auto from = [](const std::string& header, double first, double ratio) {
    std::string text = header + ", annual_rate\n";
    for (int i = 0; i < 6; ++i) {
      text += std::to_string(first * std::pow(ratio, i)) + ',' + std::to_string(0.1 * std::pow(0.3, i)) + '\n';
    }
    return text;
  };
  EXPECT_THAT(complaint(from("pga_g", 49.0, 2.0)),
              AllOf(HasSubstr("line 1 = pga_g"), HasSubstr("likely in cm/s2"), HasSubstr("divide them by 980.665")));
  EXPECT_THAT(complaint(from("SA(1.0)", 4.9, 2.0)), HasSubstr("likely in cm/s2"));
  EXPECT_THAT(complaint(from("sa_g[1]", 10.1, 1.01)), HasSubstr("likely in m/s2"));
  EXPECT_THAT(complaint("pga_g, rate\n0.49,3e-2\n1.96,2.5e-3\n4.9,2.5e-4\n14.7,7e-6\n"),
              AllOf(HasSubstr("1.96 would be exceeded 0.0025 times a year"), HasSubstr("likely in m/s2")));
  EXPECT_THAT(complaint("pgv_m_s, rate\n0.5,5\n2,0.8\n40,5e-4\n"), HasSubstr("likely in cm/s"));
  EXPECT_EQ(complaint("pga_g, rate\n0.05,2\n1,5e-3\n2,4e-4\n3,7e-5\n5,5e-6\n"), "") << "the strongest in use";
  EXPECT_EQ(complaint("pga_g, rate\n0.1,1e-2\n10,1e-5\n"), "") << "a straight line";
  EXPECT_THAT(complaint(from("pgv_m_s", 2.0, 2.0)), HasSubstr("likely in cm/s"));
  EXPECT_THAT(complaint(from("PGV", 0.05, 2.0)), AllOf(HasSubstr("likely in m/s"), HasSubstr("pgv_m_s")));
  EXPECT_THAT(complaint(from("PGV", 100.0, 3.0)), HasSubstr("likely in mm/s"));
  for (const auto& [header, first] : {std::pair{"pga_g", 0.05}, std::pair{"pgv_m_s", 0.05}, std::pair{"PGV", 5.0},
                                      std::pair{"scale", 49.0}, std::pair{"amplitude", 49.0}}) {
    EXPECT_EQ(complaint(from(header, first, 2.0)), "") << header;
  }
}

TEST(Hazard, TakesEqualNeighboursAndZerosAtTheEnd) {
  const HazardCurve found = hazard_of("pga_g, rate\n0.1,1e-2\n0.2,1e-2\n0.3,1e-3\n0.4,0\n0.5,0\n");
  EXPECT_EQ(found.points.size(), 5U);
  EXPECT_EQ(found.points.back().rate, 0.0);
  EXPECT_THAT(complaint("pga_g, rate\n0.1,1e-2\n0.2,1e-2\n"), HasSubstr("the same rate of exceedance"));
  EXPECT_THAT(complaint("pga_g, rate\n0.1,0\n0.2,0\n"), HasSubstr("the same rate of exceedance"));
  EXPECT_THAT(complaint("pga_g, rate\n0.1,1e-2\n0.2,0\n0.3,1e-3\n"), HasSubstr("line 4 = 1e-3: is above the number"));
}

TEST(Hazard, HasABoundOnItsPointsThatIsTold) {
  std::string text = "scale,rate\n";
  for (std::size_t i = 1; i <= most_hazard_points; ++i)
    text += std::to_string(i) + ',' + std::to_string(20000 - i) + '\n';
  EXPECT_EQ(hazard_of(text).points.size(), most_hazard_points);
  text += std::to_string(most_hazard_points + 1) + ",1\n";
  EXPECT_THAT(complaint(text), ::testing::AllOf(HasSubstr("more than 10000 points"), HasSubstr("is too large"),
                                                HasSubstr("at most 10000 points")));
}

TEST(Hazard, OfTooManyBytesIsTooLargeWhateverItHolds) {
  const std::string line = "# no point, but a long comment\n";
  std::string text;
  while (text.size() <= most_hazard_bytes) text += line;
  EXPECT_THAT(complaint(text), ::testing::AllOf(HasSubstr("more than 10 MB"), HasSubstr("is too large")));
}

TEST(Hazard, IsRefusedWithLineValueAndRemedy) {
  const auto of = [](const std::string& lines) { return complaint("pga_g,rate\n" + lines); };
  EXPECT_THAT(of("0.1,1e-2\n"), HasSubstr("at least two points"));
  EXPECT_THAT(of("c,d\n"), HasSubstr("line 2 = c: is not a number"));
  EXPECT_THAT(of("0.1,1e-2\n0.1,1e-3\n"), HasSubstr("line 3 = 0.1: is not above"));
  EXPECT_THAT(of("0.1,1e-2\n0.2,2e-2\n"), HasSubstr("line 3 = 2e-2: is above the number before it"));
  EXPECT_THAT(of("0.1,1e-2\n0.2,-1\n"), HasSubstr("line 3 = -1: must not be negative"));
  EXPECT_THAT(of("-0.1,1e-2\n0.2,1e-3\n"), HasSubstr("line 2 = -0.1: must be positive"));
  EXPECT_THAT(of("0.1,1e-2\n0.2,1e-3,7\n"),
              HasSubstr("line 3 = \"0.2,1e-3,7\": has 3 fields, but the first line has 2"));
  EXPECT_THAT(complaint("pga_g,rate,7\n0.1,1e-2,7\n"), HasSubstr("two columns"));
  EXPECT_THAT(of("0.1,1e-2\n0.2,nan\n"), HasSubstr("not a number"));
  EXPECT_THAT(of("0,1;0,01\n"), HasSubstr("has 4 fields, but the first line has 2"));
}

}  // namespace
}  // namespace rocking

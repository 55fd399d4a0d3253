// Numbers that are drawn once, and laws along the way: from the file to the page.

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/false_alarms.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class RandomNumbers : public rocking::support::ProgramTest {
 protected:
  /// A question with every law, and every number that may have one.
  [[nodiscard]] static Json with_every_law() {
    return Json::parse(R"({"format": "rocking.experiment/1", "title": "every law",
      "block": {"width_m": {"normal": {"mean": 0.5, "sigma": 0.02, "between": [0.45, 0.55]}},
                "height_m": {"values": [1.9, 2.0], "weights": [1, 3]}},
      "restitution": {"rate_ratio": {"uniform": [0.90, 0.93]}},
      "excitation": {"kind": "harmonic", "amplitude_g": {"lognormal": {"mean": 0.5, "sigma": 0.1}},
                     "frequency_hz": {"uniform": [2, 3]}, "phase_rad": {"uniform": [0, 6.28]}},
      "friction": {"static": {"triangular": [0.4, 0.5, 0.6]}, "kinetic": {"ratio": 0.9}},
      "fluctuation": {"friction": {"sigma": 0.03, "law": "lognormal", "correlation": 1.0},
                      "restitution": {"sigma": 0.005, "law": "uniform"}},
      "initial": {"tilt": {"normal": {"mean": 0, "sigma": 0.05}}},
      "horizon": {"transient_periods": 10, "sampled_periods": 20}, "realisations": 40, "seed": "0x1"})");
  }
};

TEST_F(RandomNumbers, OfEveryLawGoFromTheFileToThePage) {
  write("laws.json", with_every_law().dump());
  ASSERT_EQ(objections("experiment", with_every_law().dump()), "");
  const auto ran = rocking("run laws.json -q -o out");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  const Json report = Json::parse(read("out/report.json"));
  EXPECT_EQ(objections("report", report.dump()), "");
  EXPECT_EQ(report["input"]["experiment"]["friction"], with_every_law()["friction"]);
  EXPECT_EQ(report["result"]["conditions"][0]["validity"]["clamped_draws"]["kinetic_friction_at_static"], 0);
  EXPECT_THAT(
      read("out/report.html"),
      AllOf(HasSubstr("rate ratio"), HasSubstr("static friction 0.4 to 0.6 (drawn, triangular)"),
            HasSubstr("kinetic 0.9 of it"), HasSubstr("0.03, law lognormal, correlation 1"), HasSubstr("on average")));
  EXPECT_EQ(rocking("verify out -q").exit_code, 0);
  EXPECT_EQ(rocking("report out").exit_code, 0);
  EXPECT_EQ(rocking("run laws.json -q -o other -j 2 --no-page").exit_code, 0);
  EXPECT_EQ(Json::parse(read("other/report.json"))["result"], report["result"]);
}

TEST_F(RandomNumbers, OfEveryLawCanBeSplit) {
  write("laws.json", with_every_law().dump());
  const auto found = rocking("rare laws.json -q -o rare --event 'tilt > 0.5 psi' --particles 40 --relative-error 0.5");
  EXPECT_EQ(found.exit_code, 0) << found.errors;
}

TEST_F(RandomNumbers, AreRefusedWithTheLineAndARemedy) {
  const auto refused = [this](const std::string& place, const std::string& value) {
    Json experiment = with_every_law();
    experiment[Json::json_pointer(place)] = Json::parse(value);
    write("bad.json", experiment.dump(1));
    const auto outcome = rocking("validate bad.json");
    EXPECT_EQ(outcome.exit_code, 65) << place << ' ' << value;
    return outcome.errors;
  };
  EXPECT_THAT(refused("/friction/static", R"({"gamma": 1})"), HasSubstr("or another law: \"uniform\", \"normal\""));
  EXPECT_THAT(refused("/friction/static", R"({"uniform": [0.4, 0.5], "triangular": [0.4, 0.5, 0.6]})"),
              HasSubstr("two distributions"));
  EXPECT_THAT(refused("/friction/static", R"({"triangular": [0.4, 0.5]})"), HasSubstr("must be a list of 3 numbers"));
  EXPECT_THAT(refused("/friction/static", R"({"lognormal": {"mean": 0.4, "sd": 0.1}})"), HasSubstr("sigma"));
  EXPECT_THAT(refused("/friction/static", R"({"values": [0.4], "weights": [-1]})"), HasSubstr("relative frequency"));
  EXPECT_THAT(refused("/friction/kinetic", R"({"ratio": 1.2})"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(refused("/friction/kinetic", "0.55"), HasSubstr("is below the kinetic coefficient"));
  EXPECT_THAT(refused("/excitation/frequency_hz", R"({"normal": {"mean": 2, "sigma": 0.5}})"), HasSubstr("between"));
  EXPECT_THAT(refused("/fluctuation/friction/correlation", "1.5"), HasSubstr("from -1 to 1"));
  EXPECT_THAT(refused("/fluctuation/friction/law", R"("weibull")"), HasSubstr("lognormal"));
  EXPECT_THAT(refused("/fluctuation/restitution/law", R"("lognormal")"), HasSubstr("positive mean"));
}

TEST_F(RandomNumbers, OfAFileAreTested) {
  std::string lines = "test,friction\n", bare;
  for (int i = 0; i < 200; ++i) {
    // scores at evenly spaced probabilities, by a rational approximation (Abramowitz & Stegun 26.2.22, to 0.003)
    const double p = (i + 0.5) / 200.0, t = std::sqrt(-2.0 * std::log(std::min(p, 1.0 - p)));
    const double z = t - (2.30753 + 0.27061 * t) / (1.0 + 0.99229 * t + 0.04481 * t * t);
    const std::string number = std::to_string(0.4 + (p < 0.5 ? -0.03 : 0.03) * z);
    lines += std::to_string(i) + ',' + number + '\n';
    bare += number + '\n';
  }
  write("tests.csv", lines);
  write("bare.txt", "# friction\n" + bare);
  const auto own = rocking("check-normal tests.csv --column friction");
  EXPECT_EQ(own.exit_code, 0) << own.errors;
  EXPECT_THAT(own.output, AllOf(HasSubstr("200 numbers against N(0.4, 0.029"), HasSubstr("in tests.csv"),
                                HasSubstr("skewness"), HasSubstr("their rows test nothing")));
  const Json found = Json::parse(rocking("check-normal bare.txt --json").output);
  EXPECT_EQ(objections("check_normal", found.dump()), "");
  EXPECT_EQ(found["own_law"], true);
  EXPECT_EQ(found["n"], 200);
  EXPECT_NEAR(found["mean"]["value"].get<double>(), 0.4, 1e-6);
  const auto other = rocking("check-normal bare.txt --mean 0.5 --sigma 0.03 --json");
  EXPECT_EQ(other.exit_code, 1) << "another law";
  EXPECT_EQ(Json::parse(other.output)["own_law"], false);
}

TEST_F(RandomNumbers, OfAFileAreRefusedWithTheLine) {
  std::string twenty;
  for (int i = 0; i < 20; ++i) twenty += std::to_string(i) + ",1\n";
  struct Fault {
    std::string text, flags, told;
  };
  for (const Fault& fault : std::vector<Fault>{
           {"1\n2\nthree\n", "", "numbers.csv, line 3 = \"three\": is not a number"},
           {"1\n2\n3\n", "", "numbers.csv: has 3 numbers; give at least 20"},
           {"x,y\n" + twenty, "", "line 1 = \"x,y\": has several columns; name one of its first line with --column"},
           {"x,y\n" + twenty, "--column z", "line 1 = \"z\": is no column that this line names"},
           {"x,y\n" + twenty + "7\n", "--column y", "line 22 = \"7\": has 1 field, but the first line has 2"},
           {"x,y\n" + twenty, "--column y", "numbers.csv: has numbers that are all equal"}}) {
    write("numbers.csv", fault.text);
    const auto outcome = rocking("check-normal numbers.csv " + fault.flags);
    EXPECT_EQ(outcome.exit_code, 65) << fault.text;
    EXPECT_THAT(outcome.errors, HasSubstr(fault.told));
  }
  EXPECT_EQ(rocking("check-normal missing.csv").exit_code, 66);
  EXPECT_EQ(rocking("check-normal numbers.csv --column x --mean 1").exit_code, 64);
  EXPECT_EQ(rocking("check-normal numbers.csv --n 30").exit_code, 64);
}

TEST_F(RandomNumbers, OfLawsAlongTheWayAreTested) {
  rocking::support::FalseAlarms alarms;
  for (const std::string law : {"lognormal", "uniform"}) {
    const auto outcome = rocking("check-normal --json --n 5000 --law " + law);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(objections("check_normal", outcome.output), "");
    const Json check = Json::parse(outcome.output);
    EXPECT_EQ(check["distribution"], law);
    for (const char* moment : {"mean", "standard_deviation", "skewness", "kurtosis"}) {
      EXPECT_LT(std::abs(check[moment]["z"].get<double>()), alarms.score()) << law << moment;
    }
    EXPECT_NEAR(check["kurtosis"]["of_law"].get<double>(), law == "uniform" ? 1.8 : 3.09, 0.01);
    write("check.json", outcome.output);
    EXPECT_EQ(rocking("report check.json -o drawn").exit_code, 0);
    EXPECT_THAT(rocking("check-normal --n 5000 --law " + law).output, HasSubstr("numbers from " + law));
  }
  EXPECT_THAT(rocking("check-normal --json").output, Not(HasSubstr("of_law")));
  EXPECT_EQ(rocking("check-normal --law lognormal --mean 0").exit_code, 64);
}

}  // namespace

// The unknowns of an experiment: what is read, and every fault with its place.

#include "rocking/input/sweep.hpp"

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"

namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::HasSubstr;

Experiment with_unknowns(const std::string& list, const std::string& more = "") {
  return experiment_in(R"({"format": "rocking.experiment/1", "block": {"width_m": 1.0, "height_m": 4.0},
      "excitation": {"amplitude": 4.2, "frequency_ratio": 10.0},
      "friction": {"static": {"normal": {"mean": 0.35, "sigma": 0.02}}, "kinetic": {"ratio": 0.8}}, )" +
                       more + R"("unknown": )" + list + "}");
}

std::string complaint_of_unknowns(const std::string& list, const std::string& more = "") {
  try {
    static_cast<void>(with_unknowns(list, more));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

/// Of one unknown with this in place of its range.
std::string complaint_of_one(const std::string& keys) {
  return complaint_of_unknowns(R"([{"parameter": "/excitation/amplitude", )" + keys + "}]");
}

TEST(Unknowns, HavePlaceRangeAndPrior) {
  const auto found = with_unknowns(R"([{"parameter": "/friction/static/normal/mean", "from": 0.3, "to": 0.4},
      {"parameter": "/friction/static/normal/sigma", "from": 0, "to": 0.1, "prior": {"uniform": [0.0, 0.05]}},
      {"parameter": "/excitation/amplitude", "from": 4, "to": 5, "prior": {"triangular": [4.0, 4.0, 5.0]}}])")
                         .unknowns;
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].pointer, "/friction/static/normal/mean");
  EXPECT_EQ(found[0].from, 0.3);
  EXPECT_EQ(found[0].to, 0.4);
  EXPECT_FALSE(found[0].prior);
  EXPECT_EQ(std::get<Uniform>(found[1].prior.value()).high, 0.05);
  EXPECT_THAT(with_unknowns("[{\"parameter\": \"/excitation/amplitude\", \"from\": 1, \"to\": 2}]").conditions,
              ::testing::SizeIs(1));
}

TEST(Unknowns, AreOneToThree) {
  const std::string one = R"({"parameter": "/excitation/amplitude", "from": 4, "to": 5})";
  for (const std::string& list : {std::string("[]"), "[" + one + "," + one + "," + one + "," + one + "]", one,
                                  std::string("null"), std::string("0.3")}) {
    EXPECT_THAT(complaint_of_unknowns(list), HasSubstr("must be a list of one to three entries; give for example"))
        << list;
  }
  EXPECT_THAT(complaint_of_unknowns("[1]"), HasSubstr("/unknown/0 = 1: must be an object"));
}

TEST(Unknowns, AreNumbersOfTheFile) {
  const auto complaint_about = [](const std::string& pointer) {
    return complaint_of_unknowns("[{\"parameter\": \"" + pointer + "\", \"from\": 0.3, \"to\": 0.4}]");
  };
  EXPECT_THAT(complaint_about("/friction/statik"), HasSubstr("did you mean \"/friction/static\"?"));
  EXPECT_THAT(complaint_about("/friction/static"), HasSubstr("is no number in this file; write a number there, or"));
  EXPECT_THAT(complaint_about("/friction/static/normal/between"), HasSubstr("/unknown/0/parameter"));
  EXPECT_THAT(complaint_about("mean"), HasSubstr("is not a value of this file"));
  EXPECT_THAT(complaint_about("/title"), HasSubstr("is not a value of this file"));
  EXPECT_THAT(complaint_about("/seed"), HasSubstr("is not a value of this file"));
  EXPECT_THAT(complaint_about("/unknown/0/from"), HasSubstr("is not a value of this file"));
  EXPECT_THAT(complaint_about(""), HasSubstr("/unknown/0/parameter"));
  EXPECT_THAT(complaint_of_unknowns(R"([{"from": 0.3, "to": 0.4}])"), HasSubstr("/unknown/0/parameter: is missing"));
}

TEST(Unknowns, HaveARange) {
  EXPECT_THAT(complaint_of_one(R"("from": 5, "to": 4)"), HasSubstr("/unknown/0/to = 4: is not above \"from\""));
  EXPECT_THAT(complaint_of_one(R"("from": 4, "to": 4)"), HasSubstr("/unknown/0/to = 4: is not above \"from\""));
  EXPECT_THAT(complaint_of_one(R"("from": 4)"), HasSubstr("/unknown/0/to: is missing"));
  EXPECT_THAT(complaint_of_one(R"("from": "4", "to": 5)"), HasSubstr("/unknown/0/from = \"4\": must be a number"));
  EXPECT_THAT(complaint_of_one(R"("form": 4, "to": 5)"), AllOf(HasSubstr("/unknown/0/form"), HasSubstr("\"from\"?")));
}

TEST(Unknowns, HaveOnlyPriorsWithADensity) {
  const auto complaint_about = [](const std::string& prior) {
    return complaint_of_one(R"("from": 4, "to": 5, "prior": )" + prior);
  };
  EXPECT_EQ(complaint_about(R"({"lognormal": {"mean": 4.5, "sigma": 0.1}})"), "");
  for (const char* prior : {"4.5", R"({"values": [4.0, 4.5]})"}) {
    EXPECT_THAT(complaint_about(prior), HasSubstr("must be a law with a density; give for example")) << prior;
  }
  EXPECT_THAT(complaint_about(R"({"uniform": [4.5, 4.5]})"), HasSubstr("/unknown/0/prior/uniform"));
  EXPECT_THAT(complaint_about(R"({"normal": {"mean": 4.5, "sigma": -1}})"), HasSubstr("must not be negative"));
  EXPECT_THAT(complaint_about(R"({"gamma": [1, 2]})"), HasSubstr("/unknown/0/prior"));
}

TEST(Unknowns, AreNeitherSweptNorSetTwice) {
  const std::string mean = R"({"parameter": "/friction/static/normal/mean", "from": 0.3, "to": 0.4})";
  EXPECT_THAT(complaint_of_unknowns("[" + mean + "," + mean + "]"),
              HasSubstr("/unknown/1/parameter = \"/friction/static/normal/mean\": is also set by an entry before it"));
  for (const char* swept : {"/friction/static/normal/mean", "/friction/static/normal", "/friction/static"}) {
    const std::string value = std::string(swept).ends_with("mean")     ? "0.3"
                              : std::string(swept).ends_with("normal") ? R"({"mean": 0.3, "sigma": 0.1})"
                                                                       : R"({"normal": {"mean": 0.3, "sigma": 0.1}})";
    EXPECT_THAT(complaint_of_unknowns("[" + mean + "]", "\"sweep\": [{\"parameter\": \"" + std::string(swept) +
                                                            "\", \"values\": [" + value + "]}], "),
                HasSubstr("is also swept; keep one of them"))
        << swept;
  }
}

}  // namespace

// Suites of ground motions in an experiment: which conditions there are, and the canonical text.

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/digest.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/studies/motion/study.hpp"
#include "rocking/text/json.hpp"
#include "support/record_text.hpp"

namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Suite : public ::testing::Test {
 protected:
  Suite() {
    files_["records/a.at2"] = support::peer_at2({0.1, -0.2, 0.05}, ".01");
    files_["records/b.at2"] = support::peer_at2({0.4, -0.3, 0.05, 0.0}, ".5");
    files_["v.at2"] = support::peer_at2({0.01, 0.02, 0.03}, ".01");
  }

  Surroundings surroundings() const {
    return {.files =
                [this](const std::string& name, std::size_t) {
                  const auto found = files_.find(name);
                  if (found == files_.end()) {
                    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory), name);
                  }
                  return found->second;
                },
            .matches =
                [](const std::string& pattern) {
                  if (pattern != "records/*.at2") return std::vector<std::string>();
                  return std::vector<std::string>{"records/a.at2", "records/b.at2"};
                }};
  }

  static Json experiment(const std::string& suite, const std::string& sweep = "null") {
    Json json = Json::parse(R"({ "format": "rocking.experiment/1", "block": { "width_m": 0.35, "height_m": 1.6 },
      "excitation": { "kind": "recorded" } })");
    json["excitation"]["suite"] = Json::parse(suite);
    if (sweep != "null") json["sweep"] = Json::parse(sweep);
    return json;
  }

  Experiment read(const Json& json) const { return experiment_in(json.dump(), {}, surroundings()); }

  std::string refusal_of(const Json& json) const {
    try {
      static_cast<void>(read(json));
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  static const Recorded& recorded(const Condition& condition) { return std::get<Recorded>(condition.scene.excitation); }

  std::map<std::string, std::string> files_;
};

TEST_F(Suite, HasAConditionForEachRecordAndLevel) {
  const Experiment read_suite =
      read(experiment(R"("records/*.at2")", R"([{ "parameter": "/excitation/scale", "values": [1.0, 2.0, 3.0] }])"));
  ASSERT_EQ(read_suite.conditions.size(), 6U);
  EXPECT_THAT(read_suite.sweep_sizes, ElementsAre(2U, 3U));
  const Condition& last = read_suite.conditions[5];
  ASSERT_EQ(last.parameters.size(), 2U);
  EXPECT_EQ(last.parameters[0].pointer, "/excitation/file");
  EXPECT_EQ(json_text_of(last.parameters[0].value), "\"records/b.at2\"");
  EXPECT_EQ(json_text_of(last.parameters[1].value), "3.0");
  EXPECT_EQ(recorded(last).scale, 3.0);
  EXPECT_EQ(recorded(last).ground_motion->name, "records/b.at2");
  EXPECT_EQ(recorded(read_suite.conditions[0]).ground_motion, recorded(read_suite.conditions[2]).ground_motion);
  // Each record has its own horizon: the second is longer.
  EXPECT_LT(read_suite.conditions[0].horizon.sampled_periods, last.horizon.sampled_periods);
}

TEST_F(Suite, IsTheSameAsOneExperimentForEachRecord) {
  const Experiment together = read(experiment(R"(["records/a.at2", "records/b.at2"])"));
  ASSERT_EQ(together.conditions.size(), 2U);
  for (const Condition& condition : together.conditions) {
    Json alone = experiment("null");
    alone["excitation"] = {{"kind", "recorded"}, {"file", json_of(condition.parameters[0].value)}};
    const Experiment one = read(alone);
    EXPECT_EQ(one.conditions.front().horizon.sampled_periods, condition.horizon.sampled_periods);
    EXPECT_EQ(recorded(one.conditions.front()).frequency_ratio, recorded(condition).frequency_ratio);
  }
}

TEST_F(Suite, HasACanonicalTextWithFilesAndDigestsThatIsItsOwn) {
  const std::vector<std::string> sweeps{
      "null", R"([{ "parameter": "/excitation/pga_g", "from": 0.1, "to": 0.3, "step": 0.1 }])",
      R"([{ "parameter": "/excitation/pgv_m_s", "values": [0.1, 0.2] }])"};
  for (const std::string& sweep : sweeps) {
    const Experiment once = read(experiment(R"("records/*.at2")", sweep));
    const Experiment again = experiment_in(once.canonical_text, {}, surroundings());
    EXPECT_EQ(again.canonical_text, once.canonical_text);
    EXPECT_EQ(again.conditions.size(), once.conditions.size());
    const Json suite = Json::parse(once.canonical_text)["excitation"]["suite"];
    ASSERT_EQ(suite.size(), 2U);
    EXPECT_EQ(suite[1]["file"], "records/b.at2");
    EXPECT_EQ(suite[1]["sha256"].get<std::string>().size(), 64U);
    EXPECT_NE(suite[0]["sha256"], suite[1]["sha256"]);
    EXPECT_EQ(Json::parse(once.canonical_text).contains("sweep"), sweep != "null");
  }
}

TEST_F(Suite, GivesEachRecordRandomNumbersByItsBytesAlone) {
  const std::string levels = R"([{ "parameter": "/excitation/scale", "values": [1.0, 2.0] }])";
  const Experiment two = read(experiment(R"("records/*.at2")", levels));
  const std::string digits = base::to_hex(base::sha256(files_["records/b.at2"])).substr(0, 16);
  const std::uint64_t of_b = std::stoull(digits, nullptr, 16);
  EXPECT_EQ(two.conditions[2].record_stream, of_b);
  EXPECT_EQ(two.conditions[3].record_stream, of_b) << "levels of a record have common numbers";
  EXPECT_NE(two.conditions[0].record_stream, of_b);
  EXPECT_EQ(seed_of(two.conditions[2], 0x2012), of_b ^ 0x2012);

  files_["other.at2"] = files_["records/b.at2"];
  files_["up.at2"] = support::peer_at2({0.1, 0.1, 0.1, 0.0}, ".5");
  for (const char* suite : {R"(["other.at2", "records/a.at2"])", R"(["records/b.at2"])",
                            R"([{ "file": "records/b.at2", "vertical_file": "up.at2" }])"}) {
    EXPECT_EQ(read(experiment(suite)).conditions.front().record_stream, of_b) << suite;
  }
  const Experiment again = experiment_in(two.canonical_text, {}, surroundings());
  EXPECT_EQ(again.conditions[2].record_stream, of_b);
  Json alone = experiment("null");
  alone["excitation"] = {{"kind", "recorded"}, {"file", "records/b.at2"}};
  EXPECT_EQ(read(alone).conditions.front().record_stream, 0U) << "a run of one file keeps its bits";
}

TEST_F(Suite, IsScaledToAPeakAccelerationOrVelocity) {
  const auto strongest = [this](const char* key) {
    const Experiment levels = read(experiment(
        R"("records/*.at2")", R"([{ "parameter": "/excitation/)" + std::string(key) + R"(", "values": [0.2, 0.6] }])"));
    return recorded(levels.conditions[3]);
  };
  EXPECT_DOUBLE_EQ(mean_of(strongest("pga_g").scale), 0.6 / 0.4);
  // 0.4 to -0.3 in 0.5 s: the velocity is largest where the acceleration passes 0, after 2/7 s.
  EXPECT_DOUBLE_EQ(mean_of(strongest("pgv_m_s").scale), 0.6 / (0.5 * 0.4 * (0.5 * 0.4 / 0.7) * 9.81));
}

TEST_F(Suite, IsScaledToASpectralAcceleration) {
  const auto strongest = [this](const char* key, const char* more, const Json& value) {
    Json json = experiment(R"("records/*.at2")",
                           R"([{ "parameter": "/excitation/)" + std::string(key) + R"(", "values": [0.2, 0.6] }])");
    if (!value.is_null()) json["excitation"][more] = value;
    const Experiment once = read(json);
    EXPECT_EQ(experiment_in(once.canonical_text, {}, surroundings()).canonical_text, once.canonical_text);
    return recorded(once.conditions[3]);
  };
  const auto point = [](const Recorded& motion, double period) {
    return spectral_point(motion.ground_motion->samples, 1.0, period, 0.05);
  };
  const auto spectral = [&point](const Recorded& motion, double period) {  // of hazard models: omega^2 max abs(u)
    const double omega = 2.0 * std::numbers::pi / period;
    return omega * omega * point(motion, period).sd_m * mean_of(motion.scale);
  };
  EXPECT_NEAR(spectral(strongest("sa_g", "period_s", 0.7), 0.7), 0.6, 1e-14);
  EXPECT_THAT(strongest("sa_g", "period_s", 0.7).measure_periods, ElementsAre(0.7));
  const Recorded absolute = strongest("sa_absolute_g", "period_s", 0.7);
  EXPECT_NEAR(point(absolute, 0.7).sa_absolute_g * mean_of(absolute.scale), 0.6, 1e-14);
  EXPECT_LT(mean_of(absolute.scale), mean_of(strongest("sa_g", "period_s", 0.7).scale));
  const Recorded own = strongest("sa_p_g", "", {});
  const dynamics::Block block = mean_block(read(experiment(R"("records/*.at2")")).conditions.front().scene);
  EXPECT_NEAR(spectral(own, 2.0 * std::numbers::pi / dynamics::geometry_of(block).frequency_parameter), 0.6, 1e-14);
  const Recorded average = strongest("avgsa_g", "periods_s", {0.2, 1.6});
  double product = 1.0;
  for (int i = 0; i < 10; ++i) product *= spectral(average, 0.2 * std::pow(8.0, i / 9.0));
  EXPECT_NEAR(std::pow(product, 0.1), 0.6, 1e-12);
}

TEST_F(Suite, RefusesPeriodsThatDoNotBelongToItsMeasure) {
  const auto refusal = [this](const Json& keys) {
    Json json = experiment(R"("records/*.at2")");
    json["excitation"].update(keys);
    return refusal_of(json);
  };
  EXPECT_THAT(refusal({{"sa_absolute_g", 0.4}}), HasSubstr("/excitation/period_s: is missing"));
  EXPECT_THAT(refusal({{"sa_g", 0.4}}), HasSubstr("/excitation/period_s: is missing"));
  EXPECT_THAT(refusal({{"sa_g", 0.4}, {"period_s", 0.0}}), HasSubstr("must be a period in seconds"));
  EXPECT_THAT(refusal({{"pga_g", 0.4}, {"period_s", 1.0}}), HasSubstr("/excitation/period_s = 1.0: is for \"sa_g\""));
  EXPECT_THAT(refusal({{"sa_p_g", 0.4}, {"period_s", 1.0}}), HasSubstr("is for \"sa_g\""));
  EXPECT_THAT(refusal({{"avgsa_g", 0.4}, {"period_s", 1.0}}), HasSubstr("write \"periods_s\""));
  EXPECT_THAT(refusal({{"avgsa_g", 0.4}}), HasSubstr("/excitation/periods_s"));
  EXPECT_THAT(refusal({{"avgsa_g", 0.4}, {"periods_s", {2.0, 0.5}}}), HasSubstr("must rise"));
  EXPECT_THAT(refusal({{"avgsa_g", 0.4}, {"periods_s", {0.5, 1.0, 2.0}}}), HasSubstr("/excitation/periods_s"));
  EXPECT_THAT(refusal({{"sa_g", 0.4}, {"period_s", 1.0}, {"pga_g", 0.4}}), HasSubstr("excludes"));
  EXPECT_THAT(refusal({{"sa_g", 1e9}, {"period_s", 1.0}}), HasSubstr("/excitation/sa_g"));
}

TEST_F(Suite, MayHaveRecordsWithAVerticalComponent) {
  const Experiment both =
      read(experiment(R"([{ "file": "records/a.at2", "vertical_file": "v.at2" }, "records/b.at2"])"));
  EXPECT_TRUE(recorded(both.conditions[0]).ground_motion->has_vertical);
  EXPECT_EQ(recorded(both.conditions[0]).ground_motion->samples[1].vertical, 0.02);
  EXPECT_FALSE(recorded(both.conditions[1]).ground_motion->has_vertical);
  const Experiment again = experiment_in(both.canonical_text, {}, surroundings());
  EXPECT_EQ(again.canonical_text, both.canonical_text);
}

TEST_F(Suite, ThatCannotBeReadIsRefusedWithItsPlace) {
  EXPECT_THAT(refusal_of(experiment(R"("none/*.at2")")), HasSubstr("/excitation/suite = \"none/*.at2\": fits no file"));
  EXPECT_THAT(refusal_of(experiment(R"(["records/a.at2", "records/a.at2"])")),
              HasSubstr("/excitation/suite/1 = \"records/a.at2\": is in the suite twice"));
  EXPECT_THAT(refusal_of(experiment("[]")), HasSubstr("must be a list of 1 to 10000 files"));
  EXPECT_THAT(refusal_of(experiment("null")), HasSubstr("must be a list of 1 to 10000 files"));
  EXPECT_THAT(refusal_of(experiment("[3]")), HasSubstr("must be the name of a file"));
  EXPECT_THAT(refusal_of(experiment(R"([{"file": "v.at2", "scale": 2}])")), HasSubstr("/excitation/suite/0/scale"));
  files_["selected.csv"] = "level,file,factor\n0.2,v.at2,-1\n";
  EXPECT_THAT(refusal_of(experiment(R"({"levels": "selected.csv"})")),
              AllOf(HasSubstr("selected.csv, line 2 = \"-1\""), Not(HasSubstr("/excitation/suite"))));
  Json both = experiment(R"(["v.at2"])");
  both["excitation"]["file"] = "v.at2";
  EXPECT_THAT(refusal_of(both), HasSubstr("excludes \"file\""));
  EXPECT_THAT(
      refusal_of(experiment(
          R"(["v.at2"])", R"([{ "parameter": "/excitation", "values": [{ "kind": "recorded", "file": "v.at2" }] }])")),
      HasSubstr("changes the excitation, whose ground motions are a suite"));
  EXPECT_THAT(refusal_of(experiment(R"(["v.at2"])", R"([{ "parameter": "/excitation/file", "values": ["v.at2"] }])")),
              HasSubstr("without its digest"));
  Json within = experiment(R"(["v.at2"])");
  within["sweep"] =
      Json::parse(R"([{ "parameter": "/excitation", "values": [{ "kind": "recorded", "suite": ["v.at2"] }] }])");
  within["excitation"] = Json::parse(R"({ "kind": "recorded", "file": "v.at2" })");
  EXPECT_THAT(refusal_of(within), HasSubstr("/excitation/suite = [\"v.at2\"]: cannot stand in a value of the sweep"));
}

TEST_F(Suite, HasEachRecordOnceWhateverItsName) {
  files_["./records/a.at2"] = files_["records/../records/a.at2"] = files_["copy.at2"] = files_["records/a.at2"];
  for (const char* other : {"./records/a.at2", "records/../records/a.at2", "copy.at2"}) {
    const std::string both = "[\"records/*.at2\", \"" + std::string(other) + "\"]";
    EXPECT_THAT(refusal_of(experiment(both)), HasSubstr("/excitation/suite/1 = \"" + std::string(other) +
                                                        "\": has the same content as \"records/a.at2\""));
  }
  EXPECT_THAT(refusal_of(experiment(R"(["copy.at2", {"file": "records/a.at2", "vertical_file": "v.at2"}])")),
              HasSubstr("/excitation/suite/1 = \"records/a.at2\": has the same content as \"copy.at2\""));
}

TEST_F(Suite, HasEachSeriesOnceWhateverItsFormatUnitOrName) {
  std::vector<double> values;
  for (int i = 0; i < 50; ++i) values.push_back(0.3 * std::sin(0.37 * i) * std::exp(-0.05 * i));
  files_["one.at2"] = support::peer_at2(values, ".01");
  files_["two.at2"] = files_["one.at2"] + "\n";
  files_["three.asc"] = support::esm_asc("0.01", "cm/s^2", "", support::peer_values([&] {
                                           std::vector<double> in_gal = values;
                                           for (double& value : in_gal) value *= 980.665;
                                           return in_gal;
                                         }()));
  files_["four.txt"] = support::columns_text(values, 0.01, 9.81, 4);
  files_["five.txt"] = support::columns_text(values, 0.01, 1.0, 5);  // in g, but m/s2 is assumed
  for (const char* name : {"two.at2", "three.asc", "four.txt", "five.txt"}) {
    EXPECT_THAT(
        refusal_of(experiment(R"(["v.at2", "one.at2", ")" + std::string(name) + "\"]")),
        AllOf(HasSubstr("/excitation/suite = \"" + std::string(name) + "\": has the same series as \"one.at2\""),
              HasSubstr("to 0.2 % of its peak")));
  }
  EXPECT_THAT(refusal_of(experiment(R"(["five.txt", "one.at2"])")), HasSubstr("if five.txt is in g; m/s2 was assumed"));
  // A series that is 1 % different at one sample is another one, and so is one at other times, or twice as strong.
  std::vector<double> others = values;
  others[20] += 0.003;
  files_["six.at2"] = support::peer_at2(others, ".01");
  files_["seven.at2"] = support::peer_at2(values, ".02");
  for (double& value : values) value *= 2.0;
  files_["eight.at2"] = support::peer_at2(values, ".01");
  EXPECT_EQ(refusal_of(experiment(R"(["one.at2", "six.at2", "seven.at2", "eight.at2"])")), "accepted");
}

TEST_F(Suite, TellsOfTheFirstFiveRepeatedSeries) {
  std::string files = "[\"v.at2\"";
  for (int i = 0; i < 7; ++i) {
    const std::string name = std::to_string(i) + ".txt";
    files_[name] = "0 0.3\n5 0.2\n" + std::string(static_cast<std::size_t>(i), '\n');
    files += ", \"" + name + '"';
  }
  const std::string told = refusal_of(experiment(files + ']'));
  std::size_t count = 0;
  for (auto at = told.find("same series"); at != std::string::npos; at = told.find("same series", at + 1)) ++count;
  EXPECT_EQ(count, 5U) << told;
}

// All constants have one shape, so that they are the same only if they are equal.
TEST_F(Suite, MayHaveConstantsThatAreNearlyEqual) {
  files_["one.txt"] = "0 0.3\n6 0.3\n";
  files_["two.txt"] = "0 0.3003\n6 0.3003\n";
  files_["again.txt"] = "0.0 0.30\n6.0 0.30\n";
  EXPECT_EQ(refusal_of(experiment(R"(["one.txt", "two.txt"])")), "accepted");
  EXPECT_THAT(refusal_of(experiment(R"(["one.txt", "again.txt"])")), HasSubstr("has the same series as \"one.txt\""));
}

TEST_F(Suite, RefusesVerticalComponentsByNameAndByHeader) {
  const auto with_component = [](const std::string& component) {
    std::string text = support::peer_at2({0.3, 0.1, -0.2, 0.1}, ".01");
    return text.replace(text.find(", 000\n") + 2, 3, component);
  };
  const auto refusal = [&](const std::string& name, const std::string& component) {
    files_[name] = with_component(component);
    return refusal_of(experiment("[\"records/a.at2\", \"" + name + "\"]"));
  };
  for (const char* name : {"RSN6_IMPVALL.I_I-ELC-UP.AT2", "TCU068-V.AT2", "a/b_ver.txt", "site.UD", "IWT010UD.at2",
                           "UD.txt", "x-dwn.AT2", "s-Z.at2", "c UP.AT2.txt"}) {
    EXPECT_THAT(refusal(name, "XYZ"), AllOf(HasSubstr("is a vertical component by its name ("),
                                            HasSubstr("\"vertical_file\": \"" + std::string(name))))
        << name;
  }
  for (const char* component : {"UP", "VERTICAL", "V (CWB)", "up (USGS STATION 5)", "DWN"}) {
    EXPECT_THAT(refusal("CBGSUP9.at2", component), HasSubstr("is a vertical component by its header (")) << component;
  }
  EXPECT_THAT(refusal("t-UP.AT2", "180"), HasSubstr("by its name (UP)")) << "a name that is clear";
  for (const char* name : {"UPLAND000.at2", "V.at2", "A-VER180.at2", "VERNON-N.AT2", "group.at2", "UDINE-EW.AT2",
                           "A-ZAK360.AT2", "up/x.at2", "DZC180.AT2", "JUMPUP.at2"}) {
    EXPECT_EQ(refusal(name, "XYZ"), "accepted") << name;
  }
  EXPECT_EQ(refusal("TCU068-V.AT2", "090"), "accepted") << "a letter that the header contradicts";
  files_["IV.NRC..HNZ.D.20160824.ACC.ASC"] = support::esm_asc("0.01", "cm/s^2", "", "50\n-80\n20\n");
  EXPECT_THAT(refusal_of(experiment(R"(["records/a.at2", "IV.NRC..HNZ.D.20160824.ACC.ASC"])")), HasSubstr("(HNZ)"));
}

TEST_F(Suite, RefusesANameThatIsNoUtf8AndFitsAPattern) {
  Surroundings with_such_a_name = surroundings();
  with_such_a_name.matches = [](const std::string&) { return std::vector<std::string>{"records/\xff.at2"}; };
  try {
    static_cast<void>(experiment_in(experiment(R"("records/*.at2")").dump(), {}, with_such_a_name));
    ADD_FAILURE() << "accepted";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/excitation/suite = \"records/\\ufffd.at2\""));
    EXPECT_THAT(error.what(), HasSubstr("no UTF-8"));
  }
}

TEST_F(Suite, RefusesTwoStrengthsAndUnitsThatContradict) {
  Json json = experiment(R"(["v.at2"])");
  json["excitation"]["scale"] = 1.0;
  json["excitation"]["pga_g"] = 0.4;
  EXPECT_THAT(refusal_of(json), HasSubstr("/excitation/pga_g = 0.4: excludes \"scale\""));
  json["excitation"].erase("pga_g");
  json["excitation"]["units"] = "cm/s2";
  EXPECT_THAT(refusal_of(json), HasSubstr("v.at2, line 3 = \"g\": is the unit of the file"));
  json["excitation"].erase("units");
  json["excitation"]["format"] = "columns";
  EXPECT_THAT(refusal_of(json), HasSubstr("/excitation/units: is missing"));
  json["excitation"]["format"] = "auto";
  EXPECT_EQ(refusal_of(json), "accepted");
  EXPECT_FALSE(Json::parse(read(json).canonical_text)["excitation"].contains("format"));
}

TEST_F(Suite, SkipsAFileThatIsCutOrInAnotherUnitAndNamesTheFlag) {
  std::string cut = support::peer_at2({0.1, -0.2, 0.05}, ".01");
  files_["cut.at2"] = cut.substr(0, cut.size() - 3) + "E";
  files_["velocity.at2"] = "a\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01 SEC\n1 2\n";
  const Overrides skip{.seed = {}, .realisations = {}, .levels = {}, .skips_unreadable = true};
  for (const char* bad : {"cut.at2", "velocity.at2"}) {
    const Json json = experiment("[\"records/a.at2\", \"" + std::string(bad) + "\"]");
    EXPECT_THAT(refusal_of(json), HasSubstr("--skip-unreadable goes on with the other 1: a.at2")) << bad;
    const Experiment read = experiment_in(json.dump(), skip, surroundings());
    EXPECT_THAT(left_out_of(Json::parse(read.canonical_text)), ElementsAre(bad));
  }
}

// One bad file among several: told with the names of the others, or left out.
TEST_F(Suite, NamesTheRecordsThatCanBeReadBesideABadOne) {
  files_["records/b.at2"] = "no numbers";
  EXPECT_THAT(
      refusal_of(experiment(R"(["records/a.at2", "records/b.at2", "v.at2"])")),
      AllOf(HasSubstr("records/b.at2: "), HasSubstr("--skip-unreadable goes on with the other 2: a.at2, v.at2")));
}

TEST_F(Suite, GoesOnWithoutRecordsThatCannotBeRead) {
  files_["records/b.at2"] = "no numbers";
  const std::string text = experiment(R"(["records/a.at2", "records/b.at2", "missing.at2", "v.at2"])",
                                      R"([{ "parameter": "/excitation/pga_g", "values": [0.2, 0.4] }])")
                               .dump();
  const Overrides skip{.seed = {}, .realisations = {}, .levels = {}, .skips_unreadable = true};
  const Experiment read = experiment_in(text, skip, surroundings());
  EXPECT_THAT(read.sweep_sizes, ElementsAre(2U, 2U));
  EXPECT_EQ(recorded(read.conditions[2]).ground_motion->name, "v.at2");
  const Json canonical = Json::parse(read.canonical_text);
  EXPECT_THAT(left_out_of(canonical), ::testing::UnorderedElementsAre("missing.at2", "records/b.at2"));
  // The canonical text is that of the readable records and says what was left out, also when it is read again.
  EXPECT_EQ(experiment_in(read.canonical_text, {}, surroundings()).canonical_text, read.canonical_text);
  EXPECT_EQ(experiment_in(read.canonical_text, skip, surroundings()).canonical_text, read.canonical_text);
  // Nothing is left out without a reason, nor if nothing would be left.
  const std::string good = experiment(R"(["records/a.at2", "v.at2"])").dump();
  EXPECT_EQ(experiment_in(good, skip, surroundings()).canonical_text,
            experiment_in(good, {}, surroundings()).canonical_text);
  const std::string bad = experiment(R"(["records/b.at2"])").dump();
  EXPECT_THROW(static_cast<void>(experiment_in(bad, skip, surroundings())), base::InputError);
  EXPECT_THROW(static_cast<void>(experiment_in(experiment(R"(["gone.at2"])").dump(), skip, surroundings())),
               base::InputError);
}

TEST_F(Suite, RefusesABadListOfRecordsLeftOut) {
  Json json = experiment(R"(["records/a.at2"])");
  json["excitation"]["left_out"] = "b.at2";
  EXPECT_THAT(refusal_of(json), HasSubstr("/excitation/left_out = \"b.at2\": must be a list of names"));
  json["excitation"].erase("suite");
  json["excitation"]["file"] = "v.at2";
  EXPECT_THAT(refusal_of(json), HasSubstr("/excitation/left_out"));
}

/// PEER's table, with two records that have both horizontal components, and one without.
std::string peer_table(const std::string& magnitude = "7.28") {
  return " PEER Ground Motion Database, Time Series Search Report\n\n -- Summary of Metadata of Selected Records --\n"
         "Result ID, Record Sequence Number, Scale Factor, Earthquake Name, Station Name, Magnitude, Rrup (km), "
         "Horizontal-1 "
         "Acc. Filename, Horizontal-2 Acc. Filename, Vertical Acc. Filename\n"
         "1, 864, 1.5, \"A, B\", \"Fire Sta #3\", " +
         magnitude +
         ", 11.03, a.at2, b.at2 , v.at2  \r\n"
         "2, 865, -, \"C\", \"D\", -999, , c.at2, -----, v.at2\n,,,,\n"
         " These records are UNSCALED,,\n   .AT2 = Acceleration\nPeriod (sec),Target pSa (g)\n0.01,0.5\n";
}

TEST_F(Suite, MayBeTheTableOfPeersSearch) {
  files_["records/_SearchResults.csv"] = peer_table();
  files_["records/c.at2"] = support::peer_at2({0.4, 0.1, 0.05, 0.0}, ".01");
  const Experiment found = read(experiment(R"("records/_SearchResults.csv")"));
  ASSERT_EQ(found.conditions.size(), 3U);
  EXPECT_EQ(recorded(found.conditions[0]).ground_motion->name, "records/a.at2");
  EXPECT_EQ(mean_of(recorded(found.conditions[0]).scale), 1.5);
  EXPECT_EQ(mean_of(recorded(found.conditions[1]).scale), 1.5);
  EXPECT_EQ(recorded(found.conditions[1]).ground_motion->name, "records/b.at2");
  EXPECT_EQ(mean_of(recorded(found.conditions[2]).scale), 1.0) << "no factor";
  EXPECT_EQ(recorded(found.conditions[0]).magnitude, 7.28);
  EXPECT_EQ(recorded(found.conditions[0]).distance_km, 11.03);
  EXPECT_FALSE(recorded(found.conditions[2]).magnitude) << "-999 is unknown";
  EXPECT_FALSE(recorded(found.conditions[2]).distance_km);
  const Experiment again = experiment_in(found.canonical_text, {}, surroundings());
  EXPECT_EQ(again.canonical_text, found.canonical_text);
  EXPECT_EQ(recorded(again.conditions[1]).scale, recorded(found.conditions[1]).scale);
  EXPECT_THAT(found.canonical_text, AllOf(HasSubstr(R"("factor":1.5)"), HasSubstr(R"("magnitude":7.28)")));
  const Experiment twice =
      read(experiment(R"("records/_SearchResults.csv")", R"([{"parameter": "/excitation/scale", "values": [1, 2]}])"));
  EXPECT_EQ(mean_of(recorded(twice.conditions[1]).scale), 3.0) << "a scale multiplies the factor";
  const Experiment measured =
      read(experiment(R"("records/_SearchResults.csv")", R"([{"parameter": "/excitation/pga_g", "values": [0.4]}])"));
  EXPECT_EQ(mean_of(recorded(measured.conditions[1]).scale), 1.0) << "a measure takes the place of the factor";
}

TEST_F(Suite, RefusesATableOfPeerThatIsNotAsItMustBe) {
  files_["records/_SearchResults.csv"] = peer_table("x");
  files_["records/c.at2"] = support::peer_at2({0.4, 0.1, 0.05, 0.0}, ".01");
  EXPECT_THAT(refusal_of(experiment(R"("records/_SearchResults.csv")")),
              AllOf(HasSubstr("records/_SearchResults.csv, line 5"), HasSubstr("\"x\"")));
  files_["records/_SearchResults.csv"] = " -- Summary of Metadata of Selected Records --\nA, B\n1, 2\n";
  EXPECT_THAT(refusal_of(experiment(R"("records/_SearchResults.csv")")), HasSubstr("Horizontal-1 Acc. Filename"));
}

TEST_F(Suite, RefusesATableOfPeerFromWhichARecordWouldBeLost) {
  files_["records/c.at2"] = support::peer_at2({0.4, 0.1, 0.05, 0.0}, ".01");
  const auto complaint_with = [this](const std::string& there, const std::string& instead) {
    std::string text = peer_table();
    const std::size_t place = text.find(there);
    EXPECT_NE(place, std::string::npos) << there;
    files_["records/_SearchResults.csv"] = text.replace(place, there.size(), instead);
    return refusal_of(experiment(R"("records/_SearchResults.csv")"));
  };
  const auto in_line = [](const char* line, const char* reason) {
    return AllOf(HasSubstr("records/_SearchResults.csv, line " + std::string(line)), HasSubstr(reason));
  };
  EXPECT_THAT(complaint_with(", b.at2 , v.at2", ""), in_line("5", "has 8 fields, but the first line has 10"));
  EXPECT_THAT(complaint_with("11.03", "11,03"), in_line("5", "has 11 fields, but the first line has 10"));
  EXPECT_THAT(complaint_with("b.at2 ,", ","), in_line("5", "has no Horizontal-2 Acc. Filename"));
  EXPECT_THAT(complaint_with("\"A, B\"", "\"A, B"), in_line("5", "a quotation mark that is not closed"));
  EXPECT_THAT(complaint_with("\"A, B\"", "A, B\""), in_line("5", "a quotation mark that is not closed"));
  EXPECT_THAT(complaint_with("2, 865", "\n2, 865"), in_line("7", "names a record behind the empty line"));
  for (const char* column : {"Horizontal-2 Acc. Filename", "Scale Factor", "Magnitude", "Rrup (km)"}) {
    EXPECT_THAT(complaint_with(column, "Another"), HasSubstr("has no column"));
  }
  EXPECT_THAT(complaint_with("Station Name", "Magnitude"), HasSubstr("has several columns \"Magnitude\""));
}

TEST_F(Suite, RefusesALevelWithMoreOrFewerFieldsThanItsHeader) {
  const auto complaint_about = [this](const std::string& lines) {
    files_["records/selection.csv"] = lines;
    return refusal_of(experiment(R"({"levels": "records/selection.csv"})"));
  };
  const std::string header = "level,file,factor\n0.2,a.at2,0.5\n";
  EXPECT_THAT(complaint_about(header + "0.6,b.at2,1,75\n"),
              AllOf(HasSubstr("selection.csv, line 3"), HasSubstr("has 4 fields, but the first line has 3")));
  EXPECT_THAT(complaint_about(header + "0.6,b.at2\n"), HasSubstr("has 2 fields, but the first line has 3"));
  EXPECT_THAT(complaint_about("level,file,factor,comp\n0.6,b.at2,1,x\n"), HasSubstr("has the column \"comp\""));
  EXPECT_EQ(complaint_about("# selected\n" + header + ",,\n0.6;b.at2;1 # the last\n"), "accepted");
}

TEST_F(Suite, MayGiveEachLevelItsOwnRecordsAndFactors) {
  files_["records/selection.csv"] = "level,file,factor\n0.2,a.at2,0.5\n0.2,b.at2,0.25\n0.8,b.at2,3.25\n";
  const Experiment found = read(experiment(R"({"levels": "records/selection.csv"})"));
  ASSERT_EQ(found.conditions.size(), 3U);
  EXPECT_EQ(recorded(found.conditions[0]).level, 0.2);
  EXPECT_EQ(mean_of(recorded(found.conditions[1]).scale), 0.25);
  EXPECT_EQ(recorded(found.conditions[2]).level, 0.8);
  EXPECT_EQ(mean_of(recorded(found.conditions[2]).scale), 3.25);
  EXPECT_EQ(recorded(found.conditions[1]).ground_motion, recorded(found.conditions[2]).ground_motion);
  EXPECT_EQ(found.conditions[1].record_stream, found.conditions[2].record_stream);
  EXPECT_EQ(json_of(found.conditions[2].parameters.front().value), "records/b.at2, level 0.8");
  const Experiment again = experiment_in(found.canonical_text, {}, surroundings());
  EXPECT_EQ(again.canonical_text, found.canonical_text);
  files_["records/selection.csv"] = "file,level\na.at2,0.2\n";
  EXPECT_THAT(refusal_of(experiment(R"({"levels": "records/selection.csv"})")), HasSubstr("no column \"factor\""));
  files_["records/selection.csv"] = "level,file,factor\n0.2,a.at2,\n";
  EXPECT_THAT(refusal_of(experiment(R"({"levels": "records/selection.csv"})")),
              AllOf(HasSubstr("selection.csv, line 2"), HasSubstr("without a level, a file or a factor")));
  files_["records/selection.csv"] = "level,file,factor\n0.2,a.at2,-1\n";
  EXPECT_THAT(refusal_of(experiment(R"({"levels": "records/selection.csv"})")), HasSubstr("which must be positive"));
  files_["records/selection.csv"] = "level,file,factor\n0.2,a.at2,1\n0.2,a.at2,2\n";
  EXPECT_THAT(refusal_of(experiment(R"({"levels": "records/selection.csv"})")), HasSubstr("is in the suite twice"));
  EXPECT_THAT(refusal_of(experiment(R"({"level": "records/selection.csv"})")), HasSubstr("must have \"levels\" alone"));
}

}  // namespace

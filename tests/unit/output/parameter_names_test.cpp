// Names of the files of a grid.

#include "rocking/output/parameter_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocking {
namespace {

using ::testing::ElementsAre;

TEST(ParameterNames, AreTheKeysAndValues) {
  const std::vector<std::vector<Parameter>> parts{
      {{"/friction/static", 0.35}, {"/formulation", "as-printed"}},
      {{"/friction/static", 0.30000000000000004}, {"/formulation", "as-printed"}}};
  EXPECT_THAT(parameter_names(parts),
              ElementsAre("static_0.35_formulation_as-printed", "static_0.3_formulation_as-printed"));
}

TEST(ParameterNames, HaveTwoKeysWhereOneIsNotEnough) {
  const std::vector<std::vector<Parameter>> parts{{{"/fluctuation/friction/sigma", 0.01},
                                                   {"/fluctuation/restitution/sigma", 0.02},
                                                   {"/excitation/amplitude", 4.0}}};
  EXPECT_THAT(parameter_names(parts), ElementsAre("friction_sigma_0.01_restitution_sigma_0.02_amplitude_4"));
}

TEST(ParameterNames, AreSafeInAFileSystem) {
  const std::vector<std::vector<Parameter>> parts{{{"/friction", WrittenPart{R"({"static":0.35,"kinetic":0.3})"}}},
                                                  {{"/excitation/file", R"(../data/a b\é:*?"<>|.txt)"}},
                                                  {{"/excitation/file", std::string(500, 'x')}}};
  const auto names = parameter_names(parts);
  EXPECT_EQ(names[0], "friction_0.35_0.3");
  for (const std::string& name : names) {
    EXPECT_LE(name.size(), 120U);
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.+-_"),
              std::string::npos)
        << name;
  }
}

TEST(ParameterNames, DifferFromEachOther) {
  const auto file = [](const char* name) { return std::vector<Parameter>{{"/excitation/file", name}}; };
  const std::vector<std::vector<Parameter>> parts{file("a b"), file("a/b"), file("A_B"), file("a_b_2"), file("a?b")};
  EXPECT_THAT(parameter_names(parts),
              ElementsAre("file_a_b", "file_a_b_2", "file_A_B_3", "file_a_b_2_2", "file_a_b_4"));
}

TEST(ANameOfAValue, StandsInPlaceOfKeyNumberAndUnit) {
  const Parameter plain{"/block/parts/2/bottom_m", 1.5}, named{"/block/parts/2/bottom_m", 1.5, "batteries high"};
  EXPECT_EQ(short_value(named), "batteries high");
  EXPECT_EQ(value_in_words(named), "batteries high");
  EXPECT_NE(value_in_words(plain).find("1.5 m"), std::string::npos);
  EXPECT_EQ(values_of({named, {"/excitation/pga_g", 0.3}}), "batteries high, pga_g 0.3");
}

}  // namespace
}  // namespace rocking

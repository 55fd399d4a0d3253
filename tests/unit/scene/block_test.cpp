// A block in the forms that a file may give, from the file to the numbers of the equations.

#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;

Experiment with_block(const std::string& block) {
  Json document = support::least_experiment();
  document["block"] = Json::parse(block);
  return experiment_in(document.dump());
}

dynamics::Block block_in(const std::string& block) { return mean_block(with_block(block).conditions.at(0).scene); }

std::string refusal_of(const std::string& block) {
  try {
    static_cast<void>(with_block(block));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SceneBlock, OfAUniformRectangleIsOneInEveryForm) {
  const dynamics::Geometry rectangle = dynamics::geometry_of(block_in(R"({"width_m": 0.6, "height_m": 2.0})"));
  for (const std::string form :
       {R"({"width_m": 0.6, "height_m": 2.0, "centre_offset_m": 0})",
        R"({"edges_m": [0.3, 0.3], "centre_height_m": 1.0, "radius_of_gyration_m": 0.6027713773341708})",
        R"({"parts": [{"width_m": 0.6, "height_m": 0.5, "mass_kg": 25, "x_m": 4, "bottom_m": 0},
                      {"width_m": 0.6, "height_m": 1.5, "mass_kg": 75, "x_m": 4, "bottom_m": 0.5}]})"}) {
    const dynamics::Geometry found = dynamics::geometry_of(block_in(form));
    EXPECT_TRUE(found.is_rectangle()) << form;
    EXPECT_NEAR(found.frequency_parameter, rectangle.frequency_parameter, 1e-15) << form;
    EXPECT_NEAR(found.shape_angle, rectangle.shape_angle, 1e-15) << form;
  }
}

// Two point-like masses: by Steiner's theorem m1 m2/(m1 + m2) d^2, over the whole mass.
TEST(SceneBlock, OfPartsHasTheirCentreAndTheirMomentOfInertia) {
  const dynamics::Block block = block_in(R"({"base_m": [-1, 2], "parts": [
      {"width_m": 1e-5, "height_m": 1e-5, "mass_kg": 1, "x_m": 0, "bottom_m": 1},
      {"width_m": 1e-5, "height_m": 1e-5, "mass_kg": 3, "x_m": 0.8, "bottom_m": 1}]})");
  ASSERT_TRUE(block.mass.has_value());
  EXPECT_NEAR(block.mass->left_edge, 1.6, 1e-9);
  EXPECT_NEAR(block.mass->right_edge, 1.4, 1e-9);
  EXPECT_NEAR(block.mass->centre_height, 1.0, 1e-5);
  EXPECT_NEAR(block.mass->radius_of_gyration, std::sqrt(3.0 / 16.0 * 0.64), 1e-9);
}

TEST(SceneBlock, StandsOnThePartsOnTheFloor) {
  const dynamics::Block block = block_in(R"({"parts": [
      {"width_m": 0.4, "height_m": 0.1, "mass_kg": 10, "x_m": 0.1, "bottom_m": 0},
      {"width_m": 2.0, "height_m": 1.0, "mass_kg": 10, "x_m": 0.1, "bottom_m": 0.1}]})");
  EXPECT_NEAR(block.width, 0.4, 1e-15);
  EXPECT_NEAR(block.height, 1.1, 1e-15);
  EXPECT_NEAR(block.mass->left_edge, 0.2, 1e-15);
}

BlockOutline outline_in(const std::string& block) {
  return outline_of(with_block(block).conditions.front().scene.block);
}

TEST(BlockOutline, HasThePartsFromTheLeftEndOfTheBase) {
  const BlockOutline outline = outline_in(R"({"parts": [
      {"width_m": 0.6, "height_m": 0.1, "mass_kg": 10, "x_m": 0.1, "bottom_m": 0},
      {"width_m": 1.0, "height_m": 1.0, "mass_kg": 30, "x_m": 0.2, "bottom_m": 0.1}], "base_m": [-0.1, 0.4]})");
  ASSERT_EQ(outline.rectangles.size(), 2U);
  EXPECT_NEAR(outline.rectangles[0].left, -0.1, 1e-15);
  EXPECT_NEAR(outline.rectangles[0].right, 0.5, 1e-15);
  EXPECT_NEAR(outline.rectangles[1].left, -0.2, 1e-15);
  EXPECT_NEAR(outline.left(), -0.2, 1e-15);
  EXPECT_NEAR(outline.right(), 0.8, 1e-15);
  EXPECT_NEAR(outline.top(), 1.1, 1e-15);
  EXPECT_NEAR(outline.base, 0.5, 1e-15);
  EXPECT_NEAR(outline.centre_x, 0.275, 1e-15);
  EXPECT_NEAR(outline.centre_height, (10 * 0.05 + 30 * 0.6) / 40, 1e-15);
  EXPECT_FALSE(outline.is_plain());
}

TEST(BlockOutline, OfOneRectangleHasItsCentreOfMassWhereItIs) {
  const BlockOutline off =
      outline_in(R"({"width_m": 0.6, "height_m": 2.0, "centre_offset_m": 0.1, "centre_height_m": 0.7})");
  EXPECT_TRUE(off.is_plain() && off.is_given);
  EXPECT_NEAR(off.centre_x, 0.4, 1e-15);
  EXPECT_EQ(off.centre_height, 0.7);
  EXPECT_EQ(off.top(), 2.0);
  const BlockOutline edges =
      outline_in(R"({"edges_m": [0.3, 0.2], "centre_height_m": 1.0, "radius_of_gyration_m": 0.6})");
  EXPECT_TRUE(edges.is_plain());
  EXPECT_FALSE(edges.is_given);
  EXPECT_EQ(edges.centre_x, 0.3);
  EXPECT_EQ(edges.top(), 2.0);
}

TEST(SceneBlock, MovesTheEdgesWithTheOffsetOfItsCentre) {
  const dynamics::Block block =
      block_in(R"({"width_m": 0.6, "height_m": 2.0, "centre_offset_m": 0.1, "centre_height_m": 0.7})");
  EXPECT_NEAR(block.mass->left_edge, 0.4, 1e-15);
  EXPECT_NEAR(block.mass->right_edge, 0.2, 1e-15);
  EXPECT_EQ(block.mass->centre_height, 0.7);
  EXPECT_NEAR(block.mass->radius_of_gyration, std::sqrt(4.36 / 12.0), 1e-15);
}

TEST(SceneBlock, ThatNoBodyCanBeIsRefusedWithTheReason) {
  EXPECT_THAT(refusal_of(R"({"width_m": 0.6, "height_m": 2.0, "centre_offset_m": 0.35})"),
              HasSubstr("centre of mass outside its base, 0.05 m beyond the right edge"));
  EXPECT_THAT(refusal_of(R"({"width_m": 0.6, "height_m": 2.0, "centre_height_m": 2.5})"),
              HasSubstr("centre of mass above its outline"));
  EXPECT_THAT(refusal_of(R"({"width_m": 0.6, "height_m": 2.0, "radius_of_gyration_m": 1.0441})"),
              HasSubstr("mass within its outline, with this centre, has at most 1.04403 m"));
  EXPECT_THAT(refusal_of(R"({"width_m": 0.6, "height_m": 2.0, "radius_of_gyration_m": 1.044})"), "accepted");
  EXPECT_THAT(refusal_of(R"({"width_m": 0.6, "height_m": 2.0, "centre_offset_m": {"uniform": [0.0, 0.4]}})"),
              HasSubstr("at an end of what its laws reach"));
  const std::string part = R"({"width_m": 1, "height_m": 1, "mass_kg": 1, "x_m": 0, "bottom_m": )";
  EXPECT_THAT(refusal_of(R"({"parts": [)" + part + "-0.1}]}"), HasSubstr("no part reaches below the floor"));
  EXPECT_THAT(refusal_of(R"({"parts": [)" + part + "0.1}]}"), HasSubstr("no part that stands on the floor"));
  EXPECT_THAT(refusal_of(R"({"parts": [], "base_m": [0, 1]})"), HasSubstr("must be a list of 1 to 32 parts"));
  EXPECT_THAT(refusal_of(R"({"parts": [)" + part + R"(0.1}], "base_m": [0.3, 0.3]})"), HasSubstr("left end"));
}

TEST(SceneBlock, HasOneFormAndAllItsNumbers) {
  EXPECT_THAT(refusal_of(R"({"edges_m": [0.3, 0.2]})"), HasSubstr("/block/centre_height_m: is missing"));
  EXPECT_THAT(refusal_of(R"({"edges_m": [0.3], "centre_height_m": 1, "radius_of_gyration_m": 1})"),
              HasSubstr("must be a list of two numbers: [left, right]; give one number for each edge"));
  EXPECT_THAT(refusal_of(R"({"width_m": 1, "edges_m": [0.3, 0.2], "centre_height_m": 1, "radius_of_gyration_m": 1})"),
              HasSubstr("/block/width_m = 1: is for a block with an outline"));
  EXPECT_THAT(refusal_of(R"({"width_m": 1, "height_m": 2, "base_m": [0, 1]})"), HasSubstr("is for a block of parts"));
  EXPECT_THAT(refusal_of(R"({"parts": [{"width_m": 1, "height_m": 1, "mass_kg": 1, "x_m": 0}]})"),
              HasSubstr("/block/parts/0/bottom_m: is missing"));
}

TEST(SceneBlock, HasTheFrequencyParameterAndTheSlendernessOfAPaper) {
  for (const auto& [p, psi] : {std::pair("2.14", "0.25"), {"0.5", "0.001"}, {"8", "1.2"}}) {
    const std::string form = std::string(R"({"p_rad_s": )") + p + R"(, "slenderness_rad": )" + psi + "}";
    const dynamics::Geometry found = dynamics::geometry_of(block_in(form));
    EXPECT_TRUE(found.is_rectangle());
    EXPECT_NEAR(found.frequency_parameter / std::stod(p), 1.0, 2e-15) << "some roundings";
    EXPECT_NEAR(found.shape_angle / std::stod(psi), 1.0, 2e-15);
    EXPECT_TRUE(outline_in(form).is_plain());
    EXPECT_TRUE(outline_in(form).is_given);
  }
  const std::string text = with_block(R"({"slenderness_rad": 0.25, "p_rad_s": 2})").canonical_text;
  EXPECT_THAT(text, HasSubstr(R"("block":{"p_rad_s":2.0,"slenderness_rad":0.25,"gravity_m_s2":9.81})"));
  EXPECT_EQ(experiment_in(text).canonical_text, text);
}

TEST(SceneBlock, OfAPaperMayBeSwept) {
  Json document = support::least_experiment();
  document["block"] = {{"p_rad_s", 2.0}, {"slenderness_rad", 0.25}};
  document["sweep"] = Json::parse(R"([{"parameter": "/block/slenderness_rad", "values": [0.1, 0.3]}])");
  const Experiment experiment = experiment_in(document.dump());
  const auto psi = [&](std::size_t i) {
    return dynamics::geometry_of(mean_block(experiment.conditions.at(i).scene)).shape_angle;
  };
  EXPECT_NEAR(psi(0), 0.1, 1e-15);
  EXPECT_NEAR(psi(1), 0.3, 1e-15);
}

TEST(SceneBlock, OfAPaperHasBothNumbersAndNoOthers) {
  EXPECT_THAT(refusal_of(R"({"p_rad_s": 2.14})"), HasSubstr("/block/slenderness_rad: is missing"));
  EXPECT_THAT(refusal_of(R"({"slenderness_rad": 0.2})"), HasSubstr("/block/p_rad_s: is missing"));
  const std::string both = R"({"p_rad_s": 2.14, "slenderness_rad": 0.2, )";
  for (const std::string other : {R"("width_m": 1)", R"("edges_m": [1, 1])", R"("parts": [])", R"("base_m": [0, 1])"}) {
    EXPECT_THAT(refusal_of(both + other + "}"), HasSubstr("excludes \"p_rad_s\" and \"slenderness_rad\"")) << other;
  }
  EXPECT_THAT(refusal_of(R"({"p_rad_s": 0, "slenderness_rad": 0.2})"), HasSubstr("positive number of rad/s"));
  EXPECT_THAT(refusal_of(R"({"p_rad_s": 1, "slenderness_rad": 14})"), HasSubstr("from 1e-6 to 1.57: arctan(B/H)"));
  EXPECT_THAT(refusal_of(R"({"p_rad_s": 0.001, "slenderness_rad": 0.2})"),
              HasSubstr("which must lie from 1e-6 to 1e6 m"));
}

TEST(SceneBlock, ThatIsNoRectangleHasNoFormulaOfRectangles) {
  Json document = support::least_experiment();
  document["block"] = {{"edges_m", {0.3, 0.2}}, {"centre_height_m", 1.0}, {"radius_of_gyration_m", 0.6}};
  EXPECT_NO_THROW(static_cast<void>(experiment_in(document.dump())));
  for (const auto& [key, value] : {std::pair("restitution", "jy25"), std::pair("slide_inertia", "edge"),
                                   std::pair("formulation", "as-printed"), std::pair("formulation", "as-plotted")}) {
    Json other = document;
    other[key] = value;
    EXPECT_THROW(static_cast<void>(experiment_in(other.dump())), base::InputError) << key << ' ' << value;
    other["block"] = {{"width_m", 0.6}, {"height_m", 2.0}, {"centre_offset_m", 0.0}};
    EXPECT_NO_THROW(static_cast<void>(experiment_in(other.dump()))) << key << ' ' << value;
  }
}

TEST(SceneBlock, StandsInTheCanonicalTextAsItWasGiven) {
  for (
      const std::string block :
      {R"({"edges_m":[{"uniform":[0.2,0.3]},0.2],"centre_height_m":1.0,"radius_of_gyration_m":0.6,"gravity_m_s2":9.81})",
       R"({"parts":[{"width_m":1.0,"height_m":1.0,"mass_kg":{"normal":{"mean":9.0,"sigma":0.5}},"x_m":0.0,"bottom_m":0.0}],"base_m":[-0.25,0.5],"gravity_m_s2":9.81})"}) {
    EXPECT_EQ(Json::parse(with_block(block).canonical_text)["block"].dump(), block);
  }
}

TEST(SceneBlock, LiesBetweenTheShapesOfItsCorners) {
  const Scene scene = with_block(R"({"edges_m": [{"uniform": [0.2, 0.4]}, 0.3], "centre_height_m": {"uniform": [1, 2]},
                                     "radius_of_gyration_m": 0.6})")
                          .conditions.at(0)
                          .scene;
  const auto [slender, squat, least_tangents] = shapes_of(scene.block);
  EXPECT_NEAR(slender.edges[0].tangent, 0.1, 1e-15);
  EXPECT_NEAR(squat.edges[0].tangent, 0.4, 1e-15);
  EXPECT_NEAR(least_tangents[0], 0.1, 1e-15);
  EXPECT_NEAR(least_tangents[1], 0.15, 1e-15);
  const auto [smallest, largest] = sizes_of(scene.block);
  EXPECT_NEAR(smallest.half_diagonal, std::hypot(0.25, 1.0), 1e-15);
  EXPECT_NEAR(largest.half_diagonal, std::hypot(0.35, 2.0), 1e-15);
}

}  // namespace
}  // namespace rocking

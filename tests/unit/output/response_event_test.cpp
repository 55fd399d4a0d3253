// Events as people write them.

#include <cmath>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/response_event_text.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

ResponseEvent event_in(std::string_view text) {
  const auto found = read_event(text);
  const auto* event = std::get_if<ResponseEvent>(&found);
  EXPECT_NE(event, nullptr) << text << ": " << (event == nullptr ? std::get<NoEvent>(found).reason : "");
  return event == nullptr ? ResponseEvent{} : *event;
}

TEST(ResponseEvent, IsReadWithAndWithoutBlanks) {
  EXPECT_EQ(event_in("overturning"), ResponseEvent{});
  for (const char* text : {"tilt > 0.5 psi", "tilt>0.5psi", " tilt >5e-1 psi "}) {
    EXPECT_EQ(event_in(text), (ResponseEvent{EventName::tilt, 0.5})) << text;
  }
  for (const char* text : {"slip > 0.05 m", "slip>0.05m"}) {
    EXPECT_EQ(event_in(text), (ResponseEvent{EventName::slip, 0.05})) << text;
  }
  EXPECT_EQ(event_in("displacement > 1 m"), (ResponseEvent{EventName::displacement, 1.0}));
}

TEST(ResponseEvent, IsWrittenAsItIsRead) {
  for (const char* text :
       {"overturning", "tilt > 0.5 psi", "tilt > 5 deg", "tilt > 0.1 rad", "slip > 0.05 m", "displacement > 0.05 m"}) {
    EXPECT_EQ(event_text(event_in(text)), text);
  }
}

TEST(ResponseEvent, IsRefusedWithAReasonAndARemedy) {
  for (const auto& [text, reason] : {std::pair{"", "is no event"},
                                     {"sliding > 1 m", "is no event"},
                                     {"Slip > 1 m", "is no event"},
                                     {"overturning > 1", "has no threshold"},
                                     {"slip", "lacks its threshold"},
                                     {"slip 0.05 m", "is no event"},
                                     {"slip > ", "lacks a number after >"},
                                     {"slip > m", "lacks a number after >"},
                                     {"slip > nan m", "must exceed a number of at least 0, at most 1e9"},
                                     {"slip >= 0.05 m", "lacks a number after >"},
                                     {"slip > -0.05 m", "must exceed a number of at least 0, at most 1e9"},
                                     {"slip > 0.05", "lacks its unit, m"},
                                     {"slip > 5 cm", "must be in m"},
                                     {"slip > 0.05 0.06 m", "must be in m"},
                                     {"tilt > 5", "lacks its unit"},
                                     {"tilt > 5 psi", "lies beyond balance, which is at 1 psi"},
                                     {"tilt > 5 m", "has no known unit of a tilt"}}) {
    const auto found = read_event(text);
    ASSERT_TRUE(std::holds_alternative<NoEvent>(found)) << text;
    EXPECT_EQ(std::get<NoEvent>(found).reason, reason) << text;
    EXPECT_FALSE(std::get<NoEvent>(found).remedy.empty()) << text;
  }
}

// psi of a block of 1 m by 4 m is 14.04 degrees.
TEST(ResponseEvent, OfATiltInDegreesIsAShareOfTheBalanceOfTheBlock) {
  Json document = support::least_experiment();
  const auto psi = std::atan(0.25);
  const auto in_psi = [&document](std::string_view text) {
    return in_units_of_balance(event_in(text), experiment_in(document.dump()).conditions);
  };
  EXPECT_DOUBLE_EQ(in_psi("tilt > 5 deg").threshold, 5.0 * std::acos(-1.0) / 180.0 / psi);
  EXPECT_DOUBLE_EQ(in_psi("tilt > 0.1 rad").threshold, 0.1 / psi);
  EXPECT_EQ(in_psi("tilt > 0.5 psi").threshold, 0.5);
  EXPECT_EQ(does(in_psi("tilt > 5 deg")), "tilts beyond 5 deg");
  const auto complaint = [&in_psi](std::string_view text) -> std::string {
    try {
      static_cast<void>(in_psi(text));
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint("tilt > 50 deg"), HasSubstr("beyond balance, which this block has at 14.04 deg"));
  document["sweep"] = Json::parse(R"([{"parameter": "/block/width_m", "values": [1, 2]}])");
  // Of blocks of 1 m and 2 m, which balance at 14.04 and 26.57 degrees, 5 degrees are 0.356 and 0.188 psi.
  EXPECT_THAT(complaint("tilt > 5 deg"),
              AllOf(HasSubstr("have several angles psi"), HasSubstr("as `tilt > 0.356 psi`"),
                    HasSubstr("0.188 psi of that at the largest"), HasSubstr("make a run for each block")));
  EXPECT_THAT(complaint("tilt > 20 deg"), AllOf(HasSubstr("as `tilt > 0.753 psi`"), HasSubstr("it is 1.42 psi")));
  EXPECT_THAT(complaint("tilt > 30 deg"), HasSubstr("at 26.57 deg"));
  EXPECT_EQ(complaint("tilt > 0.5 psi"), "");
  document.erase("sweep");
  document["block"]["width_m"] = Json::parse(R"({"uniform": [0.9, 1.1]})");
  EXPECT_THAT(complaint("tilt > 5 deg"),
              AllOf(HasSubstr("0.356 psi of the mean block"), Not(HasSubstr("a run for each"))));
  document["block"] = Json::parse(R"({"edges_m": [0.5, 0.25], "centre_height_m": 2, "radius_of_gyration_m": 1.2})");
  EXPECT_THAT(complaint("tilt > 5 deg"), AllOf(HasSubstr("as `tilt > 0.702 psi`"), Not(HasSubstr("a run for each"))));
  document["block"]["wall"] = Json::parse(R"({"side": "left", "rate_ratio": 0.5})");
  EXPECT_EQ(complaint("tilt > 5 deg"), "") << "a block at a wall turns about one edge";
}

TEST(ResponseEvent, OfATiltInPsiIsToldInDegreesToo) {
  Json document = support::least_experiment();
  const auto told = [&document](std::string_view text) {
    std::optional<BalanceAngles> balance;
    for (const Condition& each : experiment_in(document.dump()).conditions) {
      balance = joined(balance, balance_of(each.scene));
    }
    return does(event_in(text)) + in_degrees(event_in(text), balance);
  };
  EXPECT_EQ(told("tilt > 0.5 psi"), "tilts beyond 0.5 psi (7.02 degrees)");
  for (const char* text : {"tilt > 5 deg", "overturning", "slip > 1 m"}) EXPECT_EQ(told(text), does(event_in(text)));
  document["sweep"] = Json::parse(R"([{"parameter": "/block/width_m", "values": [2, 1]}])");
  EXPECT_EQ(told("tilt > 0.5 psi"), "tilts beyond 0.5 psi (7.02 to 13.3 degrees)");
  document.erase("sweep");
  document["block"]["width_m"] = Json::parse(R"({"uniform": [0.9, 1.1]})");
  EXPECT_EQ(told("tilt > 0.5 psi"), "tilts beyond 0.5 psi (7.02 degrees of the mean block)");
}

TEST(ResponseEvent, IsSaidInTheWordsOfItsOwnKind) {
  const ResponseEvent slip{EventName::slip, 0.05};
  EXPECT_EQ(words_of(slip), "sliding more than 0.05 m");
  EXPECT_EQ(column_of(slip), "slip > 0.05 m");
  EXPECT_EQ(does(slip), "slides more than 0.05 m");
  EXPECT_EQ(did({EventName::displacement, 0.05}), "ended more than 0.05 m away");
  EXPECT_EQ(to_do({EventName::tilt, 0.5}), "tilt beyond 0.5 psi");
  EXPECT_EQ(did({}), "overturned");
}

}  // namespace
}  // namespace rocking

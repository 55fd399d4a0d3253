// Events as people write them.

#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "rocking/output/response_event_text.hpp"

namespace rocking {
namespace {

ResponseEvent event_in(std::string_view text) {
  const auto found = read_event(text);
  const auto* event = std::get_if<ResponseEvent>(&found);
  EXPECT_NE(event, nullptr) << text << ": " << (event == nullptr ? std::get<NoEvent>(found).reason : "");
  return event == nullptr ? ResponseEvent{} : *event;
}

TEST(ResponseEvent, IsReadWithAndWithoutBlanks) {
  EXPECT_EQ(event_in("overturning"), ResponseEvent{});
  for (const char* text : {"tilt > 0.5", "tilt>0.5", " tilt >5e-1 "}) {
    EXPECT_EQ(event_in(text), (ResponseEvent{EventName::tilt, 0.5})) << text;
  }
  for (const char* text : {"slip > 0.05 m", "slip>0.05m"}) {
    EXPECT_EQ(event_in(text), (ResponseEvent{EventName::slip, 0.05})) << text;
  }
  EXPECT_EQ(event_in("displacement > 1 m"), (ResponseEvent{EventName::displacement, 1.0}));
}

TEST(ResponseEvent, IsWrittenAsItIsRead) {
  for (const char* text : {"overturning", "tilt > 0.5", "slip > 0.05 m", "displacement > 0.05 m"}) {
    EXPECT_EQ(event_text(event_in(text)), text);
  }
}

TEST(ResponseEvent, IsRefusedWithAReasonAndARemedy) {
  for (const auto& [text, reason] :
       {std::pair{"", "is no event"},
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
        {"tilt > 0.5 rad", "has no unit: the tilt is counted in psi, at which the block is in balance"}}) {
    const auto found = read_event(text);
    ASSERT_TRUE(std::holds_alternative<NoEvent>(found)) << text;
    EXPECT_EQ(std::get<NoEvent>(found).reason, reason) << text;
    EXPECT_FALSE(std::get<NoEvent>(found).remedy.empty()) << text;
  }
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

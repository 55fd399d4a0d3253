// The position in a text to which a JSON pointer refers, and how messages show the contents of a file.

#include <string>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/text/locate.hpp"
#include "rocking/text/number_text.hpp"

namespace {

using rocking::lines_of;
using rocking::base::cut_to;
using rocking::base::printable;
using ::testing::ElementsAre;

constexpr const char* lines_text = R"(
{
  "a": { "b": [ 1, "], }",
    { "c/d": 2, "e~": "\"" }
  ],
  "f": 3 },
  "\u0061x": 4,
  "a": 5
})";

TEST(Lines, AreThoseOfTheKey) {
  EXPECT_THAT(lines_of(lines_text, "/a/b"), ElementsAre(3U));
  EXPECT_THAT(lines_of(lines_text, "/a/b/1"), ElementsAre(3U));
  EXPECT_THAT(lines_of(lines_text, "/a/b/2/c~1d"), ElementsAre(4U));
  EXPECT_THAT(lines_of(lines_text, "/a/b/2/e~0"), ElementsAre(4U));
  EXPECT_THAT(lines_of(lines_text, "/ax"), ElementsAre(7U));
}

TEST(Lines, AreAllOfAKeyThatStandsTwice) {
  EXPECT_THAT(lines_of(lines_text, "/a"), ElementsAre(3U, 8U));
  EXPECT_THAT(lines_of(R"({"a": 1, "a": 2})", "/a"), ElementsAre(1U));
}

TEST(Lines, OfWhatIsNotThereAreThoseOfTheInnermostValueOnTheWay) {
  EXPECT_THAT(lines_of(lines_text, "/z"), ElementsAre(2U));
  EXPECT_THAT(lines_of(lines_text, "/a/b/2/z"), ElementsAre(4U));
  EXPECT_THAT(lines_of(lines_text, "/a/b/0/z"), ElementsAre(3U));
}

// `~` before the first slash belongs to no key.
TEST(Lines, OfWhatIsNoPointerAreThoseOfTheDocument) {
  for (const char* pointer : {"", "~", "~1", "a~0b", "~1~0"}) {
    EXPECT_THAT(lines_of(lines_text, pointer), ElementsAre(2U)) << pointer;
  }
  EXPECT_THAT(lines_of(lines_text, "~0x/a"), ElementsAre(3U, 8U));
}

TEST(Lines, AreFoundInTextThatIsNoJson) {
  for (const char* torn :
       {"", "{", "{\"a\"", "{\"a\":", "{\"a\": \"", "[", "[1,", "\"", "{\"a\\", "}}]]", "{,,}", "{{{{"}) {
    EXPECT_EQ(lines_of(torn, "/a/0/b").size(), 1U) << torn;
  }
}

TEST(Printable, ShowsControlCharactersAndBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("a\x1b[31mb\x07\x7f\tc\n"), "a\\x1b[31mb\\x07\\x7f\\x09c\n");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(printable("\xff\xc0\x80\xed\xa0\x80"), "\\xff\\xc0\\x80\\xed\\xa0\\x80");
  EXPECT_EQ(printable("Ω μ_s █ \xf0\x9f\x98\x80"), "Ω μ_s █ \xf0\x9f\x98\x80");
  EXPECT_EQ(printable("\xe2\x96"), "\\xe2\\x96");
}

TEST(Printable, ShowsControlsOfWritingDirection) {
  EXPECT_EQ(printable("a\u202e2ta.exe"), "a\\u202e2ta.exe");
  EXPECT_EQ(printable("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u2066\u2067\u2068\u2069"),
            "\\u061c\\u200e\\u200f\\u202a\\u202b\\u202c\\u202d\\u2066\\u2067\\u2068\\u2069");
  EXPECT_EQ(printable("\u061b\u061d\u200d\u2010\u2029\u202f\u2065\u206a"),
            "\u061b\u061d\u200d\u2010\u2029\u202f\u2065\u206a");
}

TEST(Printable, IsEveryMessageAboutInput) {
  const std::string message =
      to_string(rocking::base::Problem{.place = "/\x1b[2J", .value = "v\x07", .reason = "r", .remedy = "\r"});
  EXPECT_EQ(message, "/\\x1b[2J = v\\x07: r; \\x0d");
}

TEST(Messages, CutLongPlacesAndValuesBetweenLetters) {
  EXPECT_EQ(cut_to("abcdef", 6), "abcdef");
  EXPECT_EQ(cut_to("abcdefg", 6), "abc...");
  EXPECT_EQ(cut_to("abΩdefg", 6), "ab...");
  const std::string long_text(1'000'000, 'x');
  EXPECT_LT(to_string(rocking::base::Problem{.place = '/' + long_text, .value = long_text, .reason = "r", .remedy = ""})
                .size(),
            300U);
}

TEST(Levels, AreToldFromCertainty) {
  using rocking::level_text;
  EXPECT_EQ(level_text(0.95), "95");
  EXPECT_EQ(level_text(0.999), "99.9");
  EXPECT_EQ(level_text(0.999999999999).substr(0, 12), "99.999999999");
  EXPECT_NE(level_text(0.9999999999999999), "100");
}

}  // namespace

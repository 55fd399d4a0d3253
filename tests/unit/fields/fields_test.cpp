// One list of fields a struct: what is written, read, refused and described.

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/text/json.hpp"

namespace rocking::fields_test {

struct Inner {
  double share = 0.5;
  std::optional<double> mean;
};

struct Sized {
  std::uint64_t count = 0;
};

struct Extent {
  double low = 0.0;
  double high = 1.0;
};

struct Corners {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
};

struct Pair {
  Corners first, second;
  double left = 0.0;
};

struct Everything {
  Sized size;
  Inner inner;
  std::vector<Inner> list;
  std::map<std::string, double> by_name;
  std::array<double, 2> pair{};
  std::string word = "one";
  bool is_on = false;
  int number = 0;
  std::optional<std::string> note;
  std::optional<std::optional<double>> scale;
  std::optional<Extent> extent;
};

static const StructType& fields_of(const Inner*) {
  static const StructType fields{
      "Inner",
      field<&Inner::share>("share", "of the total", rule::share),
      field<&Inner::mean>("mean", "null where nothing was counted", rule::positive),
  };
  return fields;
}

static const StructType& fields_of(const Extent*) {
  static const StructType fields{
      "Extent",
      field<&Extent::low>("low", "lower end"),
      field<&Extent::high>("high", "upper end"),
  };
  return fields;
}

static const StructType& fields_of(const Corners*) {
  static const StructType fields{
      "Corners",
      field<&Corners::left>("left", "edge"),
      field<&Corners::right>("right", "edge"),
      field<&Corners::top>("top", "edge"),
      field<&Corners::bottom>("bottom", "edge"),
  };
  return fields;
}

static const StructType& fields_of(const Pair*) {
  static const StructType fields{
      "Pair",
      field<&Pair::first>("first", "one"),
      field<&Pair::second>("second", "another"),
      field<&Pair::left>("left", "edge"),
  };
  return fields;
}

static const StructType& fields_of(const Everything*) {
  static constexpr std::array<std::string_view, 2> words{"one", "two"};
  static const StructType fields{
      "Everything",
      field<&Everything::size, &Sized::count>("count", "how many"),
      derived<[](const Everything& all) { return 2.0 * all.inner.share; }>("twice", "twice the share"),
      inlined<&Everything::inner>(),
      field<&Everything::list>("list", "of parts"),
      field<&Everything::by_name>("by_name", "a number for each name", rule::not_negative),
      field<&Everything::pair>("pair", "two numbers"),
      field<&Everything::word>("word", "one of two", {.choices = words}),
      field<&Everything::is_on>("is_on", "whether it is on"),
      field<&Everything::number>("number", "any whole number"),
      field<&Everything::note>("note", "in words", {}, WithoutValue::omitted),
      field<&Everything::scale>("scale", "null where none will do", rule::positive, WithoutValue::omitted),
      inlined<&Everything::extent>(),
  };
  return fields;
}

namespace {

const DocumentOf<Everything>& document() {
  static const DocumentOf<Everything> document("rocking.everything/1", "An example.");
  return document;
}

Everything example() {
  Everything all;
  all.size.count = 18446744073709551615U;
  all.inner = {.share = 0.1, .mean = 1e-300};
  all.list = {{.share = 1.0, .mean = std::nullopt}, {.share = 0.0, .mean = 2.0}};
  all.by_name = {{"b", 2.0}, {"a", 1.5}};
  all.pair = {-1.0, 0.1 + 0.2};
  all.word = "two";
  all.is_on = true;
  all.number = -3;
  return all;
}

Json json_of(const std::string& text) {
  std::vector<base::Problem> problems;
  return parse_json(text, problems);
}

std::vector<std::string> complaints(const Json& json) {
  std::vector<std::string> lines;
  try {
    static_cast<void>(document().read(json));
  } catch (const base::InputError& error) {
    for (const base::Problem& problem : error.problems()) lines.push_back(to_string(problem));
  }
  return lines;
}

TEST(Fields, AreWrittenInTheirOrderWithAllDigits) {
  EXPECT_EQ(document().text(example()), R"({
  "format": "rocking.everything/1",
  "count": 18446744073709551615,
  "twice": 0.2,
  "share": 0.1,
  "mean": 1e-300,
  "list": [
    {
      "share": 1.0,
      "mean": null
    },
    {
      "share": 0.0,
      "mean": 2.0
    }
  ],
  "by_name": {
    "a": 1.5,
    "b": 2.0
  },
  "pair": [
    -1.0,
    0.30000000000000004
  ],
  "word": "two",
  "is_on": true,
  "number": -3
}
)");
}

TEST(Fields, AreReadAsTheyWereWritten) {
  Everything all = example();
  EXPECT_EQ(document().text(document().read(json_of(document().text(all)))), document().text(all));
  all.note = "a note";
  EXPECT_EQ(document().read(json_of(document().text(all))).note, "a note");
}

TEST(Fields, ThatAreOmittedDifferFromThoseThatAreNull) {
  Everything all = example();
  all.scale.emplace();
  EXPECT_TRUE(json_of(document().text(all)).at("scale").is_null());
  EXPECT_EQ(json_of(document().schema_text())["properties"]["scale"]["type"], Json::array({"number", "null"}));
}

TEST(Fields, OfAnOptionalMemberAreAllThereOrNoneIs) {
  Everything all = example();
  EXPECT_FALSE(document().read(json_of(document().text(all))).extent);
  all.extent = {.low = -1.0, .high = 3.0};
  Json json = json_of(document().text(all));
  EXPECT_EQ(json["low"], -1.0);
  EXPECT_EQ(document().read(json).extent->high, 3.0);
  json.erase("low");
  EXPECT_THAT(complaints(json), ::testing::ElementsAre("/low = null: is missing"));
  json.erase("high");
  EXPECT_THAT(complaints(json), ::testing::IsEmpty());
}

TEST(Fields, ReportEveryFaultWithItsPlaceAndRemedy) {
  Json json = json_of(document().text(example()));
  json["count"] = -1;
  json["list"][1]["share"] = 1.5;
  json["list"][0].erase("mean");
  json["by_name"]["a"] = "x";
  json["pair"] = Json::array({1.0});
  json["word"] = "three";
  json["is_on"] = 1;
  json["number"] = 3e9;
  json["nmber"] = 1;
  json["twice"] = "is derived, and not read";
  EXPECT_THAT(complaints(json),
              ::testing::ElementsAre(
                  "/nmber = 1: is not a known key; did you mean \"number\"?",
                  "/count = -1: must be a whole number, not negative", "/list/0/mean = null: is missing",
                  "/list/1/share = 1.5: must be at least 0 and at most 1", "/by_name/a = \"x\": must be a number",
                  "/pair = [1.0]: must be a list of 2 entries", "/word = \"three\": must be one of one, two",
                  "/is_on = 1: must be true or false", "/number = 3000000000.0: must be a whole number"));
}

TEST(Fields, AreCheckedWhereTheyWereSetInCpp) {
  const auto problems_of = [](const Everything& all) {
    std::vector<base::Problem> problems;
    fields_of(&all).check(&all, {.pointer = "", .problems = &problems});
    std::vector<std::string> texts;
    for (const base::Problem& problem : problems) texts.push_back(base::to_string(problem));
    return texts;
  };
  Everything all = example();
  EXPECT_THAT(problems_of(all), ::testing::IsEmpty());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  all.inner.share = 1.5;
  all.list.push_back({.share = 0.5, .mean = nan});
  all.by_name["b"] = -1.0;
  all.pair[1] = std::numeric_limits<double>::infinity();
  all.word = "three";
  all.scale = std::optional(0.0);
  all.extent = Extent{.low = nan};
  const std::string last = "/list/" + std::to_string(all.list.size() - 1);
  EXPECT_THAT(problems_of(all),
              ::testing::ElementsAre("/share = 1.5: must be at least 0 and at most 1",
                                     last + "/mean = nan: must be above 0", "/by_name/b = -1: must be at least 0",
                                     "/pair/1 = inf: must be a finite number", "/word = three: must be one of one, two",
                                     "/scale = 0: must be above 0", "/low = nan: must be a finite number"));
}

TEST(Fields, RefuseAnotherFormatAndNumbersThatNoFileHas) {
  Json json = json_of(document().text(example()));
  json["pair"][0] = 1e19;
  EXPECT_THAT(complaints(json), ::testing::ElementsAre(::testing::HasSubstr("/pair/0 = 1e+19: exceeds 1e18")));
  json["pair"][0] = std::nan("");
  EXPECT_THAT(complaints(json), ::testing::ElementsAre(::testing::HasSubstr("NaN is not a number")));
  json["format"] = "rocking.another/1";
  EXPECT_THAT(complaints(json), ::testing::ElementsAre(::testing::HasSubstr("no file of rocking.everything/1")));
  EXPECT_THAT(complaints(Json::array()), ::testing::SizeIs(1));
}

TEST(Fields, DescribeThemselves) {
  const Json schema = json_of(document().schema_text());
  EXPECT_EQ(schema["title"], "Everything");
  EXPECT_EQ(schema["properties"]["list"]["items"]["title"], "Inner");
  EXPECT_EQ(schema["required"], Json::array({"format", "count", "twice", "share", "mean", "list", "by_name", "pair",
                                             "word", "is_on", "number"}));
  EXPECT_EQ(schema["properties"]["mean"], Json::parse(R"({"type": ["number", "null"], "exclusiveMinimum": 0.0,
                            "description": "null where nothing was counted"})"));
  EXPECT_EQ(schema["properties"]["word"]["enum"], Json::array({"one", "two"}));
  EXPECT_EQ(schema["properties"]["count"]["minimum"], 0.0);
  EXPECT_EQ(schema["properties"]["list"]["items"]["required"], Json::array({"share", "mean"}));
  EXPECT_THAT(document().table(), ::testing::HasSubstr("| `list` | of parts |\n| `list[i].share` | of the total |\n"));
}

TEST(Fields, ThatMeanTheSameElsewhereAreOneRowOfATable) {
  EXPECT_EQ(DocumentOf<Pair>("rocking.pair/1", "Two.").table(), R"(| key | meaning |
| --- | --- |
| `first` | one |
| `first.left` | edge |
| `first.right` | edge |
| `first.top` | edge |
| `first.bottom` | edge |
| `second` | another |
| `second.left` to `.bottom` | as of `first` |
| `left` | edge |
)");
}

}  // namespace
}  // namespace rocking::fields_test

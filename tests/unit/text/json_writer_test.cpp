// A document written value by value has the same bytes as one written as a whole.

#include "rocking/text/json_writer.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking {
namespace {

/// Writes a value with a writer that enters every object and list that contains a value, `depth` levels deep, and
/// writes the rest as a whole.
class Walk {
 public:
  explicit Walk(JsonWriter& writer) : writer_(&writer) {}

  void put_members(const Json& object, int depth) {
    for (const auto& [key, value] : object.items()) {
      if (depth == 0 || value.empty() || !value.is_structured()) {
        writer_->member(key, value);
      } else if (value.is_object()) {
        writer_->begin_object(key);
        put_members(value, depth - 1);
        writer_->end();
      } else {
        writer_->begin_list(key);
        put_elements(value, depth - 1);
        writer_->end();
      }
    }
  }

 private:
  // A list within a list has no begin_list: it is written as a whole.
  void put_elements(const Json& list, int depth) {
    for (const Json& value : list) {
      if (depth == 0 || value.empty() || !value.is_object()) {
        writer_->element(value);
      } else {
        writer_->begin_object();
        put_members(value, depth - 1);
        writer_->end();
      }
    }
  }

  JsonWriter* writer_;
};

std::string written(const Json& document, int depth) {
  std::string text;
  const TextSink sink = [&text](std::string_view piece) { text += piece; };
  JsonWriter writer(sink);
  writer.begin_object();
  Walk(writer).put_members(document, depth);
  writer.end();
  return text;
}

/// A value with unusual keys and texts, at most `depth` levels deep.
Json random_value(support::SplitMix& random, int depth) {
  const char* texts[] = {"", "a", "line\nbreak", "\"quoted\" \\", "\x1b\x01\t", "Ü 地震", "{\n  [", "</script>"};
  switch (random.below(depth > 0 ? 8 : 5)) {
    case 0: return nullptr;
    case 1: return random.below(2) == 0;
    case 2: return random.below(1000) - 500;
    case 3: return 1.0 / (1 + random.below(1000));
    case 4: return texts[random.below(8)];
    case 5: {
      Json list = Json::array();
      for (int count = random.below(4); count > 0; --count) list.push_back(random_value(random, depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (int count = random.below(4); count > 0; --count) {
        object[texts[random.below(8)] + std::to_string(count)] = random_value(random, depth - 1);
      }
      return object;
    }
  }
}

TEST(JsonWriter, GivesTheBytesOfADump) {
  support::SplitMix random(11);
  for (int i = 0; i < 2000; ++i) {
    Json document = Json::object();
    document["first"] = random_value(random, 4);
    document["second\n"] = random_value(random, 4);
    for (const int depth : {0, 1, 2, 5}) {
      ASSERT_EQ(written(document, depth), document.dump(2)) << "document " << i << ", depth " << depth;
    }
  }
}

TEST(JsonWriter, PassesEachValueOnAtOnce) {
  std::string text;
  const TextSink sink = [&text](std::string_view piece) { text += piece; };
  JsonWriter writer(sink);
  writer.begin_object();
  writer.begin_list("values");
  writer.element(1);
  EXPECT_EQ(text, "{\n  \"values\": [\n    1");
  writer.element(2);
  EXPECT_TRUE(text.ends_with(",\n    2"));
}

}  // namespace
}  // namespace rocking

// Magnitudes and distances of records: what is read, and every fault with its line.

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_record_metadata.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;

std::string metadata_complaint(const std::string& text) {
  try {
    static_cast<void>(read_record_metadata(text, "m.csv"));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RecordMetadata, AreReadByTheirColumns) {
  const auto found = read_record_metadata(
      "# of the flatfile\nmagnitude, file, distance_km\r\n6.5, \"a b.at2\", 12\n\n7.1,b.at2,3.5 # near\n", "m.csv");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].file, "a b.at2");
  EXPECT_EQ(found[0].magnitude, 6.5);
  EXPECT_EQ(found[1].distance_km, 3.5);
  EXPECT_FALSE(read_record_metadata("file,magnitude\na.at2,6\n", "m.csv")[0].distance_km);
  EXPECT_FALSE(read_record_metadata("file,magnitude\na.at2,\n", "m.csv")[0].magnitude) << "not known";
}

TEST(RecordMetadata, AreRefusedWithLineValueAndRemedy) {
  EXPECT_THAT(metadata_complaint(""), HasSubstr("has no line with the names of the columns"));
  EXPECT_THAT(metadata_complaint("a.at2,6.5\n"), HasSubstr("line 1 = \"a.at2\": is not a column"));
  EXPECT_THAT(metadata_complaint("file,Mw\n"), HasSubstr("line 1 = \"Mw\": is not a column"));
  EXPECT_THAT(metadata_complaint("file,file,magnitude\n"), HasSubstr("stands twice"));
  EXPECT_THAT(metadata_complaint("magnitude,distance_km\n"), HasSubstr("does not name the columns"));
  const std::string header = "file,magnitude,distance_km\n";
  EXPECT_THAT(metadata_complaint(header + "a,6\n"),
              HasSubstr("line 2 = \"a,6\": has 2 fields, but the first line has 3"));
  EXPECT_THAT(metadata_complaint(header + "a,six,10\n"), HasSubstr("line 2 = \"six\": is not a number"));
  EXPECT_THAT(metadata_complaint(header + "a,6,0\n"), HasSubstr("must be positive"));
  for (const char* missing : {"-999", "-9", "-99", "99", "11"}) {
    EXPECT_THAT(metadata_complaint(header + "a," + missing + ",10\n"), HasSubstr("is not a magnitude from 0 to 10"));
  }
  EXPECT_THAT(metadata_complaint(header + "a,6,-999\n"), HasSubstr("must be positive"));
  EXPECT_THAT(metadata_complaint(header + "a,6,1\nb,inf,1\na,6,1\n"), HasSubstr("line 4 = \"a\": stands twice"));
}

}  // namespace
TEST(RecordMetadata, MayBeTheTableOfPeersSearch) {
  const auto found = read_record_metadata(
      "text\n -- Summary of Metadata of Selected Records --,,\nResult ID, Scale Factor, Station Name, Magnitude, Rrup "
      "(km), "
      "Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename\n1, 2, \" \"\"Joshua, Tree #3\"\"\", 7.28, 11.03, a.at2, "
      "b.at2 \n"
      "2, 2, c, -999, , d.at2, -----\n\n These records are UNSCALED\n",
      "_SearchResults.csv");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].file, "b.at2");
  EXPECT_EQ(found[1].magnitude, 7.28);
  EXPECT_EQ(found[1].distance_km, 11.03);
  EXPECT_EQ(found[2].file, "d.at2");
  EXPECT_FALSE(found[2].magnitude);
  EXPECT_FALSE(found[2].distance_km);
}

}  // namespace rocking

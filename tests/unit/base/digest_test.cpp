#include "rocking/base/digest.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace rocking::base {
namespace {

// Examples of FIPS 180-4.
TEST(Sha256, HasThePublishedValues) {
  EXPECT_EQ(to_hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(to_hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(to_hex(sha256(std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePiecesInWhichDataAreAdded) {
  std::string text;
  for (int i = 0; text.size() < 20000; ++i) text += std::to_string(i * i);
  for (const std::size_t first : {0U, 1U, 7U, 1000U, 1023U, 1024U, 1025U, 3000U}) {
    for (const std::size_t piece : {1U, 8U, 64U, 1000U, 1024U, 1025U, 5000U}) {
      Sha256Builder builder;
      builder.add(std::string_view(text).substr(0, first));
      for (std::size_t k = first; k < text.size(); k += piece) builder.add(std::string_view(text).substr(k, piece));
      ASSERT_EQ(builder.finish(), sha256(text)) << first << ", " << piece;
    }
  }
}

TEST(Sha256, OfNumbersIsThatOfTheirBytesInLittleEndianOrder) {
  Sha256Builder numbers;
  numbers.add(std::uint64_t{0x0102030405060708});
  numbers.add(1.0);
  numbers.add(std::array{-2.0});
  Sha256Builder bytes;
  bytes.add(std::string_view("\x08\x07\x06\x05\x04\x03\x02\x01", 8));
  bytes.add(std::string_view("\0\0\0\0\0\0\xf0\x3f", 8));
  bytes.add(std::string_view("\0\0\0\0\0\0\0\xc0", 8));
  EXPECT_EQ(numbers.finish(), bytes.finish());
}

}  // namespace
}  // namespace rocking::base

// Files that exist completely or not at all.

#include "rocking/text/files.hpp"

#include <cstdlib>
#include <system_error>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace {

namespace fs = std::filesystem;
using namespace rocking;

class Files : public ::testing::Test {
 protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "rocking-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Files() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(Files, AreReadAsTheyWereWritten) {
  const std::string content("a\0b\r\n\xff", 6);
  write_atomically(folder_ / "x", content);
  EXPECT_EQ(read_file(folder_ / "x"), content);
  write_atomically(folder_ / "x", "short");
  EXPECT_EQ(read_file(folder_ / "x"), "short");
}

TEST_F(Files, AreReadNoFurtherThanAsked) {
  write_atomically(folder_ / "x", std::string(1'000'000, 'x'));
  const std::string start = read_file(folder_ / "x", 1000);
  EXPECT_GT(start.size(), 1000U) << "so that one can see that there is more";
  EXPECT_LT(start.size(), 1'000'000U);
  EXPECT_EQ(read_file(folder_ / "x", 1'000'000).size(), 1'000'000U);
}

TEST_F(Files, AreSeenFromAFolder) {
  write_atomically(folder_ / "x", "content");
  EXPECT_EQ(files_seen_from(folder_)("x", 100), "content");
  EXPECT_EQ(files_seen_from("/nowhere")((folder_ / "x").string(), 100), "content") << "unless the place is absolute";
}

TEST_F(Files, FitAPatternWithoutAFolder) {
  for (const char* name : {"x.at2", "Y.AT2", "z.txt"}) write_atomically(folder_ / name, "content");
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const std::vector<std::string> found = matches_seen_from("")("*.at2");
  fs::current_path(before);
  EXPECT_EQ(found, (std::vector<std::string>{"Y.AT2", "x.at2"})) << "in letters of any case";
}

TEST_F(Files, LeaveNothingBesideThem) {
  write_atomically(folder_ / "x", "content");
  ensure_writable(folder_);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Files, LeaveNothingWhereTheyCannotBeMade) {
  fs::create_directory(folder_ / "x");  // a folder has that name
  EXPECT_THROW(write_atomically(folder_ / "x", "content"), std::system_error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Files, NameThePathThatFails) {
  try {
    static_cast<void>(read_file(folder_ / "absent"));
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_NE(std::string(error.what()).find("absent"), std::string::npos);
  }
}

TEST_F(Files, HaveThePermissionsThatTheUmaskLeaves) {
  const mode_t before = umask(022);
  for (const mode_t mask : {022U, 077U, 002U}) {
    umask(mask);
    write_atomically(folder_ / "x", "content");
    struct stat facts {};
    ASSERT_EQ(stat((folder_ / "x").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0666U & ~mask);
  }
  umask(before);
}

TEST_F(Files, AreNotPromisedWhereAFileIsTheFolder) {
  write_atomically(folder_ / "x", "content");
  EXPECT_THROW(ensure_writable(folder_ / "x"), std::system_error);
  EXPECT_THROW(ensure_writable(folder_ / "x" / "y"), std::system_error);
  EXPECT_NO_THROW(ensure_writable(folder_ / "a" / "b"));
}

}  // namespace

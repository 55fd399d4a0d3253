// What follows from the lists of fields, and stands in files for readers: schemas and tables of keys.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "rocking/studies/studies.hpp"

namespace {

using namespace rocking;

std::string content_of(const std::string& path) {
  std::ifstream file(std::filesystem::path(ROCKING_SOURCE_DIR) / path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Documents, HaveTheirSchemasInReports) {
  for (const std::string& name : format_names()) {
    const std::string path = "reports/schemas/" + name + ".schema.json";
    EXPECT_EQ(content_of(path), schema_of(name)) << "write it with `rocking schema " << name << " > " << path << '`';
  }
}

TEST(Documents, HaveTheirKeysInTheDocumentsOfFormats) {
  const std::string formats = content_of("lib/docs/formats.md") + content_of("lib/docs/reference/keys.md");
  for (const std::string& name : format_names()) {
    const auto table = keys_of(name);
    ASSERT_TRUE(table) << name;
    const std::size_t section = formats.find("## `rocking." + name + "/1`");
    ASSERT_NE(section, std::string::npos) << name;
    const std::size_t end = formats.find("\n## ", section);
    EXPECT_NE(formats.substr(section, end - section).find(*table), std::string::npos)
        << "the section of " << name << " lacks the table that `rocking schema " << name << " --keys` prints";
  }
}

}  // namespace

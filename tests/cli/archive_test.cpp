// A run as one file: the same bytes, found faults, the rules of RO-Crate 1.1, and records that travel with it.

#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using ::testing::HasSubstr;

class AnArchive : public rocking::support::ProgramTest {
 protected:
  AnArchive() { run_quietly("run quick.json -o out"); }

  /// `script` with the names of the archive in `zip` and of Python's zipfile in `zipfile`.
  std::string python(const std::string& script) const {
    const auto outcome = shell("python3 -c '\nimport json, zipfile\n" + script + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome.output;
  }

  /// The archive with an entry replaced.
  void replace(const std::string& entry, const std::string& by) const {
    python(
        "old = zipfile.ZipFile(\"run.zip\")\nnew = zipfile.ZipFile(\"changed.zip\", \"w\")\n"
        "for name in old.namelist():\n  new.writestr(name, " +
        by + " if name == \"" + entry + "\" else old.read(name))\nnew.close()");
  }
};

TEST_F(AnArchive, HasTheSameBytesAndIsVerified) {
  ASSERT_EQ(rocking("archive out -o run.zip").exit_code, 0);
  ASSERT_EQ(shell("sleep 2; cp -r out moved").exit_code, 0);
  ASSERT_EQ(rocking("archive moved -o again.zip").exit_code, 0);
  EXPECT_EQ(read("run.zip"), read("again.zip"));
  std::filesystem::remove_all(folder_ / "out");
  const auto verified = rocking("verify run.zip");
  EXPECT_EQ(verified.exit_code, 0) << verified.errors;
  EXPECT_THAT(verified.output, HasSubstr("run.zip: 12 realisations run again, all with the same bits"));
}

TEST_F(AnArchive, TellsWhichFileIsNotAsItWas) {
  ASSERT_EQ(rocking("archive out -o run.zip").exit_code, 0);
  replace("report.json", "old.read(name).replace(b\"0.95\", b\"0.96\")");
  auto verified = rocking("verify changed.zip");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("report.json: has the SHA-256"));
  std::string bytes = read("run.zip");
  bytes[bytes.find("realisations.sqlite") + 2000] ^= 1;
  write("changed.zip", bytes);
  verified = rocking("verify changed.zip");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("realisations.sqlite: cannot be read"));
  python(
      "import struct\nsize = zipfile.ZipFile(\"run.zip\").getinfo(\"report.json\").file_size\n"
      "longer = [struct.pack(\"<I\", each) for each in (size, size + 1)]\n"
      "open(\"changed.zip\", \"wb\").write(open(\"run.zip\", \"rb\").read().replace(*longer))");
  EXPECT_THAT(rocking("verify changed.zip").output, HasSubstr("report.json: cannot be read: its bytes are damaged"));
  write("changed.zip", "no archive");
  EXPECT_EQ(rocking("verify changed.zip").exit_code, 65);
  EXPECT_EQ(rocking("verify absent.zip").exit_code, 66);
  replace("ro-crate-metadata.json", "b\"{\\\"@graph\\\": [{\\\"@id\\\": 3, \\\"sha256\\\": 4}]}\"");
  verified = rocking("verify changed.zip");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("report.json: is not in ro-crate-metadata.json"));
}

TEST_F(AnArchive, ReplacesOnlyAnArchive) {
  for (int i = 0; i < 2; ++i) EXPECT_EQ(rocking("archive out -o run.zip").exit_code, 0);
  write("notes.zip", "PK, no archive");
  const auto refused = rocking("archive out -o notes.zip");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, HasSubstr("notes.zip: already exists and is no archive"));
  EXPECT_EQ(read("notes.zip"), "PK, no archive");
  for (const char* name : {"out", "quick.json", "''"}) {
    EXPECT_EQ(rocking(std::string("archive out -o ") + name).exit_code, 64) << name;
  }
  EXPECT_FALSE(exists(".unfinished"));
}

TEST_F(AnArchive, KeepsTheRulesOfRoCrate) {
  ASSERT_EQ(rocking("archive out -o run.zip").exit_code, 0);
  const Json crate =
      Json::parse(python("print(zipfile.ZipFile(\"run.zip\").read(\"ro-crate-metadata.json\").decode())"));
  const Json names = Json::parse(python("print(json.dumps(zipfile.ZipFile(\"run.zip\").namelist()))"));
  EXPECT_EQ(crate["@context"][0], "https://w3id.org/ro/crate/1.1/context");
  std::map<std::string, Json> entities;
  for (const Json& entity : crate["@graph"]) {
    EXPECT_TRUE(entity.contains("@type"));
    EXPECT_TRUE(entities.emplace(entity["@id"], entity).second) << entity["@id"];
  }
  const Json& descriptor = entities.at("ro-crate-metadata.json");
  EXPECT_EQ(descriptor["about"]["@id"], "./");
  EXPECT_EQ(descriptor["conformsTo"]["@id"], "https://w3id.org/ro/crate/1.1");
  const Json& root = entities.at("./");
  EXPECT_EQ(root["@type"], "Dataset");
  for (const char* key : {"name", "description", "datePublished", "license"}) EXPECT_FALSE(root[key].empty()) << key;
  std::set<std::string> parts{"ro-crate-metadata.json"}, in_zip;
  for (const Json& part : root["hasPart"]) {
    EXPECT_EQ(entities.at(part["@id"])["@type"], "File");
    parts.insert(part["@id"]);
  }
  for (const Json& name : names) in_zip.insert(name);
  EXPECT_EQ(parts, in_zip);
  const Json& run = entities.at("#run");
  EXPECT_EQ(run["@type"], "CreateAction");
  EXPECT_EQ(entities.at(run["instrument"]["@id"])["@type"], "SoftwareApplication");
  for (const char* key : {"object", "result"}) {
    for (const Json& thing : run[key]) EXPECT_TRUE(entities.contains(thing["@id"])) << thing;
  }
}

TEST_F(AnArchive, CarriesItsRecordsWhereItIsAskedTo) {
  std::ofstream pulse(folder_ / "pulse.txt");
  for (int i = 0; i < 200; ++i) pulse << 0.01 * i << ' ' << (i % 40 < 20 ? 3.0 : -3.0) << '\n';
  pulse.close();
  write("recorded.json", rocking::support::recorded_experiment().dump());
  run_quietly("run recorded.json -o recorded");
  ASSERT_EQ(rocking("archive recorded -o bare.zip").exit_code, 0);
  ASSERT_EQ(rocking("archive recorded -o full.zip --with-records").exit_code, 0);
  std::filesystem::remove(folder_ / "pulse.txt");
  EXPECT_EQ(rocking("verify bare.zip").exit_code, 66);
  const auto verified = rocking("verify full.zip");
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
}

TEST_F(AnArchive, IsRefusedOfAnUnfinishedRun) {
  std::filesystem::remove(folder_ / "out" / "report.json");
  const auto refused = rocking("archive out -o run.zip");
  EXPECT_EQ(refused.exit_code, 66);
  EXPECT_THAT(refused.errors, HasSubstr("has no finished run"));
  EXPECT_FALSE(exists("run.zip"));
}

}  // namespace

// The store of a run: rows are read as written, and damaged ones are refused by name.

#include "rocking/store/store.hpp"

#include <fstream>
#include <type_traits>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/store/difference.hpp"
#include "rocking/store/store_identity.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

using sqlite::Access;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Identity identity{.experiment = "{}", .code = "1 abc", .files = "/records", .shard = {}};

/// A summary in which all fields differ, from each other and from those of other numbers.
Summary filled(std::uint64_t number) {
  Summary summary;
  std::uint64_t value = 1000 * number;
  for_each_field(summary, [&value](const auto&, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    ++value;
    if constexpr (std::is_same_v<Field, std::uint64_t>) field = value + (1ULL << 60U);
    if constexpr (std::is_same_v<Field, double>) field = 1.0 / static_cast<double>(value);
    if constexpr (std::is_same_v<Field, std::optional<double>>) field = 1.0 / static_cast<double>(value);
    if constexpr (std::is_same_v<Field, bool>) field = value % 2 == 0;
    if constexpr (std::is_same_v<Field, base::Sha256>) field = base::sha256(std::to_string(value));
    if constexpr (std::is_same_v<Field, std::optional<std::int64_t>>) field = static_cast<std::int64_t>(value);
  });
  summary.mode = section::periodic(static_cast<int>(number), 3);
  summary.termination = dynamics::Termination::stopped;
  summary.reason = section::Reason::stable_orbit;
  summary.overturned_side = dynamics::Side::right;
  summary.rerun_mode = section::ResponseMode{.kind = section::ResponseKind::chaotic};
  return summary;
}

TEST(Store, GivesBackEveryFieldOfARow) {
  Store store = Store::in_memory(identity);
  const Summary empty;
  store.add({2, 7}, filled(1));
  store.add({2, 8}, empty);
  EXPECT_THAT(differing_fields(store.find({2, 7}).value(), filled(1)), IsEmpty());
  EXPECT_THAT(differing_fields(store.find({2, 8}).value(), empty), IsEmpty());
  EXPECT_FALSE(store.find({7, 2}).has_value());
}

TEST(DifferingFields, NamesEachFieldThatDiffers) {
  Summary other = filled(1);
  other.digest = base::sha256("x");
  other.rerun_mode.reset();
  other.clamps.restitution = 3;
  EXPECT_THAT(differing_fields(filled(1), other), ElementsAre("digest", "rerun_mode", "clamped_restitution"));
}

TEST(Store, GivesTheRowsOfAConditionInTheirOrderToOneOfSeveralThreads) {
  const support::TemporaryFolder folder;
  Store store = Store::create(folder / "a.sqlite", identity);
  constexpr std::uint64_t conditions = 41;
  for (std::uint64_t i = 0; i < 3 * conditions; ++i) store.add({i % conditions, i / conditions}, filled(1));
  const auto expect_all = [&store](const char* state) {
    std::vector<std::vector<std::uint64_t>> found(conditions);
    store.for_each_side_by_side({.threads = 3}, [&found](const RealisationKey& key, const Summary&) {
      found[key.condition].push_back(key.realisation);
    });
    EXPECT_THAT(found, ::testing::Each(ElementsAre(0, 1, 2))) << state;
  };
  expect_all("not durable yet");
  store.close_up();
  expect_all("in its file");
  std::filesystem::rename(folder / "a.sqlite", folder / "b.sqlite");
  expect_all("in a file that was moved");
}

TEST(Store, WalksItsRowsInTheOrderOfTheirKeys) {
  Store store = Store::in_memory(identity);
  for (const RealisationKey key : {RealisationKey{1, 0}, {0, 10}, {0, 9}, {1, 2}, {0, 0}}) store.add(key, filled(1));
  std::vector<RealisationKey> keys;
  store.for_each([&keys](const RealisationKey& key, const Summary&) { keys.push_back(key); });
  EXPECT_THAT(keys, ElementsAre(RealisationKey{0, 0}, RealisationKey{0, 9}, RealisationKey{0, 10}, RealisationKey{1, 0},
                                RealisationKey{1, 2}));
}

TEST(Store, CountsResponseModesBelowANumber) {
  Store store = Store::in_memory(identity);
  for (std::uint64_t number = 0; number < 10; ++number) store.add({4, number}, filled(1 + number % 3));
  store.add({3, 0}, filled(2));
  EXPECT_THAT(store.mode_counts(4, 7),
              ElementsAre(std::pair(section::periodic(1, 3), 3U), std::pair(section::periodic(2, 3), 2U),
                          std::pair(section::periodic(3, 3), 2U)));
  EXPECT_THAT(store.mode_counts(5, 7), IsEmpty());
}

TEST(Store, HasTheSameRowsWhenItIsMadeOfItsBytes) {
  const support::TemporaryFolder folder;
  Store in_file = Store::create(folder / "a.sqlite", identity);  // has a write-ahead log until it is closed up
  Store in_memory = Store::in_memory(identity);
  for (Store* store : {&in_file, &in_memory}) {
    for (std::uint64_t number = 0; number < 500; ++number) store->add({number % 3, number}, filled(number));
    store->commit();
    Store again = Store::of_bytes(store->bytes());
    EXPECT_EQ(again.identity().experiment, identity.experiment);
    EXPECT_FALSE(again.damage().has_value());
    EXPECT_THAT(differing_fields(again.find({1, 400}).value(), filled(400)), IsEmpty());
    again.add({3, 0}, filled(1));
    EXPECT_FALSE(store->find({3, 0}).has_value());
  }
  EXPECT_THROW(static_cast<void>(Store::of_bytes("no store")), sqlite::UnusableFile);
  EXPECT_THROW(static_cast<void>(Store::of_bytes("")), sqlite::UnusableFile);
}

TEST(Store, KeepsItsIdentity) {
  const support::TemporaryFolder folder;
  Identity part = identity;
  part.shard = Shard{.part = 2, .parts = 5};
  { Store::create(folder / "a.sqlite", part).close_up(); }
  const Identity read = Store::open(folder / "a.sqlite", Access::read).identity();
  EXPECT_EQ(read.experiment, "{}");
  EXPECT_EQ(read.code, "1 abc");
  EXPECT_EQ(read.files, "/records");
  ASSERT_TRUE(read.shard.has_value());
  EXPECT_EQ(read.shard->part, 2U);
  EXPECT_EQ(read.shard->parts, 5U);
}

TEST(Store, LosesOnlyWhatWasNotCommitted) {
  const support::TemporaryFolder folder;
  Store store = Store::create(folder / "a.sqlite", identity);
  store.add({0, 0}, filled(1));
  store.commit();
  store.add({0, 1}, filled(2));
  const Store onlooker = Store::open(folder / "a.sqlite", Access::read);
  EXPECT_TRUE(onlooker.find({0, 0}).has_value());
  EXPECT_FALSE(onlooker.find({0, 1}).has_value());
  store.commit();
  EXPECT_TRUE(onlooker.find({0, 1}).has_value());
}

TEST(Store, LeavesASingleFileWhenItIsClosedUp) {
  const support::TemporaryFolder folder;
  {
    Store store = Store::create(folder / "a.sqlite", identity);
    store.add({0, 0}, filled(1));
    store.close_up();
  }
  { EXPECT_TRUE(Store::open(folder / "a.sqlite", Access::read).find({0, 0}).has_value()); }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite-wal"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite-shm"));
}

std::string complaint(const std::filesystem::path& path) {
  try {
    Store::open(path, Access::read).for_each([](const RealisationKey&, const Summary&) {});
  } catch (const sqlite::UnusableFile& error) {
    return error.what();
  }
  return "";
}

TEST(Store, TellsOfARowThatWasChanged) {
  const support::TemporaryFolder folder;
  {
    Store store = Store::create(folder / "a.sqlite", identity);
    for (std::uint64_t number = 0; number < 4; ++number) store.add({1, number}, filled(number));
    store.close_up();
  }
  EXPECT_EQ(complaint(folder / "a.sqlite"), "");
  for (const char* change : {"mode = '(1,1)'", "steps = steps + 1", "diverged_from_next = NULL", "margin = 2.0",
                             "in_transient = 1 - in_transient"}) {
    std::filesystem::copy_file(folder / "a.sqlite", folder / "b.sqlite",
                               std::filesystem::copy_options::overwrite_existing);
    sqlite::Database(folder / "b.sqlite", Access::write)
        .execute(std::string("UPDATE realisations SET ") + change + " WHERE realisation = 2");
    EXPECT_THAT(complaint(folder / "b.sqlite"), HasSubstr("condition 1, realisation 2")) << change;
  }
}

// Computed outside with hashlib: the digest of "{}", the key and the fields in their order; numbers as eight bytes in
// little-endian order, a name after its length, a field that may be absent after 0 or 1. The checksum is the first eight
// bytes of that SHA-256 in big-endian order. Another value would make every existing store unreadable.
TEST(Store, WritesTheChecksumThatItsLayoutDefines) {
  const support::TemporaryFolder folder;
  {
    Store store = Store::create(folder / "a.sqlite", identity);
    store.add({1, 7}, filled(7));
    store.close_up();
  }
  const sqlite::Database database(folder / "a.sqlite", Access::read);
  EXPECT_EQ(sqlite::number_in(database, "SELECT checksum FROM realisations"), 7249833026511371180);
}

TEST(Store, RefusesWhatIsNoStore) {
  const support::TemporaryFolder folder;
  std::ofstream(folder / "text") << std::string(5000, 'x');
  EXPECT_THAT(complaint(folder / "text"), HasSubstr("text"));
  sqlite::Database(folder / "other.sqlite", Access::create).execute("CREATE TABLE realisations (a)");
  EXPECT_THAT(complaint(folder / "other.sqlite"), HasSubstr("not a store"));
  EXPECT_THROW((void)Store::open(folder / "absent.sqlite", Access::read), std::system_error);
}

TEST(Store, OfAnotherLayoutIsRefusedWithTheVersionThatReadsIt) {
  for (const std::int64_t layout : {std::int64_t{0}, current_layout - 1, current_layout + 1}) {
    const support::TemporaryFolder folder;
    const auto path = folder / "a.sqlite";
    Store::create(path, identity).close_up();
    sqlite::Database(path, Access::write).execute("PRAGMA user_version = " + std::to_string(layout));
    EXPECT_THAT(complaint(path), AllOf(HasSubstr("was written by rocking 1 abc in layout " + std::to_string(layout)),
                                       HasSubstr("this program reads layout " + std::to_string(current_layout))));
  }
}

TEST(Store, TellsOfAFileThatWasCutShort) {
  const support::TemporaryFolder folder;
  {
    Store store = Store::create(folder / "a.sqlite", identity);
    for (std::uint64_t number = 0; number < 400; ++number) store.add({0, number}, filled(number));
    store.close_up();
  }
  std::filesystem::resize_file(folder / "a.sqlite", std::filesystem::file_size(folder / "a.sqlite") / 2);
  EXPECT_THAT(complaint(folder / "a.sqlite"), HasSubstr("damaged"));
}

}  // namespace
}  // namespace rocking

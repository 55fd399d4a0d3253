// A store with changed or lost bytes: the damage is reported, and undamaged rows are kept. Also a store without shared
// memory.

#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <sqlite3.h>

#include "rocking/ensemble/run.hpp"
#include "rocking/store/difference.hpp"
#include "rocking/store/salvage.hpp"
#include "rocking/store/store.hpp"
#include "support/split_mix.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using sqlite::Access;
using ::testing::HasSubstr;

const Identity the_identity{.experiment = "{\"a\": 1}", .code = "1 abc", .files = "/records", .shard = {}};
constexpr std::uint64_t stored = 300;

Experiment small_experiment() {
  Experiment question;
  question.conditions.resize(2);
  for (Condition& condition : question.conditions) {
    condition.realisations = stored;
    condition.scene.initial.tilt = Uniform{.low = 0.0, .high = 0.1};
  }
  return question;
}

Summary summary_of(const RealisationKey& key) {
  Summary summary;
  summary.digest = base::sha256(std::to_string(key.condition) + ' ' + std::to_string(key.realisation));
  summary.margin = static_cast<double>(key.realisation) / 7.0;
  summary.operations.steps = 1000 * key.realisation;
  return summary;
}

class DamagedStore : public ::testing::Test {
 protected:
  DamagedStore() { write_store(stored); }

  void write_store(std::uint64_t realisations) const {
    Store store = Store::create(path_, the_identity);
    for (std::uint64_t condition = 0; condition < 2; ++condition) {
      for (std::uint64_t number = 0; number < realisations; ++number) {
        store.add({condition, number}, summary_of({condition, number}));
      }
    }
    store.close_up();
  }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

  /// Number of undamaged realisations in the file; each of them must be as written. Absent if the file is refused.
  std::optional<std::uint64_t> salvaged() const {
    try {
      const Store damaged = Store::open(path_, Access::read);
      Store mended = Store::in_memory(damaged.identity());
      const std::uint64_t kept = salvage(small_experiment(), damaged, mended);
      mended.for_each([](const RealisationKey& key, const Summary& summary) {
        EXPECT_TRUE(differing_fields(summary, summary_of(key)).empty()) << key.condition << ' ' << key.realisation;
      });
      EXPECT_TRUE(damaged.damage().has_value() || kept == 2 * stored) << "something is missing, and nothing is told";
      return kept;
    } catch (const sqlite::UnusableFile& error) {
      EXPECT_THAT(error.what(), HasSubstr(path_.string()));
    } catch (const std::system_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(path_.string()));
    }
    return std::nullopt;
  }

  support::TemporaryFolder folder_;
  fs::path path_ = folder_ / "a.sqlite";
};

TEST_F(DamagedStore, IsNotToldOfASoundOne) {
  EXPECT_EQ(Store::open(path_, Access::read).damage(), std::nullopt);
  EXPECT_EQ(salvaged(), 2 * stored);
}

TEST_F(DamagedStore, GivesNoWrongRowWhereverABitTurns) {
  const std::string sound = bytes();
  support::SplitMix random(8);
  std::uint64_t kept_in_all = 0;
  std::uint64_t whole = 0;
  constexpr std::uint64_t trials = 60;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    std::string changed = sound;
    const std::size_t place = random.bits() % changed.size();
    changed[place] = static_cast<char>(changed[place] ^ (1 << (random.bits() % 8)));
    put(changed);
    const std::uint64_t kept = salvaged().value_or(0);
    kept_in_all += kept;
    whole += kept == 2 * stored ? 1 : 0;
  }
  EXPECT_LT(whole, trials / 2) << "bits that turn in rows must cost a row";
  EXPECT_GT(kept_in_all, trials * 2 * stored * 8 / 10) << "a bit costs a row or a page, not the store";
}

TEST_F(DamagedStore, KeepsWhatStandsBehindALostPage) {
  std::string changed = bytes();
  const std::size_t pages = changed.size() / 4096;
  changed.replace(4096 * (pages / 2), 4096, std::string(4096, '\0'));
  put(changed);
  const std::uint64_t kept = salvaged().value();
  EXPECT_LT(kept, 2 * stored);
  EXPECT_GT(kept, 2 * stored - 100);
  const Store damaged = Store::open(path_, Access::read);
  EXPECT_THAT(damaged.damage().value(), HasSubstr("is damaged"));
}

TEST_F(DamagedStore, KeepsWhatIsLeftOfACutFile) {
  const std::string sound = bytes();
  std::uint64_t before = 0;
  for (const std::size_t tenth : {0U, 3U, 5U, 7U, 9U}) {
    put(sound.substr(0, sound.size() * tenth / 10));
    EXPECT_EQ(salvaged(), std::nullopt) << "SQLite reads no shorter file than the header tells of";
    count_pages_again(path_);
    const std::uint64_t kept = salvaged().value_or(0);
    EXPECT_GE(kept, before) << tenth;
    EXPECT_LT(kept, 2 * stored) << tenth;
    EXPECT_LE(fs::file_size(path_), sound.size()) << "a file that was cut does not grow";
    before = kept;
  }
  EXPECT_GT(before, 2 * stored * 8 / 10);
}

/// Reads that a report may use: each returns what was written, or throws.
void expect_right_reads(const Store& store, const std::string& what) {
  const auto expect_right = [&what](const RealisationKey& key, const Summary& summary) {
    EXPECT_TRUE(differing_fields(summary, summary_of(key)).empty())
        << what << ": " << key.condition << ' ' << key.realisation;
  };
  for (std::uint64_t condition = 0; condition < 2; ++condition) {
    for (std::uint64_t number = 0; number < stored; ++number) {
      try {
        if (const auto found = store.find({condition, number})) expect_right({condition, number}, *found);
      } catch (const sqlite::UnusableFile&) {
      }
    }
  }
  const auto expect_order = [&what](auto walk) {
    std::vector<RealisationKey> keys;
    try {
      walk([&keys](const RealisationKey& key) { keys.push_back(key); });
    } catch (const sqlite::UnusableFile&) {
    }
    for (std::size_t i = 1; i < keys.size(); ++i) EXPECT_LT(keys[i - 1], keys[i]) << what;
  };
  expect_order([&](auto use) { store.for_each_key(use); });
  expect_order([&](auto use) {
    store.for_each([&](const RealisationKey& key, const Summary& summary) {
      expect_right(key, summary);
      use(key);
    });
  });
}

TEST_F(DamagedStore, GivesNoWrongRowWhicheverPagesWereExchangedOrCopied) {
  write_store(100);
  const std::string sound = bytes();
  constexpr std::size_t page = 4096;
  const std::size_t pages = sound.size() / page;
  ASSERT_GT(pages, 5U);
  for (std::size_t i = 0; i < pages; ++i) {
    for (std::size_t j = 0; j < pages; ++j) {
      if (i == j) continue;
      for (const bool exchanged : {false, true}) {
        if (exchanged && i > j) continue;
        const std::string what = (exchanged ? "exchanged " : "copied ") + std::to_string(i) + ' ' + std::to_string(j);
        std::string changed = sound;
        changed.replace(j * page, page, sound, i * page, page);
        if (exchanged) changed.replace(i * page, page, sound, j * page, page);
        put(changed);
        try {
          const Store store = Store::open(path_, Access::read);
          expect_right_reads(store, what);
          EXPECT_TRUE(store.damage().has_value() || changed == sound) << what;
        } catch (const sqlite::UnusableFile&) {
        }
      }
    }
  }
}

TEST_F(DamagedStore, DoesNotGrowWhereABitOfItsPageCountTurns) {
  const std::string sound = bytes();
  for (std::size_t bit = 0; bit < 32; ++bit) {
    std::string changed = sound;
    changed[28 + bit / 8] = static_cast<char>(changed[28 + bit / 8] ^ (1 << bit % 8));
    put(changed);
    count_pages_again(path_);
    EXPECT_EQ(fs::file_size(path_), sound.size()) << bit;
    const bool counts_more = (static_cast<unsigned char>(sound[28 + bit / 8]) >> bit % 8 & 1) == 0;
    if (counts_more) {
      EXPECT_EQ(salvaged(), 2 * stored) << "no row was touched: " << bit;
    }
  }
}

TEST_F(DamagedStore, OfTheRightLengthKeepsIt) {
  const std::string sound = bytes();
  count_pages_again(path_);
  EXPECT_EQ(bytes(), sound);
  put("no database, but as long as a header would be: " + std::string(100, 'x'));
  count_pages_again(path_);
  EXPECT_EQ(fs::file_size(path_), 147U);
}

TEST_F(DamagedStore, IsRefusedWhereItsIdentityWasChanged) {
  for (const char* change : {"experiment = '{\"a\": 2}'", "code = '2'", "files = '/'", "part = 1, parts = 2",
                             "part = 0, parts = 0", "parts = 0", "results = results + 1", "experiment_sha256 = 'x'"}) {
    const std::string sound = bytes();
    sqlite::Database(path_, Access::write).execute(std::string("UPDATE identity SET ") + change);
    try {
      (void)Store::open(path_, Access::read);
      ADD_FAILURE() << change;
    } catch (const sqlite::UnusableFile& error) {
      EXPECT_THAT(error.what(), HasSubstr("the experiment to which it belongs cannot be read")) << change;
    }
    put(sound);
  }
}

// A kill leaves a file and its log. Each commit in the log has a checksum of SQLite.
TEST_F(DamagedStore, LosesOnlyLaterCommitsWhereABitOfTheLogTurns) {
  fs::remove(path_);
  std::string log;
  {
    Store store = Store::create(path_, the_identity);
    for (std::uint64_t number = 0; number < stored; ++number) {
      store.add({0, number}, summary_of({0, number}));
      if (number % 50 == 49) store.commit();
    }
    std::ifstream file(path_.string() + "-wal", std::ios::binary);
    log = {std::istreambuf_iterator<char>(file), {}};
    fs::copy_file(path_, folder_ / "killed");
  }
  for (int tenth = 1; tenth < 10; ++tenth) {
    fs::copy_file(folder_ / "killed", path_, fs::copy_options::overwrite_existing);
    std::string changed = log;
    char& byte = changed[log.size() * static_cast<std::size_t>(tenth) / 10];
    byte = static_cast<char>(byte ^ 4);
    std::ofstream(path_.string() + "-wal", std::ios::binary) << changed;
    const Store store = Store::open(path_, Access::write);
    EXPECT_EQ(store.damage(), std::nullopt);
    std::uint64_t left = 0;
    store.for_each([&left](const RealisationKey& key, const Summary& summary) {
      EXPECT_EQ(key.realisation, left++);
      EXPECT_TRUE(differing_fields(summary, summary_of(key)).empty());
    });
    EXPECT_EQ(left % 50, 0U);
    EXPECT_LT(left, stored);
  }
}

/// SQLite's usual interface to the system without the shared memory, as on a file system that has none.
class NoSharedMemory {
 public:
  NoSharedMemory() : usual_(sqlite3_vfs_find(nullptr)), poor_(*usual_) {
    poor_.zName = "poor";
    poor_.xOpen = &open;
    sqlite3_vfs_register(&poor_, 1);
  }
  NoSharedMemory(const NoSharedMemory&) = delete;
  NoSharedMemory& operator=(const NoSharedMemory&) = delete;
  ~NoSharedMemory() {
    sqlite3_vfs_unregister(&poor_);
    sqlite3_vfs_register(usual_, 1);
  }

 private:
  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out) {
    const int code = sqlite3_vfs_find("unix")->xOpen(vfs, name, file, flags, out);
    if (code == SQLITE_OK && (flags & SQLITE_OPEN_MAIN_DB) != 0) {
      static sqlite3_io_methods methods;
      methods = *file->pMethods;
      methods.xShmMap = [](sqlite3_file*, int, int, int, void volatile**) { return SQLITE_IOERR_SHMMAP; };
      file->pMethods = &methods;
    }
    return code;
  }

  sqlite3_vfs* usual_;
  sqlite3_vfs poor_;
};

TEST(WithoutSharedMemory, AStoreKeepsItsRowsTheOtherWay) {
  const support::TemporaryFolder folder;
  const NoSharedMemory here;
  Store store = Store::create(folder / "a.sqlite", the_identity);
  EXPECT_EQ(store.journalling(), Journalling::rollback);
  store.add({0, 0}, summary_of({0, 0}));
  store.commit();
  store.add({0, 1}, summary_of({0, 1}));
  const Store onlooker = Store::open(folder / "a.sqlite", Access::read);
  EXPECT_TRUE(onlooker.find({0, 0}).has_value());
  EXPECT_FALSE(onlooker.find({0, 1}).has_value());
  store.close_up();
  EXPECT_TRUE(onlooker.find({0, 1}).has_value());
}

TEST(WithoutSharedMemory, AStoreThatWasKilledElsewhereIsReadWithItsLog) {
  const support::TemporaryFolder folder;
  {
    Store store = Store::create(folder / "a.sqlite", the_identity);
    EXPECT_EQ(store.journalling(), Journalling::write_ahead);
    store.add({0, 0}, summary_of({0, 0}));
    store.commit();
    for (const char* suffix : {"", "-wal"}) {
      fs::copy_file((folder / "a.sqlite").string() + suffix, (folder / "b.sqlite").string() + suffix);
    }
  }
  const NoSharedMemory here;
  const Store store = Store::open(folder / "b.sqlite", Access::write);
  EXPECT_EQ(store.journalling(), Journalling::rollback);
  EXPECT_TRUE(store.find({0, 0}).has_value());
}

}  // namespace
}  // namespace rocking

// Stores that are damaged, by a disk or by editing with SQLite.

#include <filesystem>
#include <memory>
#include <string>

#include <sqlite3.h>

#include "fuzz/attack/attack.hpp"

namespace rocking::fuzz {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t page_size = 4096;

void exchange_pages(Attack& attack, std::string& bytes) {
  const int pages = static_cast<int>(bytes.size() / page_size);
  const auto first = page_size * static_cast<std::size_t>(attack.random.below(pages));
  const auto second = page_size * static_cast<std::size_t>(attack.random.below(pages));
  const std::string page = bytes.substr(first, page_size);
  if (attack.random.below(2) == 0) bytes.replace(first, page_size, bytes.substr(second, page_size));
  bytes.replace(second, page_size, page);
}

void flip_bits(Attack& attack, std::string& bytes, std::size_t within) {
  for (int flips = 1 + attack.random.below(4); flips > 0; --flips) {
    char& byte = bytes[attack.random.bits() % within];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << attack.random.below(8)));
  }
}

void overwrite_part(Attack& attack, std::string& bytes) {
  const std::size_t place = attack.random.bits() % bytes.size();
  const std::size_t length = std::min<std::size_t>(bytes.size() - place, attack.random.bits() % 6000);
  bytes.replace(place, length, std::string(length, attack.one_of("\0\xff")));
}

void damage_bytes(Attack& attack, const fs::path& store) {
  std::string bytes = attack.read(store);
  switch (attack.random.below(6)) {
    case 0:
    case 1: exchange_pages(attack, bytes); break;
    case 2: flip_bits(attack, bytes, bytes.size()); break;
    case 3: flip_bits(attack, bytes, 100); break;  // the header
    case 4: bytes.resize(attack.random.bits() % (bytes.size() + 5000), '\x5a'); break;
    default: overwrite_part(attack, bytes);
  }
  attack.write(store, bytes);
}

constexpr const char* columns[] = {"part", "parts", "experiment", "experiment_sha256",
                                   "code", "draws", "files",      "checksum"};
constexpr const char* odd_values[] = {
    "0", "-1", "NULL", "''", "'x'", "9223372036854775807", "x'00ff'", "3", "1e300", "'<b>bold'", "char(27) || '[31m'"};

/// A statement that changes a store. If the table does not allow it, it fails and the store remains undamaged.
std::string edit(Attack& attack) {
  const std::string row = std::to_string(attack.random.below(40));
  const std::string other = std::to_string(attack.random.below(40));
  switch (attack.random.below(9)) {
    case 0: return std::string("UPDATE identity SET ") + attack.one_of(columns) + " = " + attack.one_of(odd_values);
    case 1: return "UPDATE identity SET part = " + row + ", parts = " + other;
    case 2: return "UPDATE realisations SET condition = 1000, realisation = " + row + " WHERE realisation = " + other;
    case 3: return "DELETE FROM realisations WHERE realisation % 7 = " + row;
    case 4: return "DELETE FROM identity";
    case 5: return "CREATE TRIGGER t AFTER INSERT ON realisations BEGIN DELETE FROM identity; END";
    case 6: return "DROP TABLE realisations";
    case 7: return "CREATE TABLE extra (x); CREATE VIEW v AS SELECT * FROM extra";
    default:  // two rows exchange their places
      return "UPDATE realisations SET realisation = -7 WHERE condition = 0 AND realisation = " + row +
             "; UPDATE realisations SET realisation = " + row + " WHERE condition = 0 AND realisation = " + other +
             "; UPDATE realisations SET realisation = " + other + " WHERE condition = 0 AND realisation = -7";
  }
}

void damage_rows(Attack& attack, const fs::path& store) {
  sqlite3* opened = nullptr;
  const int opening = sqlite3_open((attack.folder() / store).c_str(), &opened);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  if (opening != SQLITE_OK) return;
  sqlite3_exec(database.get(), edit(attack).c_str(), nullptr, nullptr, nullptr);
}

}  // namespace

void attack_stores(Attack& attack) {
  attack.copy_sound_run("out");
  const fs::path store = "out/realisations.sqlite";
  if (attack.random.below(3) == 0) {
    damage_rows(attack, store);
  } else {
    damage_bytes(attack, store);
  }
  attack.run({"status", "out"}, {0, 65});
  if (attack.random.below(3) == 0) attack.run({"verify", "out", "--sample", "3"}, {0, 1, 65});
  for (const char* name : {"out/report.json", "out/report.html"}) fs::remove(attack.folder() / name);
  const Ending resumed = attack.run({"resume", "out", "-q", "-j", "2"}, {0, 65});
  if (resumed.exit_code == 0 || attack.exists("out/report.json")) {
    if (lasting_text(attack.read("out/report.json")) != attack.sound().report)
      attack.find("a wrong report after `resume`");
  }
  if (attack.random.below(3) == 0) {
    attack.copy_sound_run("shard");
    const Ending merged = attack.run({"merge", "whole", "out", "shard"}, {0, 65});
    if (merged.exit_code == 0 && lasting_text(attack.read("whole/report.json")) != attack.sound().report) {
      attack.find("a wrong report after `merge`");
    }
  }
}

}  // namespace rocking::fuzz

#include "rocking/store/store_identity.hpp"

#include <string>

#include "rocking/store/store_row.hpp"

namespace rocking {
namespace {

using sqlite::Database;
using sqlite::Statement;
using sqlite::UnusableFile;

constexpr std::int64_t application_id = 0x726f636b;  // "rock": identifies the database to `file` and other programs

// A trigger could change rows unnoticed; a view or a virtual table could replace a table.
void expect_two_tables(const Database& database) {
  Statement foreign = database.prepare(
      "SELECT type, name FROM sqlite_master WHERE NOT (type = 'table' AND rootpage > 0 AND name IN ('identity', "
      "'realisations'))");
  if (foreign.step()) {
    throw UnusableFile(database.path() + ": is damaged, or was changed by another program: it holds the " +
                       foreign.text(0) + " \"" + foreign.text(1) + "\", which is not part of a store; remove it");
  }
  if (sqlite::number_in(database, "SELECT count(*) FROM sqlite_master") != 2) {
    throw UnusableFile(database.path() + ": is damaged: it lacks a table of a store of realisations");
  }
}

// The column `code` exists in every layout, so that the message can name the program.
[[noreturn]] void refuse(const Database& database, std::int64_t layout) {
  Statement writer = database.prepare("SELECT code FROM identity");
  const std::string code = writer.step() ? writer.text(0) : "unknown";
  throw UnusableFile(database.path() + ": was written by rocking " + code + " in layout " + std::to_string(layout) +
                     ", but this program reads layout " + std::to_string(current_layout) +
                     "; use the program that wrote it, or run the experiment again. Its numbers: sqlite3 " +
                     database.path() + " 'SELECT * FROM realisations'");
}

}  // namespace

void lay_out(Database& database) {
  database.execute("PRAGMA application_id = " + std::to_string(application_id));
  database.execute("PRAGMA user_version = " + std::to_string(current_layout));
  database.execute(identity_table());
  database.execute(row_table());
}

void expect_current_layout(const Database& database) {
  if (sqlite::number_in(database, "PRAGMA application_id") != application_id) {
    throw UnusableFile(database.path() + ": is not a store of realisations");
  }
  const std::int64_t number = sqlite::number_in(database, "PRAGMA user_version");
  if (number < 0) throw UnusableFile(database.path() + ": is damaged: its layout number is invalid");
  if (number != current_layout) refuse(database, number);
  expect_two_tables(database);
}

}  // namespace rocking

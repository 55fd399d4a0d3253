#include "rocking/store/store_identity.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/random/draws.hpp"

namespace rocking {
namespace {

using sqlite::Database;
using sqlite::Statement;

/// The row of the table, unchecked.
struct Written {
  Identity identity;
  std::string experiment_sha256;
  std::string draws;
  std::string checksum;
};

void add_text(base::Sha256Builder& sum, std::string_view text) {
  sum.add(std::uint64_t{text.size()});
  sum.add(text);
}

std::string checksum_of(const Written& written) {
  base::Sha256Builder sum;
  for (const auto& text : {written.identity.experiment, written.experiment_sha256, written.identity.code, written.draws,
                           written.identity.files}) {
    add_text(sum, text);
  }
  sum.add(written.identity.results);
  const auto& shard = written.identity.shard;
  sum.add(std::uint64_t{shard ? 1U : 0U});
  if (shard) {
    sum.add(shard->part);
    sum.add(shard->parts);
  }
  return base::to_hex(sum.finish());
}

[[noreturn]] void fail(const Database& database) {
  throw sqlite::UnusableFile(database.path() +
                             ": is damaged: the experiment to which it belongs cannot be read, so nothing in it can be "
                             "used; run the experiment again, with --overwrite");
}

// Absent for the whole experiment. Numbers that no shard can have are damage, whatever the checksum is.
std::optional<Shard> read_shard(const Database& database, const Statement& row, int part, int parts) {
  if (row.is_null(part) && row.is_null(parts)) return std::nullopt;
  const std::int64_t number = row.integer(part);
  const std::int64_t of = row.integer(parts);
  if (row.is_null(part) || row.is_null(parts) || number < 1 || of < number) fail(database);
  return Shard{.part = static_cast<std::uint64_t>(number), .parts = static_cast<std::uint64_t>(of)};
}

Written read_row_of_identity(const Database& database) {
  Statement row = database.prepare(
      "SELECT experiment, experiment_sha256, code, draws, files, part, parts, checksum, results FROM identity");
  if (!row.step()) fail(database);
  Written written{.identity = {.experiment = row.text(0),
                               .code = row.text(2),
                               .files = row.text(4),
                               .shard = read_shard(database, row, 5, 6),
                               .results = static_cast<std::uint64_t>(row.integer(8))},
                  .experiment_sha256 = row.text(1),
                  .draws = row.text(3),
                  .checksum = row.text(7)};
  if (row.step()) fail(database);  // it is unknown which of several rows is valid
  return written;
}

}  // namespace

std::string identity_table() {
  return "CREATE TABLE identity (experiment TEXT NOT NULL, experiment_sha256 TEXT NOT NULL, code TEXT NOT NULL, "
         "results INTEGER NOT NULL, draws TEXT NOT NULL, files TEXT NOT NULL, part INTEGER, parts INTEGER, checksum "
         "TEXT NOT NULL) STRICT";
}

void write_identity(Database& database, const Identity& identity) {
  const Written written{.identity = identity,
                        .experiment_sha256 = base::to_hex(base::sha256(identity.experiment)),
                        .draws = std::string(random::draws_format),
                        .checksum = {}};
  Statement insert = database.prepare(
      "INSERT INTO identity (experiment, experiment_sha256, code, results, draws, files, part, parts, checksum) VALUES "
      "(?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(0, identity.experiment);
  insert.bind(1, written.experiment_sha256);
  insert.bind(2, identity.code);
  insert.bind(3, static_cast<std::int64_t>(identity.results));
  insert.bind(4, written.draws);
  insert.bind(5, identity.files);
  if (identity.shard) {
    insert.bind(6, static_cast<std::int64_t>(identity.shard->part));
    insert.bind(7, static_cast<std::int64_t>(identity.shard->parts));
  }
  insert.bind(8, checksum_of(written));
  insert.run();
}

Identity read_identity(const Database& database) {
  Written written = read_row_of_identity(database);
  const bool sound = written.checksum == checksum_of(written) &&
                     written.experiment_sha256 == base::to_hex(base::sha256(written.identity.experiment));
  if (!sound) fail(database);
  if (written.draws != random::draws_format) {
    throw sqlite::UnusableFile(database.path() + ": its random numbers have format " + written.draws +
                               ", those of this program are " + std::string(random::draws_format));
  }
  return std::move(written.identity);
}

}  // namespace rocking

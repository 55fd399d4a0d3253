#include "rocking/experiment/store_identity.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::experiment {
namespace {

using sqlite::Database;
using sqlite::Statement;

std::string checksum_of(const Identity& identity, std::string_view draws) {
  base::Sha256Builder sum;
  for (const std::string_view text : {std::string_view(identity.experiment), std::string_view(identity.code), draws,
                                      std::string_view(identity.files)}) {
    sum.add(std::uint64_t{text.size()});
    sum.add(text);
  }
  sum.add(identity.shard ? identity.shard->part : 0);
  sum.add(identity.shard ? identity.shard->parts : 0);
  return base::to_hex(sum.finish());
}

}  // namespace

std::string identity_table() {
  return "CREATE TABLE identity (experiment TEXT NOT NULL, experiment_sha256 TEXT NOT NULL, code TEXT NOT NULL, "
         "draws TEXT NOT NULL, files TEXT NOT NULL, part INTEGER, parts INTEGER, checksum TEXT NOT NULL) STRICT";
}

void write_identity(Database& database, const Identity& identity) {
  Statement insert = database.prepare("INSERT INTO identity VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(0, identity.experiment);
  insert.bind(1, base::to_hex(base::sha256(identity.experiment)));
  insert.bind(2, identity.code);
  insert.bind(3, random::draws_format);
  insert.bind(4, identity.files);
  if (identity.shard) {
    insert.bind(5, static_cast<std::int64_t>(identity.shard->part));
    insert.bind(6, static_cast<std::int64_t>(identity.shard->parts));
  }
  insert.bind(7, checksum_of(identity, random::draws_format));
  insert.run();
}

Identity read_identity(const Database& database) {
  Statement row = database.prepare("SELECT experiment, code, draws, files, part, parts, checksum FROM identity");
  if (!row.step()) throw sqlite::UnusableFile(database.path() + ": does not say to what experiment it belongs");
  Identity identity{.experiment = row.text(0), .code = row.text(1), .files = row.text(3), .shard = std::nullopt};
  if (!row.is_null(4)) {
    identity.shard =
        Shard{.part = static_cast<std::uint64_t>(row.integer(4)), .parts = static_cast<std::uint64_t>(row.integer(5))};
  }
  const std::string draws = row.text(2);
  if (row.text(6) != checksum_of(identity, draws)) {
    throw sqlite::UnusableFile(database.path() +
                               ": is damaged: it does not say soundly to what experiment it belongs, so nothing in it "
                               "can be used; run the experiment anew");
  }
  if (draws != random::draws_format) {
    throw sqlite::UnusableFile(database.path() + ": its draws are " + draws + ", those of this program are " +
                               std::string(random::draws_format));
  }
  return identity;
}

}  // namespace rocking::experiment

#include "rocking/store/store_row.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rocking {
namespace {

using sqlite::Statement;

std::int64_t to_signed(std::uint64_t number) { return std::bit_cast<std::int64_t>(number); }

// Each kind of field has one overload in each of three families: how it is declared, bound and read. A value with a
// name (a response mode, an enumerator) is stored by its name.

const char* type_of(bool) { return "INTEGER NOT NULL"; }
const char* type_of(std::uint64_t) { return "INTEGER NOT NULL"; }
const char* type_of(double) { return "REAL NOT NULL"; }
const char* type_of(const base::Sha256&) { return "BLOB NOT NULL"; }
const char* type_of(const std::optional<std::int64_t>&) { return "INTEGER"; }
const char* type_of(const std::optional<double>&) { return "REAL"; }
template <class Named>
const char* type_of(const std::optional<Named>&) {
  return "TEXT";
}
template <class Named>
const char* type_of(const Named&) {
  return "TEXT NOT NULL";
}

class Binder {
 public:
  explicit Binder(Statement& statement) : statement_(&statement) {}

  void put(bool flag) { statement_->bind(place_++, std::int64_t{flag}); }
  void put(std::int64_t number) { statement_->bind(place_++, number); }
  void put(std::uint64_t number) { statement_->bind(place_++, to_signed(number)); }
  void put(double number) { statement_->bind(place_++, number); }
  void put(const base::Sha256& digest) { statement_->bind(place_++, std::span<const std::byte>(digest)); }
  template <class Value>
  void put(const std::optional<Value>& value) {
    if (value) return put(*value);
    statement_->bind_null(place_++);
  }
  template <class Named>
  void put(const Named& named) {
    statement_->bind(place_++, std::string_view(to_string(named)));
  }

 private:
  Statement* statement_;
  int place_ = 0;
};

std::optional<dynamics::Termination> termination_named(std::string_view name) {
  const auto* const found = std::ranges::find(dynamics::termination_names, name);
  if (found == dynamics::termination_names.end()) return std::nullopt;
  return dynamics::terminations[static_cast<std::size_t>(found - dynamics::termination_names.begin())];
}

std::optional<dynamics::Side> side_named(std::string_view name) {
  const auto* const found = std::ranges::find(dynamics::side_names, name);
  if (found == dynamics::side_names.end()) return std::nullopt;
  return static_cast<dynamics::Side>(found - dynamics::side_names.begin());
}

/// Reads the columns of a row, one after the other. A value that no program writes makes the row unsound, although the
/// field that it becomes may have the right checksum.
class Reader {
 public:
  explicit Reader(const Statement& statement) : statement_(&statement) {}

  /// Whether every value so far is one that a program writes.
  [[nodiscard]] bool is_sound() const { return is_sound_; }

  void get(bool& flag) {
    const std::int64_t number = statement_->integer(place_++);
    is_sound_ = is_sound_ && (number == 0 || number == 1);
    flag = number != 0;
  }
  void get(std::int64_t& number) { number = statement_->integer(place_++); }
  void get(std::uint64_t& number) { number = std::bit_cast<std::uint64_t>(statement_->integer(place_++)); }
  void get(double& number) { number = statement_->real(place_++); }
  void get(base::Sha256& digest) {
    const auto bytes = statement_->bytes(place_++);
    is_sound_ = is_sound_ && bytes.size() == digest.size();
    std::copy_n(bytes.begin(), std::min(bytes.size(), digest.size()), digest.begin());
  }
  void get(section::ResponseMode& mode) { take(section::response_mode_named(statement_->text(place_++)), mode); }
  void get(section::ModeCounts& counts) { take(section::mode_counts_named(statement_->text(place_++)), counts); }
  void get(section::Reason& reason) { take(section::reason_named(statement_->text(place_++)), reason); }
  void get(dynamics::Side& side) { take(side_named(statement_->text(place_++)), side); }
  void get(dynamics::Termination& termination) { take(termination_named(statement_->text(place_++)), termination); }
  template <class Value>
  void get(std::optional<Value>& value) {
    if (statement_->is_null(place_)) {
      ++place_;
    } else {
      get(value.emplace());
    }
  }

 private:
  /// Of a name: `known` is absent if there is no such name.
  template <class Named>
  void take(const std::optional<Named>& known, Named& named) {
    is_sound_ = is_sound_ && known.has_value();
    if (known) named = *known;
  }

  const Statement* statement_;
  int place_ = 0;
  bool is_sound_ = true;
};

/// Collects the fields of a row and hashes them at once, because hashing many small pieces takes several times as long.
/// Numbers are hashed as their bytes in little-endian order.
class Summer {
 public:
  void add(bool flag) { add(std::uint64_t{flag}); }
  void add(std::int64_t number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::uint64_t number) {
    std::array<char, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(number >> 8 * i & 0xff);
    text_.append(bytes.data(), bytes.size());
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const base::Sha256& digest) {
    for (const std::byte byte : digest) text_ += static_cast<char>(byte);
  }
  template <class Value>
  void add(const std::optional<Value>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class Named>
  void add(const Named& named) {
    const auto name = to_string(named);
    add(std::uint64_t{name.size()});
    text_ += name;
  }

  /// The first 64 bits of the digest.
  [[nodiscard]] std::uint64_t finish() const {
    const base::Sha256 digest = base::sha256(text_);
    std::uint64_t first = 0;
    for (std::size_t i = 0; i < 8; ++i) first = first << 8 | std::to_integer<std::uint64_t>(digest[i]);
    return first;
  }

 private:
  std::string text_;
};

}  // namespace

std::string row_table() {
  std::string table = "CREATE TABLE realisations (condition INTEGER NOT NULL, realisation INTEGER NOT NULL";
  const Summary any;
  for_each_field(any,
                 [&table](const std::string& name, const auto& field) { table += ", " + name + " " + type_of(field); });
  return table + ", checksum INTEGER NOT NULL, PRIMARY KEY (condition, realisation)) STRICT, WITHOUT ROWID";
}

const std::string& row_columns() {
  static const std::string columns = [] {
    std::string names = "condition, realisation";
    const Summary any;
    for_each_field(any, [&names](const std::string& name, const auto&) { names += ", " + name; });
    return names + ", checksum";
  }();
  return columns;
}

std::string row_placeholders() {
  std::string places = "?";
  for (const char letter : row_columns()) {
    if (letter == ',') places += ", ?";
  }
  return places;
}

std::uint64_t RowFormat::checksum_of(const RealisationKey& key, const Summary& summary) const {
  Summer sum;
  sum.add(experiment_);
  sum.add(key.condition);
  sum.add(key.realisation);
  for_each_field(summary, [&sum](const auto&, const auto& field) { sum.add(field); });
  return sum.finish();
}

void RowFormat::bind(Statement& statement, const RealisationKey& key, const Summary& summary) const {
  Binder binder(statement);
  binder.put(key.condition);
  binder.put(key.realisation);
  for_each_field(summary, [&binder](const auto&, const auto& field) { binder.put(field); });
  binder.put(checksum_of(key, summary));
}

std::optional<Row> RowFormat::read(const Statement& statement) const {
  Row row;
  Reader reader(statement);
  reader.get(row.key.condition);
  reader.get(row.key.realisation);
  for_each_field(row.summary, [&reader](const auto&, auto& field) { reader.get(field); });
  std::uint64_t checksum = 0;
  reader.get(checksum);
  if (!reader.is_sound() || checksum != checksum_of(row.key, row.summary)) return std::nullopt;
  return row;
}

}  // namespace rocking

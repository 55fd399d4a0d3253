#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/number_rule.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Reads one JSON object, key by key. Each call checks a key, remembers that it is known, and writes the value, or its
/// default, to the canonical object in the order of the calls. Keys must outlive it. Problems are collected, never
/// thrown; a call that met
/// one returns a value that is safe to go on with.
class ObjectReader {
 public:
  /// `source` may be of any type: one that is not an object is a problem.
  ObjectReader(const Json& source, std::string place, Problems& problems);
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  [[nodiscard]] bool has(std::string_view key);
  [[nodiscard]] double number(std::string_view key, const NumberRule& rule);
  [[nodiscard]] std::int64_t integer(std::string_view key, const IntegerRule& rule);
  [[nodiscard]] std::string text(std::string_view key, std::string_view standard);
  /// Index into `names` of the one that stands there.
  [[nodiscard]] std::size_t choice(std::string_view key, std::span<const std::string_view> names, std::size_t standard);

  /// The value as it stands, for what has no simple type; absent where the key is. The caller writes it.
  [[nodiscard]] const Json* value(std::string_view key);
  void write(std::string_view key, Json canonical);
  /// From now on only these keys are written.
  void write_only(std::span<const std::string> keys) { written_ = keys; }

  /// Calls `read(ObjectReader&)` on the object at `key`, on an empty one where it is absent.
  template <class Read>
  void object(std::string_view key, Read read) {
    const Json* source = value(key);
    ObjectReader inner(source == nullptr ? no_keys() : *source, place_of(key), *problems_);
    inner.writes_ = is_written(key);
    read(inner);
    write(key, inner.finish());
  }

  /// From now on no key is unknown: what they mean depends on one that was refused.
  void ignore_others() { source_ = &no_keys(); }

  void reject(std::string_view key, std::string reason, std::string remedy);
  /// Rejects the object itself.
  void reject(std::string reason, std::string remedy);
  [[nodiscard]] std::string place_of(std::string_view key) const { return child_pointer(place_, key); }
  [[nodiscard]] Problems& problems() { return *problems_; }

  /// Reports the keys that nobody asked for; returns the canonical object.
  [[nodiscard]] Json finish();

 private:
  void report_missing(std::string_view key, std::string_view example);

  [[nodiscard]] bool is_written(std::string_view key) const;
  [[nodiscard]] static const Json& no_keys();

  const Json* source_;
  std::string place_;
  Problems ignored_;  ///< of an object that is none: one problem is enough
  Problems* problems_;
  std::vector<std::string_view> known_;
  bool writes_ = true;
  std::span<const std::string> written_ = {};  ///< empty: all
  Json canonical_ = Json::object();
};

/// Checks that `value` is a number that the rule allows, or reports why not.
[[nodiscard]] std::optional<double> checked_number(const Json& value, const std::string& place, const NumberRule& rule,
                                                   Problems& problems);

}  // namespace rocking

#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/rule.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/json_writer.hpp"

namespace rocking {

/// Such as `at least 1 and at most 12`; empty without bounds.
[[nodiscard]] std::string bounds_in_words(const Rule& rule);

/// Where a value is read from, and what becomes of its faults.
struct ReadingPlace {
  std::string pointer;  ///< JSON pointer
  Rule rule = {};       ///< of the numbers and texts there
  std::vector<base::Problem>* problems;
  bool is_fit_checked = true;      ///< whether what contradicts the rest of the file is a fault
  std::string_view sentence = {};  ///< what the value means
  /// Where the value is put as the canonical text has it, if that is not json(value); discarded: nothing is written.
  Json* canonical = nullptr;

  void reject(const Json& value, std::string reason, std::string remedy = "") const;
  /// Of a value that contradicts the rest of the file.
  void reject_changed(const Json& value) const;
  [[nodiscard]] ReadingPlace at(std::string_view key) const;
  /// The same for a field, with its rule.
  [[nodiscard]] ReadingPlace at(std::string_view key, const Rule& of_field) const;
};

/// A row of a table of keys.
struct KeyRow {
  std::string key;  ///< as `conditions[i].modes`
  std::string_view sentence;
  // Of values that people write.
  std::string allowed = {};
  std::string standard = {};
};

/// A C++ type as it stands in documents: how it is written, read and described. Objects are passed without their type,
/// so that a new type costs few instantiations.
class ValueType {
 public:
  ValueType() = default;
  ValueType(const ValueType&) = delete;
  ValueType& operator=(const ValueType&) = delete;
  virtual ~ValueType() = default;

  [[nodiscard]] virtual Json json(const void* value) const = 0;
  /// Writes the value as the next member of an object, with this key. Objects and lists are written piece by piece, so
  /// that a long document never stands in memory as a whole.
  virtual void write(const void* value, std::string_view key, JsonWriter& out) const { out.member(key, json(value)); }
  /// The same as the next value of a list.
  virtual void write_element(const void* value, JsonWriter& out) const { out.element(json(value)); }
  /// Sets the value, or reports every fault and leaves the value valid.
  virtual void read(const Json& json, const ReadingPlace& place, void* value) const = 0;
  /// Reports every fault of a value that was set in C++: what its rule does not allow, a number that is not finite.
  virtual void check(const void* value, const ReadingPlace& place) const;
  /// JSON Schema, draft 7.
  [[nodiscard]] virtual Json schema(const Rule& rule) const = 0;
  /// Appends a row for each key within a value at `prefix`; none for a type without keys.
  virtual void describe(const std::string& prefix, std::vector<KeyRow>& rows) const;

  // Of values that people write (written_types.hpp).

  /// For a table of keys: what may stand there, and this value as the default; empty: there is none.
  struct Shown {
    std::string allowed;
    std::string standard;
  };
  [[nodiscard]] virtual Shown shown(const void*) const { return {}; }
  /// JSON text of a value that would do.
  [[nodiscard]] virtual std::string example() const { return {}; }
  /// Reports that a file has no such value, and sets one that is safe to go on with.
  virtual void report_missing(const ReadingPlace& place, void* value) const;
};

/// The schema of a value that may be null instead.
[[nodiscard]] Json or_null(Json schema);

/// The one object of a type without members.
template <class Type>
[[nodiscard]] const ValueType& the_only() {
  static const Type type;
  return type;
}

/// `TypeOf<T>::get()` is the ValueType of T.
template <class T>
struct TypeOf;

template <class T>
[[nodiscard]] const ValueType& type_of() {
  return TypeOf<T>::get();
}

template <class T>
concept SimpleValue = std::same_as<T, double> || std::same_as<T, std::uint64_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, int> || std::same_as<T, unsigned> || std::same_as<T, bool> || std::same_as<T, std::string> ||
    std::same_as<T, Json>;

template <SimpleValue T>
[[nodiscard]] const ValueType& simple_type();

template <SimpleValue T>
struct TypeOf<T> {
  static const ValueType& get() { return simple_type<T>(); }
};

}  // namespace rocking

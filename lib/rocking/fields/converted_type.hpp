#pragma once

#include <cstddef>
#include <string>

#include "rocking/fields/struct_type.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/fields/written_types.hpp"

namespace rocking {

/// A T that stands in documents as a `Written` does. `to_written` gives it; `from_written` sets a T from one that was
/// read without a fault, or reports what in it contradicts itself.
template <class T, class Written, Written (*to_written)(const T&),
          void (*from_written)(const Written&, const ReadingPlace&, T&)>
class ConvertedType : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const Written written = to_written(*static_cast<const T*>(value));
    return type_of<Written>().json(&written);
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    Written written{};
    const std::size_t before = place.problems->size();
    type_of<Written>().read(json, place, &written);
    if (place.problems->size() == before) from_written(written, place, *static_cast<T*>(value));
  }
  void check(const void* value, const ReadingPlace& place) const override {
    const Written written = to_written(*static_cast<const T*>(value));
    type_of<Written>().check(&written, place);
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<Written>().schema(rule); }
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
    type_of<Written>().describe(prefix, rows);
  }
};

/// Enumerators that stand in documents by their names. `names`: a std::array of them, in the order of the enumerators.
template <class Enumeration, const auto& names>
class NamedType final : public NamesType<Enumeration> {
 public:
  NamedType() : NamesType<Enumeration>(names) {}
};

/// The base of a TypeOf<T> whose type has no members: `struct TypeOf<Rating> : OnlyType<NamedType<Rating, rating_names>> {};`.
template <class Type>
struct OnlyType {
  static const ValueType& get() { return the_only<Type>(); }
};

}  // namespace rocking

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "rocking/fields/value_type.hpp"
#include "rocking/fields/written_types.hpp"

namespace rocking {

/// A key of an object, and what it means in one sentence.
struct Key {
  std::string_view name;
  std::string_view sentence;
};

/// What becomes of a key that a file does not have.
enum class Absent : std::uint8_t {
  error,     ///< the key is required
  standard,  ///< the member keeps its value, which the canonical text states
  omitted,   ///< the member keeps its value, and the canonical text has no such key either
};

/// One of several keys that give the same value.
struct Alternative {
  Key key;
  const ValueType* type;
};

/// Goes through the keys of an object that people write. A StructType is a fixed list; here which keys stand, and their
/// defaults, may follow from the values of others, so that the list is a function `keys_of(FieldVisitor&, T&)`. What
/// happens at a key is up to the class: it is read from a file (FieldReader), the value that a caller in C++ has given is
/// checked (FieldChecker), or the key is described (FieldDescriber). How the value itself is read, checked and described
/// is up to its ValueType, as in results.
class FieldVisitor {
 public:
  using Part = std::function<void(FieldVisitor&)>;

  FieldVisitor(const FieldVisitor&) = delete;
  FieldVisitor& operator=(const FieldVisitor&) = delete;
  virtual ~FieldVisitor() = default;

  virtual void field(const Key& key, const ValueType& type, void* value, Absent absent) = 0;
  /// The value that one of the keys gives; `chosen`: which one. Returns whether one was read.
  virtual bool one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) = 0;
  virtual void object(const Key& key, Absent absent, const Part& part) = 0;
  /// A value, or an object with more about it.
  virtual void value_or_object(const Key& key, bool is_object, const Part& value, const Part& object) = 0;
  /// A word that decides which keys stand beside it: those of `part(visitor, kind)`.
  virtual void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
                     const std::function<void(FieldVisitor&, std::size_t)>& part) = 0;

  /// Whether all forms of a value are gone through, and there is no value.
  [[nodiscard]] virtual bool describes() const { return false; }
  /// Whether to go on with a key that may be left out; `is_given`: whether the value has it.
  virtual bool stands(std::string_view key, bool is_given) = 0;
  /// How a default is written that follows from the values at these places of a file: not at all where the sweep
  /// changes one of them, for what is written would override it.
  [[nodiscard]] virtual Absent follows_from(std::span<const std::string_view>) const { return Absent::omitted; }
  /// Refuses a key beside another one, which says the same.
  virtual void exclude(std::string_view, std::string_view /*other*/, Refusal) {}
  /// Exactly one of the keys must stand; what is missing or too much is told elsewhere.
  virtual void require_one_of(std::initializer_list<std::string_view>) {}

  // Of files alone.

  /// Whether the values come from a file, so that defaults which follow from others are set.
  [[nodiscard]] bool is_reading() const { return is_reading_; }
  /// What the file has at this key; null: nothing.
  [[nodiscard]] virtual const Json* found(std::string_view) { return nullptr; }
  /// Writes into the canonical text.
  virtual void write(std::string_view, Json) {}
  /// Refuses what a file has at this key; of an empty key, the object itself.
  virtual void reject(std::string_view, Refusal) {}
  /// From now on no key is unknown: what they mean depends on one that was refused.
  virtual void ignore_others() {}
  [[nodiscard]] std::size_t problem_count() const { return problems_ == nullptr ? 0 : problems_->size(); }
  [[nodiscard]] std::vector<base::Problem>& problems() { return *problems_; }

  /// Refuses a key that means nothing here.
  void refuse(std::string_view key, std::string_view reason, std::string_view remedy) {
    if (found(key) != nullptr) reject(key, {std::string(reason), std::string(remedy)});
  }
  [[nodiscard]] Absent follows_from(std::initializer_list<std::string_view> places) const {
    return follows_from(std::span(places.begin(), places.size()));
  }

  /// A member that is read as `rule` and its C++ type say: `written_type(&value, rule)`.
  template <class T, class TypeOrRule>
  void value(const Key& key, T& value, const TypeOrRule& rule, Absent absent) {
    if constexpr (std::is_base_of_v<ValueType, TypeOrRule>) {
      field(key, rule, &value, absent);
    } else {
      field(key, written_type(&value, rule), &value, absent);
    }
  }
  /// An enumerator; `names` are in their order.
  template <class Enumeration>
  void choice(const Key& key, Enumeration& value, std::span<const std::string_view> names, Absent absent) {
    field(key, NamesType<Enumeration>(names), &value, absent);
  }
  /// What may be left out altogether: `visit(*value)`.
  template <class T, class Visit>
  void optional(std::string_view key, std::optional<T>& value, const Visit& visit) {
    if (!stands(key, value.has_value())) return value.reset();
    if (!value) value.emplace();
    visit(*value);
  }

 protected:
  FieldVisitor(std::vector<base::Problem>* problems, bool is_reading) : problems_(problems), is_reading_(is_reading) {}

  std::vector<base::Problem>* problems_;  ///< null: nothing can be wrong

 private:
  bool is_reading_;
};

}  // namespace rocking

#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/fields/value_type.hpp"

namespace rocking {

/// How a field without a value, or an empty list, stands in a document. A list is never null.
enum class WithoutValue : std::uint8_t { null, omitted };

/// A member whose fields stand among those of its owner.
struct InlinedMember {
  void* (*find)(void* owner);  ///< null: an optional member without a value
  void* (*make)(void* owner);  ///< the same; first gives an optional member a value
  bool is_optional = false;
};

/// How the value of a flag is written on a command line.
enum class FlagKind : std::uint8_t {
  value,     ///< `--flag X`; a list has several words, or several flags
  words,     ///< the same of a list whose words may be parted by commas too, and are not checked
  new_file,  ///< a path that must not exist
  commas,    ///< `--flag X,X`
  repeated,  ///< a list: `--flag X --flag X`
  duration,  ///< `--flag 10min` [s]
  on,        ///< `--flag` alone: true
  off,       ///< `--no-flag` alone: false; what the field says is then not done
};

/// How a field of a question is asked on a command line.
struct Flag {
  std::string_view names;  ///< `--periods`, or several with commas; empty: the field is for callers of the library
  std::string_view letter = {};  ///< stands for the value: `N`
  FlagKind kind = FlagKind::value;
  bool is_required = false;
  std::string_view excludes = {};  ///< another flag
  std::string_view needs = {};     ///< another flag
  int count = 0;                   ///< of the words of a list; 0: any
  bool is_of_program = false;      ///< for command lines alone: no keyword in Python
};

/// A field of a struct: its key, what it means in one sentence, and how to reach it.
struct Field {
  std::string_view key;
  std::string_view sentence;
  Rule rule = {};
  WithoutValue without_value = WithoutValue::null;
  const ValueType* type = nullptr;
  void* (*member)(void* owner) = nullptr;          ///< null: derived
  bool (*has_value)(const void* owner) = nullptr;  ///< of an optional member, or a list
  Json (*derive)(const void* owner) = nullptr;     ///< from other members; written, and not read
  bool must_fit = false;                           ///< derived, and an error in a document that has another value
  std::vector<InlinedMember> inlined_by = {};      ///< on the way to the owner, from the outermost on
  Flag flag = {};                                  ///< of a question

  /// Whether a document may lack it.
  [[nodiscard]] bool may_be_absent() const;
  /// Whether the document of this value must have it.
  [[nodiscard]] bool is_needed(const void* outermost) const;
  [[nodiscard]] bool is_omitted(const void* outermost) const;
  [[nodiscard]] Json json(const void* outermost) const;
  void write(const void* outermost, JsonWriter& out) const;
  /// Gives the optional members on the way a value.
  void make_owner(void* outermost) const;
  /// Reports a derived value that does not fit what was read.
  void check_fit(const Json& json, const ReadingPlace& place, const void* outermost) const;
  /// Precondition: make_owner was called.
  void read(const Json& json, const ReadingPlace& place, void* outermost) const;
  void check(const ReadingPlace& place, const void* outermost) const;
};

/// The name of a field of a question in Python, and for answer(): that of its first flag, `max_time` of `--max-time`; the
/// key where a command line has no flag for it. Empty: it has none there.
[[nodiscard]] std::string keyword_of(const Field& field);

/// What a flag, or keyword, does.
[[nodiscard]] std::string sentence_of_flag(const Field& field);

/// The same problems of a question; the place of a field is its `name`, not its key.
[[nodiscard]] base::InputError with_names(const base::InputError& error, const std::vector<Field>& fields,
                                          std::string (*name)(const Field& field));

/// The name of a struct and the list of its fields, in the order in which they are written.
class StructType final : public ValueType {
 public:
  /// `name` stands in schemas as the title of the object, and names its class in Python.
  template <std::same_as<Field>... Fields>
  explicit StructType(std::string_view name, const Fields&... fields) : StructType(name, {fields...}) {}

  [[nodiscard]] Json json(const void* value) const override;
  void write(const void* value, std::string_view key, JsonWriter& out) const override;
  void write_element(const void* value, JsonWriter& out) const override;
  /// Writes the fields into the innermost object.
  void write_members(const void* value, JsonWriter& out) const;
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule& rule) const override;
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override;
  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }
  [[nodiscard]] std::string_view name() const { return name_; }

 private:
  StructType(std::string_view name, std::initializer_list<Field> fields);
  void reject_unknown(const std::string& key, const Json& value, const ReadingPlace& place) const;

  std::string_view name_;
  std::vector<Field> fields_;
};

/// A struct has a list of fields where `fields_of(const T*)` returns it, a function beside the struct or in a source that
/// includes its header.
template <class T>
concept HasFields = requires(const T* type) {
  { fields_of(type) } -> std::same_as<const StructType&>;
};

template <HasFields T>
struct TypeOf<T> {
  static const ValueType& get() { return fields_of(static_cast<const T*>(nullptr)); }
};

namespace detail {

template <class T>
struct OwnerOf;
template <class T, class Value>
struct OwnerOf<Value T::*> {
  using Type = T;
};
template <class F>
requires requires { &F::operator(); }
struct OwnerOf<F> : OwnerOf<decltype(&F::operator())> {};
template <class F, class Value, class T>
struct OwnerOf<Value (F::*)(const T&) const> {
  using Type = T;
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
struct Contained : std::type_identity<T> {};
template <class T>
struct Contained<std::optional<T>> : std::type_identity<T> {};
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

template <class Owner, auto first, auto... rest>
decltype(auto) reach(Owner& owner) {
  if constexpr (sizeof...(rest) == 0) {
    return (owner.*first);
  } else {
    auto& inner = owner.*first;
    return reach<std::remove_reference_t<decltype(inner)>, rest...>(inner);
  }
}

/// Type of the member that is reached.
template <auto first, auto... rest>
using Reached = std::remove_cvref_t<decltype(reach<typename OwnerOf<decltype(first)>::Type, first, rest...>(
    std::declval<typename OwnerOf<decltype(first)>::Type&>()))>;

}  // namespace detail

/// A field that is a member, or a member of a member, written and read as `type` says:
/// `field<&Outer::inner, &Inner::number>("number", "...", seed_type())`.
template <auto first, auto... rest>
[[nodiscard]] Field field(std::string_view key, std::string_view sentence, const ValueType& type, const Rule& rule = {},
                          WithoutValue without_value = WithoutValue::null) {
  using Owner = typename detail::OwnerOf<decltype(first)>::Type;
  Field made{.key = key,
             .sentence = sentence,
             .rule = rule,
             .without_value = without_value,
             .type = &type,
             .member = [](void* owner) -> void* {
               return &detail::reach<Owner, first, rest...>(*static_cast<Owner*>(owner));
             }};
  if constexpr (detail::is_optional<detail::Reached<first, rest...>>) {
    made.has_value = [](const void* owner) {
      return detail::reach<const Owner, first, rest...>(*static_cast<const Owner*>(owner)).has_value();
    };
  } else if constexpr (detail::is_list<detail::Reached<first, rest...>>) {
    made.has_value = [](const void* owner) {
      return !detail::reach<const Owner, first, rest...>(*static_cast<const Owner*>(owner)).empty();
    };
  }
  return made;
}

/// The same, written and read as its C++ type is everywhere.
template <auto first, auto... rest>
[[nodiscard]] Field field(std::string_view key, std::string_view sentence, const Rule& rule = {},
                          WithoutValue without_value = WithoutValue::null) {
  return field<first, rest...>(key, sentence, type_of<detail::Reached<first, rest...>>(), rule, without_value);
}

/// The fields of a member, or of a member of a member, stand among those of its owner, without a key of their own. Those
/// of an optional member are all there, or none is.
template <auto first, auto... rest>
[[nodiscard]] Field inlined(const StructType& fields) {
  using Owner = typename detail::OwnerOf<decltype(first)>::Type;
  using Member = detail::Reached<first, rest...>;
  if constexpr (detail::is_optional<Member>) {
    const auto find = [](void* owner) -> void* {
      Member& member = detail::reach<Owner, first, rest...>(*static_cast<Owner*>(owner));
      return member ? &*member : nullptr;
    };
    const auto make = [](void* owner) -> void* {
      Member& member = detail::reach<Owner, first, rest...>(*static_cast<Owner*>(owner));
      return member ? &*member : &member.emplace();
    };
    return {
        .key = "", .sentence = "", .type = &fields, .inlined_by = {{.find = find, .make = make, .is_optional = true}}};
  } else {
    const auto find = [](void* owner) -> void* {
      return &detail::reach<Owner, first, rest...>(*static_cast<Owner*>(owner));
    };
    return {.key = "", .sentence = "", .type = &fields, .inlined_by = {{.find = find, .make = find}}};
  }
}

/// The same, with the fields that the member's C++ type has everywhere.
template <auto first, auto... rest>
[[nodiscard]] Field inlined() {
  using Struct = typename detail::Contained<detail::Reached<first, rest...>>::type;
  return inlined<first, rest...>(dynamic_cast<const StructType&>(type_of<Struct>()));
}

/// A field of a question with its flag.
[[nodiscard]] inline Field asked(Field field, const Flag& flag) {
  field.flag = flag;
  return field;
}

/// A field whose value is made of several members of its owner; `type` is that of the whole owner.
template <class Owner>
[[nodiscard]] Field of_owner(std::string_view key, std::string_view sentence, const ValueType& type,
                             const Rule& rule = {}) {
  return {.key = key, .sentence = sentence, .rule = rule, .type = &type, .member = [](void* owner) { return owner; }};
}

/// A derived field that is compared with what was read: of a document that was changed it is an error.
[[nodiscard]] inline Field fitting(Field derived) {
  derived.must_fit = true;
  return derived;
}

/// A field that a document has only where its owner has it: `only_where<[](const Outer& outer) { return ...; }>(field)`.
template <auto has>
[[nodiscard]] Field only_where(Field made) {
  made.without_value = WithoutValue::omitted;
  made.has_value = [](const void* owner) {
    return has(*static_cast<const typename detail::OwnerOf<decltype(has)>::Type*>(owner));
  };
  return made;
}

/// A field that follows from others: `derived<[](const Outer& outer) { return ...; }>("ratio", ...)`.
template <auto get>
[[nodiscard]] Field derived(std::string_view key, std::string_view sentence, const Rule& rule = {},
                            WithoutValue without_value = WithoutValue::null) {
  using Owner = typename detail::OwnerOf<decltype(get)>::Type;
  using Value = std::remove_cvref_t<decltype(get(std::declval<const Owner&>()))>;
  return {.key = key,
          .sentence = sentence,
          .rule = rule,
          .without_value = without_value,
          .type = &type_of<Value>(),
          .derive = [](const void* owner) {
            const Value value = get(*static_cast<const Owner*>(owner));
            return type_of<Value>().json(&value);
          }};
}

}  // namespace rocking

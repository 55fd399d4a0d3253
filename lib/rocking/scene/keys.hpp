#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/scene/ground_motion_reading.hpp"
#include "rocking/scene/number_rule.hpp"

namespace rocking {

/// A key of an experiment file, and what it means in one sentence.
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

/// A unit in which a number may be given, by a key of its own.
struct UnitKey {
  Key key;
  const NumberRule& rule;
};

struct QuantityInUnit {
  std::size_t unit = 0;  ///< place among the keys
  Quantity value = 0.0;
};

/// How strong a ground motion is made.
struct Strength {
  UnitKey unit;
  Quantity value;
  std::vector<double> periods;  ///< of a spectral acceleration [s]: one, or the ends of a range
};

/// A form in which a value may stand in a file: a number or a law alone, a word, or an object with one key.
struct Form {
  std::string_view name;     ///< the word, or the key; empty: the number or law stands alone
  const NumberRule* rule;    ///< of the number or the law; null: a word
  bool may_be_drawn = true;  ///< whether a law may stand in place of the number
};

/// A value in one of several forms.
struct Formed {
  std::size_t form = 0;  ///< place among them
  Quantity value = 0.0;  ///< not used of a word
};

/// How many numbers a list has.
struct ListLength {
  std::size_t least;
  std::size_t most;
};

/// A standard deviation that a file may give relative to its mean.
struct Scatter {
  double* sigma;
  std::function<double()> mean;
};

/// Goes through the keys of an experiment, of which keys_of (experiment_keys.hpp) is the one list. There is one method
/// for each type of value. What happens at a key is up to the class: it is read from a file, the value that a caller in
/// C++ has given is checked, or the key is described.
class Keys {
 public:
  using Part = std::function<void(Keys&)>;

  Keys() = default;
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  virtual ~Keys() = default;

  virtual void text(const Key& key, std::string& value) = 0;
  virtual void number(const Key& key, double& value, const NumberRule& rule, Absent absent) = 0;
  virtual void whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent absent) = 0;
  /// A list; one that may be absent is asked for where it stands.
  virtual void numbers(const Key& key, std::vector<double>& values, const ListLength& length, const NumberRule& rule,
                       Absent absent) = 0;
  /// A number, or an object with the keys of a law (keys_of_law).
  virtual void quantity(const Key& key, Quantity& value, const NumberRule& rule, Absent absent) = 0;
  /// `chosen`: place among the names.
  virtual void word(const Key& key, std::size_t& chosen, std::span<const std::string_view> names, Absent absent) = 0;
  /// A list of words, which may be absent; `chosen`: places among the names.
  virtual void words(const Key& key, std::vector<std::size_t>& chosen, std::span<const std::string_view> names) = 0;
  /// The first form is a quantity alone. `remedy`: of a word that is none of theirs.
  virtual void forms(const Key& key, Formed& value, std::span<const Form> forms, std::string_view remedy,
                     Absent absent) = 0;
  virtual void mode(const Key& key, std::optional<section::ResponseMode>& value) = 0;
  virtual void seed(const Key& key, std::uint64_t& value) = 0;
  virtual void sweep(const Key& key) = 0;
  virtual void unknowns(const Key& key) = 0;

  /// `sigma`, in the unit of the mean, or `relative_sigma`, for all of these.
  virtual void scatter(std::initializer_list<Scatter> of) = 0;
  /// The quantity that one of the keys gives. Returns whether one was read.
  virtual bool one_of(std::span<const UnitKey> units, QuantityInUnit& value, Absent absent) = 0;
  virtual void record_format(const Key& key, std::optional<RecordFormat>& value) = 0;
  /// A file and its digest.
  virtual void file(const Key& file, const Key& digest, std::string& name) = 0;
  /// Several files in place of one. Returns whether the file may be read.
  virtual bool suite(const Key& key) = 0;
  /// The ground motion of a file, with its strength. Absent: the block or the strength is wrong, and the file is read
  /// only to find what is wrong with it.
  virtual void ground_motion(const GroundMotionReading& how, const std::optional<Strength>& strength,
                             Recorded& recorded) = 0;

  virtual void object(const Key& key, Absent absent, const Part& part) = 0;
  /// A number, or an object with more about it.
  virtual void number_or_object(const Key& key, bool is_object, const Part& number, const Part& object) = 0;
  /// A word that decides which keys stand beside it: those of `part(keys, kind)`.
  virtual void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
                     const std::function<void(Keys&, std::size_t)>& part) = 0;

  /// Whether to go on with a key that may be left out; `is_given`: whether the value has it.
  virtual bool stands(std::string_view key, bool is_given) = 0;
  /// Whether the values come from a file, so that defaults which follow from others are set.
  [[nodiscard]] virtual bool is_reading() const { return false; }
  /// How a default is written that follows from the values at these places of a file: not at all where the sweep
  /// changes one of them, for what is written would override it.
  [[nodiscard]] virtual Absent follows_from(std::span<const std::string_view>) const { return Absent::omitted; }
  /// Refuses what a file has at this key; of an empty key, the object itself.
  virtual void reject(std::string_view, Refusal) {}
  /// Refuses a key beside another one, which says the same.
  virtual void exclude(std::string_view, std::string_view /*other*/, Refusal) {}
  /// Refuses a key that means nothing here.
  virtual void refuse(std::string_view, std::string_view /*reason*/, std::string_view /*remedy*/) {}
  [[nodiscard]] virtual std::size_t problem_count() const { return 0; }

  [[nodiscard]] Absent follows_from(std::initializer_list<std::string_view> places) const {
    return follows_from(std::span(places.begin(), places.size()));
  }

  template <class Integer>
  void integer(const Key& key, Integer& value, const IntegerRule& rule, Absent absent) {
    constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    std::int64_t number = std::in_range<std::int64_t>(value) ? static_cast<std::int64_t>(value) : largest;
    whole_number(key, number, rule, absent);
    value = static_cast<Integer>(number);
  }
  /// An enumerator; `names` are in their order.
  template <class Enumeration>
  void choice(const Key& key, Enumeration& value, std::span<const std::string_view> names, Absent absent) {
    auto chosen = static_cast<std::size_t>(value);
    word(key, chosen, names, absent);
    value = static_cast<Enumeration>(chosen);
  }
  /// What may be left out altogether: `visit(*value)`.
  template <class T, class Visit>
  void optional(std::string_view key, std::optional<T>& value, const Visit& visit) {
    if (!stands(key, value.has_value())) return value.reset();
    if (!value) value.emplace();
    visit(*value);
  }
};

/// The alternative of a variant with this index, as it is by default.
template <class Variant>
[[nodiscard]] Variant alternative_at(std::size_t index) {
  Variant value;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    static_cast<void>(((i == index && (value.template emplace<i>(), true)) || ...));
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
  return value;
}

}  // namespace rocking

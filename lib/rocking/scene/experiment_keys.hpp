#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/fields/field_visitor.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/ground_motion_reading.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking {

/// A unit in which a number may be given, by a key of its own.
struct UnitKey {
  Key key;
  const Rule& rule;
};

/// How strong a ground motion is made.
struct Strength {
  std::string_view key;
  Quantity value;
  std::vector<double> periods;  ///< of a spectral acceleration [s]: one, or the ends of a range
};

/// What the keys of a recorded excitation need of the world outside the list: files that are read, samples that are
/// checked, or nothing where keys are described.
class RecordFields {
 public:
  virtual ~RecordFields() = default;
  /// Of a `std::optional<RecordFormat>`.
  [[nodiscard]] virtual const ValueType& format_type() const = 0;
  /// A file and its digest.
  virtual void file(FieldVisitor& in, const Key& file, const Key& digest, std::string& name) = 0;
  /// Several files in place of one. Returns whether the file may be read.
  virtual bool suite(FieldVisitor& in, const Key& key) = 0;
  /// The ground motion of a file, with its strength. Absent: the block or the strength is wrong, and the file is read
  /// only to find what is wrong with it.
  virtual void ground_motion(FieldVisitor& in, const GroundMotionReading& how, const std::optional<Strength>& strength,
                             Recorded& recorded) = 0;
};

/// The keys of `excitation`, kind by kind. `block`: mean block of the scene.
void keys_of(FieldVisitor& in, Excitation& excitation, const dynamics::Block& block, RecordFields& records);

/// An experiment without its sweep: one condition.
struct UnsweptExperiment {
  std::string title;
  std::uint64_t seed = 0;
  Condition condition;
};

/// The keys of an experiment file after `format`, in the order of the canonical text. Reading, the checks of a condition
/// from C++, the schema and the table of keys in lib/docs/formats.md follow from this list. Each value stands by itself;
/// what values demand of each other: check_relations.
void keys_of(FieldVisitor& in, UnsweptExperiment& question, RecordFields& records);

/// Names of the laws, each the key by which an object of a file gives one, in the order of NumberOrLaw after the number.
inline constexpr auto law_names = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array{std::variant_alternative_t<i + 1, NumberOrLaw>::name...};
}
(std::make_index_sequence<std::variant_size_v<NumberOrLaw> - 1>{});

/// The law with this place among the names, without its numbers.
[[nodiscard]] Quantity law_at(std::size_t place);

/// Goes through the keys of the law that the quantity has, which stand in the object that is its value. `rule` bounds
/// every value that is given, and the mean.
void keys_of_law(FieldVisitor& in, Quantity& quantity, const Rule& rule);

/// Why the numbers of a law are none together.
[[nodiscard]] std::optional<Refusal> refusal_of_law(const Quantity& quantity);

/// A number, or an object with one key, the name of a law. `rule` bounds every value that a law gives, and its mean.
class QuantityType final : public ValueType {
 public:
  explicit QuantityType(const Rule& rule) : number_(rule) {}
  [[nodiscard]] Json json(const void* value) const override;
  /// Of a fault the quantity is 0.
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void report_missing(const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule&) const override;
  [[nodiscard]] Shown shown(const void* value) const override;
  [[nodiscard]] std::string example() const override { return number_.example(); }

 private:
  NumberType<double> number_;
};

[[nodiscard]] inline QuantityType written_type(const Quantity*, const Rule& rule) { return QuantityType(rule); }

/// A quantity as one of several keys gives it.
struct QuantityInUnit {
  std::size_t unit = 0;  ///< place among the keys
  Quantity value = 0.0;
};

/// The quantity that one of the keys gives; returns whether one was read.
template <std::size_t size>
bool one_of(FieldVisitor& in, const std::array<UnitKey, size>& units, QuantityInUnit& value, Absent absent) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    const std::array types{QuantityType(units[i].rule)...};
    const std::array keys{Alternative{units[i].key, &types[i]}...};
    QuantityInUnit read = value;
    const bool is_read = in.one_of(keys, read.unit, &read.value, absent);
    if (is_read) value = std::move(read);
    return is_read;
  }
  (std::make_index_sequence<size>{});
}

/// A list of two quantities: those on the left and on the right.
class QuantityPairType final : public ValueType {
 public:
  explicit QuantityPairType(const Rule& rule) : quantity_(rule) {}
  [[nodiscard]] Json json(const void* value) const override;
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule&) const override;
  [[nodiscard]] Shown shown(const void*) const override;

 private:
  QuantityType quantity_;
};

/// Of a std::vector<BlockPart>.
[[nodiscard]] const ValueType& parts_type();

/// Of a Building: its list of modes, or their number.
[[nodiscard]] const ValueType& modes_type();

/// JSON Schema of any of the laws, whatever its numbers, to which the schema of a quantity refers.
[[nodiscard]] Json law_schema();

/// A form in which a value may stand in a file: a number or a law alone, a word, or an object with one key.
struct Form {
  std::string_view name;            ///< the word, or the key; empty: the number or law stands alone
  const Rule* rule;                 ///< of the number or the law; null: a word
  bool may_be_drawn = true;         ///< whether a law may stand in place of the number
  bool may_differ_by_side = false;  ///< whether a list of two may stand there: left and right
};

/// A value in one of several forms.
struct Formed {
  std::size_t form = 0;                          ///< place among them
  Quantity value = 0.0;                          ///< not used of a word
  std::optional<Quantity> right = std::nullopt;  ///< where it differs by side; `value` is that of the left
};

/// A Formed. The first form is a quantity alone. `remedy`: of a word that is none of theirs.
class FormsType final : public ValueType {
 public:
  FormsType(std::span<const Form> forms, std::string_view remedy) : forms_(forms), remedy_(remedy) {}
  [[nodiscard]] Json json(const void* value) const override;
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void report_missing(const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule&) const override;
  [[nodiscard]] Shown shown(const void* value) const override;
  [[nodiscard]] std::string example() const override { return std::string(forms_.front().rule->example); }
  /// JSON text of the form with this key, `{"rate_ratio":0.93}`, or by sides: `rate_ratio/0`. Absent: there is none.
  [[nodiscard]] std::optional<std::string> written(std::string_view name) const;

 private:
  std::span<const Form> forms_;
  std::string_view remedy_;
};

/// Of a `std::optional<section::ResponseMode>`, by its name.
[[nodiscard]] const ValueType& mode_type();

/// 64 bits as text or number; the canonical text has them as text.
[[nodiscard]] const ValueType& written_seed_type();

/// Read by read_sweep and read_unknowns (input/sweep.hpp).
[[nodiscard]] const ValueType& sweep_type();
[[nodiscard]] const ValueType& unknown_type();

/// The type of a Formed that gives a restitution.
[[nodiscard]] const FormsType& restitution_type();
[[nodiscard]] Formed formed(const Restitution& law);
[[nodiscard]] Restitution restitution_of(Formed value);

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

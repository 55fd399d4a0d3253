#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "rocking/fields/value_type.hpp"

/// Values that people write, each with the rule that it must keep. Their faults are told with what would do.
namespace rocking {

/// A number; a whole one also where it is spelled 2e3 or 500.0, with a least and a largest value.
template <class Number>
class NumberType final : public ValueType {
 public:
  explicit NumberType(const Rule& rule) : rule_(rule) {}
  [[nodiscard]] Json json(const void* value) const override { return *static_cast<const Number*>(value); }
  /// Of a fault it is 0, or the smallest whole number that the rule allows.
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void report_missing(const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule&) const override;
  [[nodiscard]] Shown shown(const void* value) const override;
  [[nodiscard]] std::string example() const override { return std::string(rule_.example); }
  [[nodiscard]] const Rule& rule() const { return rule_; }

 private:
  [[nodiscard]] std::string demand() const;
  [[nodiscard]] Number safe() const;

  Rule rule_;
};

class TextType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return *static_cast<const std::string*>(value); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "string"}}; }
  [[nodiscard]] Shown shown(const void* value) const override;
};

/// How many numbers a list has.
struct ListLength {
  std::size_t least;
  std::size_t most;
};

/// A list of numbers.
class NumbersType final : public ValueType {
 public:
  NumbersType(const ListLength& length, const Rule& rule) : length_(length), number_(rule) {}
  [[nodiscard]] Json json(const void* value) const override;
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  void report_missing(const ReadingPlace& place, void* value) const override;
  void check(const void* value, const ReadingPlace& place) const override;
  [[nodiscard]] Json schema(const Rule&) const override;
  [[nodiscard]] Shown shown(const void*) const override { return {.allowed = "list", .standard = ""}; }

 private:
  [[nodiscard]] Refusal refusal(const ReadingPlace& place) const;

  ListLength length_;
  NumberType<double> number_;
};

/// One of several names. `chosen` and `choose` are the place among them of what a value holds.
class NameType : public ValueType {
 public:
  explicit NameType(std::span<const std::string_view> names) : names_(names) {}
  [[nodiscard]] Json json(const void* value) const override { return std::string(names_[chosen(value)]); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  [[nodiscard]] Json schema(const Rule&) const override { return {{"type", "string"}, {"enum", names_}}; }
  [[nodiscard]] Shown shown(const void* value) const override;
  [[nodiscard]] std::string example() const override;

 protected:
  [[nodiscard]] virtual std::size_t chosen(const void* value) const = 0;
  virtual void choose(std::size_t place, void* value) const = 0;

 private:
  std::span<const std::string_view> names_;
};

/// Of an enumerator, or of a place itself.
template <class Enumeration>
class NamesType : public NameType {
 public:
  using NameType::NameType;

 private:
  [[nodiscard]] std::size_t chosen(const void* value) const override {
    return static_cast<std::size_t>(*static_cast<const Enumeration*>(value));
  }
  void choose(std::size_t place, void* value) const override {
    *static_cast<Enumeration*>(value) = static_cast<Enumeration>(place);
  }
};

/// What is read elsewhere: described here, and written as it stands. It has no value.
class OpaqueType final : public ValueType {
 public:
  OpaqueType(Json schema, std::string allowed) : schema_(std::move(schema)), allowed_(std::move(allowed)) {}
  [[nodiscard]] Json json(const void*) const override { return {}; }
  void read(const Json& json, const ReadingPlace& place, void* value) const override;
  [[nodiscard]] Json schema(const Rule&) const override { return schema_; }
  [[nodiscard]] Shown shown(const void*) const override { return {.allowed = allowed_, .standard = ""}; }

 private:
  Json schema_;
  std::string allowed_;
};

/// The type of a member and a rule, for FieldVisitor::value.
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] NumberType<Number> written_type(const Number*, const Rule& rule) { return NumberType<Number>(rule); }

/// `[1e-06, 1e+06]`, with round brackets at ends that do not belong to it.
[[nodiscard]] std::string interval_text(const Rule& bounds);

/// `"a", "b" or "c"`.
[[nodiscard]] std::string quoted_words(std::span<const std::string_view> names);

/// "`a`, `b`".
[[nodiscard]] std::string words_in_code(std::span<const std::string_view> names);

}  // namespace rocking

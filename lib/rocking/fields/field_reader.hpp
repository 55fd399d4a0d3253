#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/fields/field_visitor.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Whether a JSON pointer is another one, or leads into what stands there.
[[nodiscard]] bool is_within(std::string_view inner, std::string_view outer);

/// Reads one JSON object, key by key. Each call checks a key, remembers that it is known, and writes the value, or its
/// default, to the canonical object in the order of the calls. Keys must outlive it. Problems are collected, never
/// thrown; a call that met one leaves a value that is safe to go on with.
class FieldReader final : public FieldVisitor {
 public:
  /// `source` may be of any type: one that is not an object is a problem.
  FieldReader(const Json& source, std::string place, Problems& problems);

  /// The sweep sets what stands at these places: defaults that follow from them are not written.
  void follow_sweep(std::span<const std::string> places) { swept_ = places; }
  /// From now on only these keys are written.
  void write_only(std::span<const std::string> keys) { written_ = keys; }

  void field(const Key& key, const ValueType& type, void* value, Absent absent) override;
  bool one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) override;
  void object(const Key& key, Absent absent, const Part& part) override;
  void value_or_object(const Key& key, bool is_object, const Part& value, const Part& object) override;
  void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
             const std::function<void(FieldVisitor&, std::size_t)>& part) override;
  bool stands(std::string_view key, bool) override { return found(key) != nullptr; }
  [[nodiscard]] Absent follows_from(std::span<const std::string_view> places) const override;
  void exclude(std::string_view key, std::string_view other, Refusal refusal) override;
  [[nodiscard]] const Json* found(std::string_view key) override;
  void write(std::string_view key, Json canonical) override;
  void reject(std::string_view key, Refusal refusal) override;
  void ignore_others() override;

  [[nodiscard]] bool has(std::string_view key) { return found(key) != nullptr; }
  /// The number at a key that must be there; 0 of a fault.
  [[nodiscard]] double number(const Key& key, const Rule& rule);

  /// Reports the keys that nobody asked for; returns the canonical object.
  [[nodiscard]] Json finish();

 private:
  [[nodiscard]] std::string place_of(std::string_view key) const { return child_pointer(place_, key); }
  [[nodiscard]] bool is_written(std::string_view key) const;

  const Json* source_;
  std::string place_;
  Problems ignored_;  ///< of an object that is none: one problem is enough
  std::vector<std::string_view> known_;
  bool writes_ = true;
  std::span<const std::string> written_ = {};  ///< empty: all
  std::span<const std::string> swept_ = {};
  Json canonical_ = Json::object();
};

}  // namespace rocking

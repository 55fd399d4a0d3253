#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rocking/fields/field_visitor.hpp"

namespace rocking {

/// JSON Schema of an object with these keys and no others.
[[nodiscard]] Json closed_object(Json properties, Json required);

/// Describes the keys of an object: its schema, and a row of a table for each key.
class FieldDescriber final : public FieldVisitor {
 public:
  /// `prefix`: of the keys in the table, as `block.`.
  FieldDescriber(std::string prefix, std::vector<KeyRow>& rows)
      : FieldVisitor(nullptr, false), prefix_(std::move(prefix)), rows_(rows) {}

  [[nodiscard]] Json schema() const;

  void field(const Key& key, const ValueType& type, void* value, Absent absent) override;
  bool one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) override;
  void object(const Key& key, Absent absent, const Part& part) override;
  void value_or_object(const Key& key, bool is_object, const Part& value, const Part& object) override;
  void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
             const std::function<void(FieldVisitor&, std::size_t)>& part) override;
  [[nodiscard]] bool describes() const override { return true; }
  bool stands(std::string_view, bool) override { return true; }
  void exclude(std::string_view key, std::string_view other, Refusal refusal) override;
  void require_one_of(std::initializer_list<std::string_view> keys) override;

 private:
  void set(std::string_view key, Json schema, Absent absent);

  std::string prefix_;
  std::vector<KeyRow>& rows_;
  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json conditions_ = Json::array();  ///< on which keys stand together
  Json kinds_ = Json::array();       ///< the whole object for each kind
};

}  // namespace rocking

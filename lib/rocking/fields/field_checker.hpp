#pragma once

#include <string>
#include <utility>

#include "rocking/fields/field_visitor.hpp"

namespace rocking {

/// Checks the values that a caller in C++ has given, each by its ValueType. Places are JSON pointers into a file that
/// would have the same values.
class FieldChecker : public FieldVisitor {
 public:
  /// `place`: of the object; empty: the file.
  FieldChecker(std::string place, std::vector<base::Problem>& problems)
      : FieldVisitor(&problems, false), place_(std::move(place) + '/') {}

  void field(const Key& key, const ValueType& type, void* value, Absent) override {
    type.check(value, {.pointer = place_ + std::string(key.name), .problems = problems_});
  }
  bool one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) override {
    field(keys[chosen].key, *keys[chosen].type, value, absent);
    return false;
  }
  void object(const Key& key, Absent, const Part& part) override {
    const std::size_t length = place_.size();
    (place_ += key.name) += '/';
    part(*this);
    place_.resize(length);
  }
  void value_or_object(const Key& key, bool is_object, const Part& value, const Part& with_more) override {
    if (!is_object) return value(*this);
    object(key, Absent::standard, with_more);
  }
  void kinds(const Key&, std::span<const std::string_view>, std::size_t kind,
             const std::function<void(FieldVisitor&, std::size_t)>& part) override {
    part(*this, kind);
  }
  bool stands(std::string_view, bool is_given) override { return is_given; }

 protected:
  std::string place_;  ///< of the present object, with `/` at its end
};

}  // namespace rocking

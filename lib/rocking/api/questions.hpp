#pragma once

#include <vector>

#include "rocking/api/trajectory.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/fields/struct_type.hpp"

/// What callers in C++ ask: a list of fields a question, with the rule of each (QuestionCheck).
namespace rocking {

[[nodiscard]] const StructType& fields_of(const Execution*);
[[nodiscard]] const StructType& fields_of(const Provenance*);
[[nodiscard]] const StructType& fields_of(const TrajectoryRequest*);

template <const StructType& (*fields)()>
[[nodiscard]] const ValueType& struct_type() {
  return fields();
}

/// A list of structs that have these fields in questions.
template <class Item, const StructType& (*fields)()>
[[nodiscard]] const ValueType& list_of() {
  return the_only<ListType<std::vector<Item>, 0, struct_type<fields>>>();
}

}  // namespace rocking

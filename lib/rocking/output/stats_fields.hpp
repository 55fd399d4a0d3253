#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/stats/interval.hpp"

/// How values of statistics stand in documents.
namespace rocking {

/// `[low, high]`.
template <>
struct TypeOf<stats::Interval> {
  static const ValueType& get();
};

}  // namespace rocking

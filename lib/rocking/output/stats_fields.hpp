#pragma once

#include <vector>

#include "rocking/fields/struct_type.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"

/// How values of statistics stand in documents.
namespace rocking {

/// `[low, high]`.
template <>
struct TypeOf<stats::Interval> {
  static const ValueType& get();
};

/// `[level, value, low, high]`.
template <>
struct TypeOf<stats::QuantileEstimate> {
  static const ValueType& get();
};

/// A curve: lists of equal length.
template <>
struct TypeOf<std::vector<stats::Incidence>> {
  static const ValueType& get();
};

}  // namespace rocking

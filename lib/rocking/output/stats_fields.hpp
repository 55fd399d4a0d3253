#pragma once

#include <string_view>
#include <vector>

#include "rocking/fields/struct_type.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile.hpp"

/// How values of statistics stand in documents.
namespace rocking {

/// A count that stands in a document only where it is not 0.
template <auto member>
[[nodiscard]] Field count_if_any(std::string_view key, std::string_view sentence) {
  using Owner = typename detail::OwnerOf<decltype(member)>::Type;
  return only_where<[](const Owner& owner) { return owner.*member != 0; }>(field<member>(key, sentence));
}

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

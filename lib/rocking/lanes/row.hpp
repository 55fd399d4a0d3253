#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "rocking/lanes/pack.hpp"

namespace rocking::lanes {
namespace {

/// A truth value for each lane of a number type.
template <class Real>
using TruthOf = decltype(std::declval<Real>() < std::declval<Real>());

/// Loads a number type from successive doubles, and stores it there.
template <class Real>
struct Row {
  static constexpr int lanes = Real::lanes;
  static Real load(const double* numbers) { return Real(*reinterpret_cast<const Successive*>(numbers)); }
  static void store(const Real& value, double* numbers) { *reinterpret_cast<Successive*>(numbers) = value.numbers; }
  /// Stores the lanes whose bits are set, one after another. The doubles that follow, up to a whole register, are
  /// overwritten.
  static void store_those(std::uint32_t those, const Real& value, double* numbers) {
    store_packed(those, value.numbers, numbers);
  }
  /// Loads what store_those has stored into its lanes; the other lanes get any numbers.
  static Real load_those(std::uint32_t those, const double* numbers) {
    return Real(load_packed<typename Real::Numbers>(those, numbers));
  }
  /// Lane i from row i, at places[i].
  template <std::size_t length>
  static Real load_each(const std::array<double, length>* rows, const std::int64_t* places) {
    return Real(loaded_each<typename Real::Numbers>(rows, places));
  }

 private:
  /// Doubles in memory, as a vector. Unlike a copy of bytes, a store of them cannot change an address or an index, so
  /// that the compiler may keep these in registers.
  using Successive [[gnu::aligned(alignof(double))]] = typename Real::Numbers;
};
template <>
struct Row<double> {
  static constexpr int lanes = 1;
  static double load(const double* numbers) { return *numbers; }
  static void store(double value, double* numbers) { *numbers = value; }
  static void store_those(std::uint32_t, double value, double* numbers) { *numbers = value; }
  static double load_those(std::uint32_t, const double* numbers) { return *numbers; }
  template <std::size_t length>
  static double load_each(const std::array<double, length>* row, const std::int64_t* place) {
    return (*row)[static_cast<std::size_t>(*place)];
  }
};

}  // namespace
}  // namespace rocking::lanes

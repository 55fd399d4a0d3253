#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "rocking/lanes/row.hpp"
#include "rocking/lanes/zero_crossings.hpp"

namespace rocking::lanes {
namespace {

/// A search for the first zero crossings of polynomials over [0, 1], of any lanes and guards. The polynomials are
/// stored side by side, so that each register of them is searched together. Each has `count` coefficients; there are at
/// most `most`.
template <std::size_t count, std::size_t most, class Real>
class RootSearch {
 public:
  /// The answer where the search gave no result.
  static constexpr double unclear = std::numeric_limits<double>::quiet_NaN();
  /// The answer where the polynomial does not cross zero.
  static constexpr double never = std::numeric_limits<double>::infinity();

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Adds the polynomials coefficient(0) + coefficient(1) x + ... over [0, length] in the lanes `wanted`. Returns the
  /// place of the answers.
  template <class Coefficient>
  std::size_t ask(std::uint32_t wanted, const Real& length, Coefficient&& coefficient) {
    const std::size_t place = size_;
#pragma GCC unroll 20
    for (std::size_t k = 0; k < count; ++k) Row<Real>::store_those(wanted, coefficient(k), &c_[k][place]);
    Row<Real>::store_those(wanted, length, &length_[place]);
    size_ += static_cast<std::size_t>(std::popcount(wanted));
    return place;
  }

  void search() {
    for (Places& row : c_) Row<Real>::store(Real(0.0), &row[size_]);  // the unused part of the last register
    Row<Real>::store(Real(0.0), &length_[size_]);
    for (std::size_t place = 0; place < size_; place += lanes) look_at(place);
  }

  /// The first zero crossing as a share of the length; or `never` or `unclear`.
  [[nodiscard]] Real answer(std::uint32_t wanted, std::size_t place) const {
    return Row<Real>::load_those(wanted, &instant_[place]);
  }

 private:
  static constexpr auto lanes = static_cast<std::size_t>(Row<Real>::lanes);
  static constexpr std::array<double, 8> lane_numbers{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};

  [[gnu::noinline]] void look_at(std::size_t place) {
    using base::select;
    static_assert(count % 2 == 0);
    const auto wanted = Row<Real>::load(lane_numbers.data()) < Real(static_cast<double>(size_ - place));
    const Real length = Row<Real>::load(&length_[place]);
    const Real square = length * length;
    Real even(1.0);
    Real odd = length;
    Real c[count];
#pragma GCC unroll 20
    for (std::size_t k = 0; k < count; k += 2) {  // as in integrate::scale_to_unit
      c[k] = Row<Real>::load(&c_[k][place]) * even;
      c[k + 1] = Row<Real>::load(&c_[k + 1][place]) * odd;
      even = even * square;
      odd = odd * square;
    }
    ZeroCrossings<Real> found;
    first_zero_crossings<count>(c, wanted, found);
    const Real instant = select(found.crosses, found.instant, Real(never));
    Row<Real>::store(select(found.unclear, Real(unclear), instant), &instant_[place]);
  }

  /// Whole registers are stored at any place.
  using Places = std::array<double, most + lanes>;
  alignas(64) std::array<Places, count> c_;
  alignas(64) Places length_;
  alignas(64) Places instant_;
  std::size_t size_ = 0;
};

}  // namespace
}  // namespace rocking::lanes

#include "rocking/studies/orbits/orbit.hpp"

#include <algorithm>
#include <cstddef>

#include <Eigen/Dense>

#include "rocking/realisation/poincare_map.hpp"

namespace rocking {
namespace {

/// Places of the coordinates that the contact state leaves free.
std::vector<std::size_t> free_coordinates(dynamics::ContactState contact) {
  std::vector<std::size_t> places;
  if (dynamics::is_rocking(contact)) places = {0, 1};
  if (dynamics::is_sliding(contact)) places.push_back(2);
  return places;
}

bool comes_first(const std::complex<double>& a, const std::complex<double>& b) {
  if (std::abs(a) != std::abs(b)) return std::abs(a) > std::abs(b);
  if (a.real() != b.real()) return a.real() > b.real();
  return a.imag() > b.imag();
}

std::vector<std::complex<double>> multipliers_of(const PoincareImage& image) {
  const std::vector<std::size_t> places = free_coordinates(image.contact);
  if (places.empty()) return {};
  const auto size = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = 0; column < size; ++column) {
      matrix(row, column) =
          image.derivative[places[static_cast<std::size_t>(row)]][places[static_cast<std::size_t>(column)]];
    }
  }
  const Eigen::VectorXcd values = matrix.eigenvalues();
  std::vector<std::complex<double>> multipliers(values.begin(), values.end());
  std::ranges::sort(multipliers, comes_first);
  return multipliers;
}

}  // namespace

OrbitKind kind_of(const std::vector<std::complex<double>>& multipliers) {
  if (multipliers.empty() || std::abs(multipliers.front()) == 0.0) return OrbitKind::superstable;
  const bool is_pair = multipliers.front().imag() != 0.0;
  const auto outside =
      std::ranges::count_if(multipliers, [](const std::complex<double>& m) { return std::abs(m) >= 1.0; });
  if (outside == 0) return is_pair ? OrbitKind::focus : OrbitKind::node;
  if (is_pair) return OrbitKind::unstable_focus;
  if (outside > 1) return OrbitKind::unstable_node;
  return multipliers.front().real() > 0.0 ? OrbitKind::saddle : OrbitKind::flip_saddle;
}

Stability stability_of(const PoincareImage& image) {
  if (image.not_differentiable.any()) return {};
  Stability stability{.multipliers = multipliers_of(image)};
  stability.kind = kind_of(stability.multipliers);
  return stability;
}

}  // namespace rocking

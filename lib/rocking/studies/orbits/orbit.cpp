#include "rocking/studies/orbits/orbit.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Dense>

#include "rocking/realisation/fixed_point.hpp"
#include "rocking/studies/orbits/question.hpp"

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

bool is_same_cycle(const std::vector<SectionState>& a, const std::vector<SectionState>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < b.size(); ++shift) {
    bool is_same = true;
    for (std::size_t k = 0; k < a.size() && is_same; ++k) {
      const SectionState& other = b[(k + shift) % b.size()];
      is_same = a[k].contact == other.contact && distance(a[k].point, other.point) < same_point;
    }
    if (is_same) return true;
  }
  return false;
}

Orbit orbit_through(const section::StrobePoint& point, const PoincareImage& image, double residual, FoundBy found_by) {
  Orbit orbit{.period = static_cast<int>(image.states.size()),
              .cycles = (image.impacts + 1) / 2,
              .points = {{.point = point, .contact = image.contact}},
              .residual = residual,
              .stability = stability_of(image),
              .found_by = found_by};
  orbit.points.insert(orbit.points.end(), image.states.begin(), image.states.end() - 1);
  return orbit;
}

std::optional<Orbit> orbit_of(const PoincareMap& map, FixedPoint fixed, FoundBy found_by, base::StopRequest stop) {
  const int smallest = smallest_period(fixed.point, fixed.image.states);
  if (smallest < static_cast<int>(fixed.image.states.size())) {
    auto shorter = find_fixed_point(map, fixed.point, smallest, stop);
    if (!shorter) return std::nullopt;
    fixed = std::move(*shorter);
  }
  return orbit_through(fixed.point, fixed.image, fixed.residual, found_by);
}

std::optional<std::size_t> place_of(const std::vector<SectionState>& cycle, const std::vector<Orbit>& orbits) {
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    if (is_same_cycle(orbits[i].points, cycle)) return i;
  }
  return std::nullopt;
}

std::optional<std::vector<SectionState>> mirror_image_of(const PoincareMap& map, const Orbit& orbit) {
  auto mirror = map.half_way(orbit.points.front().point, orbit.period);
  if (!mirror) return std::nullopt;
  for (SectionState& state : *mirror) {
    state.point = {.tilt = -state.point.tilt, .tilt_rate = -state.point.tilt_rate, .slip_rate = -state.point.slip_rate};
  }
  return mirror;
}

std::optional<bool> OrbitsOfCondition::is_certified() const {
  if (mode.kind != section::ResponseKind::periodic) return std::nullopt;
  const auto is_of_response = [this](const Orbit& orbit) {
    return orbit.stability.is_stable() && section::periodic(orbit.cycles, orbit.period) == mode;
  };
  if (run_on) return is_of_response(orbits[*run_on]);
  return std::ranges::any_of(
      orbits, [&](const Orbit& orbit) { return orbit.found_by == FoundBy::run && is_of_response(orbit); });
}

OrbitLabels labels_of(const OrbitStudy& study) {
  OrbitLabels labels;
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    const std::optional<bool> is_certified = study.conditions[i].is_certified();
    if (!is_certified) continue;
    ++labels.periodic;
    if (*is_certified) {
      ++labels.certified;
    } else {
      labels.not_certified.push_back(i);
    }
  }
  return labels;
}

}  // namespace rocking

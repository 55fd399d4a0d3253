#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rocking {

/// How motions near a periodic orbit approach or leave it, by its multipliers.
enum class OrbitKind : std::uint8_t {
  superstable,        ///< every small change is lost within the period: all multipliers are 0, or there is none
  node,               ///< inside the unit circle, the largest one real
  focus,              ///< inside, the largest ones a complex pair
  saddle,             ///< one outside, > 1
  flip_saddle,        ///< one outside, < -1
  unstable_node,      ///< several outside, real
  unstable_focus,     ///< several outside, the largest ones a complex pair
  not_differentiable  ///< the orbit passes a grazing or a coincidence of events, where there are no multipliers
};
inline constexpr std::array all_orbit_kinds{
    OrbitKind::superstable, OrbitKind::node,          OrbitKind::focus,          OrbitKind::saddle,
    OrbitKind::flip_saddle, OrbitKind::unstable_node, OrbitKind::unstable_focus, OrbitKind::not_differentiable};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(OrbitKind kind);

/// Multipliers of the map over the period of an orbit.
struct Stability {
  /// Eigenvalues of the derivative within the contact state at the section, by falling modulus; of a pair, the one with
  /// the positive imaginary part first.
  std::vector<std::complex<double>> multipliers;
  OrbitKind kind = OrbitKind::not_differentiable;

  [[nodiscard]] bool is_stable() const {
    return kind == OrbitKind::superstable || kind == OrbitKind::node || kind == OrbitKind::focus;
  }
};

struct PoincareImage;
[[nodiscard]] Stability stability_of(const PoincareImage& image);

/// The kind that belongs to multipliers sorted as in Stability.
[[nodiscard]] OrbitKind kind_of(const std::vector<std::complex<double>>& multipliers);

}  // namespace rocking

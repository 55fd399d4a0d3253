#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/realisation/start.hpp"
#include "rocking/realisation/tangent_motion.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {

/// Derivative of Theta, Theta', V (rows) at the end with respect to those at the start (columns).
using SectionMatrix = std::array<std::array<double, 3>, 3>;

/// Changes of contact in their order, each as its kind with the side and the slip direction after it; the impacts of a
/// chatter that ends are left out, as are passages of the balance.
using ContactSequence = std::vector<std::uint8_t>;

/// Where a state goes in a number of periods.
struct PoincareImage {
  dynamics::ContactState contact = dynamics::ContactState::rest;  ///< at the start
  std::vector<SectionState> states;                               ///< after 1, 2, ... periods
  SectionMatrix derivative{};                                     ///< over all of them; 0 in the columns of what the
                                                                  ///< contact state at the start fixes
  int impacts = 0;                                                ///< that changed the edge; a chatter counts once
  bool moved = false;                                             ///< false: at rest in full contact throughout
  NotDifferentiable not_differentiable;
  ContactSequence sequence;
  std::vector<GuardCrossing> crossings;  ///< rates at which guards were reached
  std::vector<GuardMinimum> minima;      ///< of guards that were not reached

  [[nodiscard]] const section::StrobePoint& end() const { return states.back().point; }
};

/// Whether two sequences are one, up to the instant at which the cycle begins.
[[nodiscard]] bool is_same_sequence(const ContactSequence& a, const ContactSequence& b);

/// The same changes of the mirrored motion.
[[nodiscard]] ContactSequence mirrored(const ContactSequence& sequence);

/// The Poincare map of a condition with harmonic excitation in which nothing is random: from an instant at which the
/// argument of the excitation is a multiple of 2 pi to later ones. X is no coordinate: nothing depends on it.
///
class PoincareMap {
 public:
  /// What is kept of an image. `everything`: all of it, with steps of a tolerance of at most 1e-16, so that the map is
  /// smooth up to rounding between events. `states_and_derivative`: no crossings and minima of guards, and steps of at
  /// most 1e-13.
  enum class Detail : std::uint8_t { everything, states_and_derivative };

  /// Precondition: the condition is valid, periodic and not random.
  explicit PoincareMap(const Condition& condition, Detail detail = Detail::everything);

  /// Whether the mirror image of a motion is a motion.
  [[nodiscard]] bool has_mirror_symmetry() const { return rocking::has_mirror_symmetry(scene_); }

  /// After 1 ... `periods` periods. Absent where the motion ends before: it overturns, or has no solution.
  [[nodiscard]] std::optional<PoincareImage> image(const section::StrobePoint& from, int periods) const;

  /// Half a period after each of the first `periods` instants of the section; absent as above, and without mirror symmetry.
  [[nodiscard]] std::optional<std::vector<SectionState>> half_way(const section::StrobePoint& from, int periods) const;

  /// The mirror image of the state after `periods`/2 periods, an odd number of halves: its negative at an instant at
  /// which the excitation is the negative of that at the start. `states` has this state only; impacts and contact
  /// changes are those of the half. The map over `periods` is this one applied twice, and a symmetric orbit is a fixed
  /// point of it. Absent as above, and without mirror symmetry. Precondition: `periods` is odd.
  [[nodiscard]] std::optional<PoincareImage> mirrored_half(const section::StrobePoint& from, int periods) const;

 private:
  [[nodiscard]] std::optional<PoincareImage> image(const section::StrobePoint& from,
                                                   const dynamics::Schedule& schedule) const;
  [[nodiscard]] Beginning beginning(const section::StrobePoint& from, const dynamics::Schedule& schedule) const;

  Scene scene_;
  Detail detail_;
  Beginning at_zero_;
};

}  // namespace rocking

#pragma once

#include <array>
#include <string>
#include <vector>

#include "rocking/output/report.hpp"

/// One realisation as an animated block on its floor, beside its time history and phase portrait.
namespace rocking::analysis {

/// Largest number of samples of a motion in the page of a run, and in a page of its own.
inline constexpr std::size_t most_samples_of_a_run = 2400;
inline constexpr std::size_t most_samples_alone = 24'000;

/// State of the block and of its base at an instant.
struct MotionSample {
  double time = 0.0;               ///< since the start of the realisation [s]
  double tilt = 0.0;               ///< Theta [-], over psi of its side
  double tilt_rate = 0.0;          ///< Theta' [-]
  double slip = 0.0;               ///< X, relative to the base, over the half diagonal [-]
  double base_acceleration = 0.0;  ///< horizontal, over g
  std::string contact = "rest";    ///< `rest`, `slide`, `rock`, `rock_slide`, `overturned`
};

struct Animation {
  std::string name;                      ///< in a list of motions: `(1,3): realisation 7`
  std::string command;                   ///< command that prints its numbers
  BlockOutline block;                    ///< as it is drawn
  std::array<double, 2> shape_angles{};  ///< psi of the left and the right edge [rad]
  double half_diagonal = 0.0;            ///< R [m]
  double period = 0.0;  ///< of the excitation [s]; 0 if it is not periodic, and time is then shown in seconds
  double length = 0.0;  ///< of the whole realisation [s], of which `samples` may be the last part
  std::vector<MotionSample> samples = {};  ///< at least two, at increasing times
};

/// What the script of a page animates, with numbers in few digits.
[[nodiscard]] Json motion_json(const Animation& motion);

/// HTML: a place in which the script of the page animates these motions, with a choice between them, and the tilt of
/// each against time as a drawing for paper and for pages without scripts. There is at least one motion.
[[nodiscard]] std::string animations_html(const std::vector<Animation>& motions);

/// A page that shows one motion. Its policy is that of page_text.
[[nodiscard]] std::string animation_page_text(const std::string& title, const Animation& motion);

}  // namespace rocking::analysis

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rocking::random {

/// Purpose of a draw. It is part of the counter, so that two purposes never share a draw.
///
/// The values are part of the format `rocking.draws/1`. A new purpose takes the next value; a value is never reused.
enum class Source : std::uint8_t {
  static_friction = 1,
  kinetic_friction = 2,
  restitution = 3,
  amplitude = 4,
  phase = 5,
  tilt = 6,
  tilt_rate = 7,
  slip_rate = 8,
  check_normal = 9,
  block_width = 10,
  block_height = 11,
  fragility_bootstrap = 12,
  rare_choice = 13,
  mean_static_friction = 14,
  mean_kinetic_friction = 15,
  mean_restitution = 16,
  excitation_size = 17,
  excitation_frequency = 18,
  inference_shares = 19,
  inference_counts = 20,
  centre_height = 21,
  centre_offset = 22,
  radius_of_gyration = 23,
  left_edge = 24,
  right_edge = 25,
  base_left = 26,
  base_right = 27,
  mean_right_restitution = 28,
  slip = 29,
  vertical_size = 30,
  vertical_frequency = 31,
  vertical_phase = 32,
  building_frequency = 33,
  building_damping = 34,
  building_height = 35,
  first_block_part = 64,      ///< and 159 after it: five numbers of each part
  first_building_mode = 224,  ///< and 29 after it: three numbers of each mode
};

/// Names of the sources, in the order of their numbers, of which the first is 1.
inline constexpr std::array<std::string_view, 35> source_names{"static_friction",
                                                               "kinetic_friction",
                                                               "restitution",
                                                               "amplitude",
                                                               "phase",
                                                               "tilt",
                                                               "tilt_rate",
                                                               "slip_rate",
                                                               "check_normal",
                                                               "block_width",
                                                               "block_height",
                                                               "fragility_bootstrap",
                                                               "rare_choice",
                                                               "mean_static_friction",
                                                               "mean_kinetic_friction",
                                                               "mean_restitution",
                                                               "excitation_size",
                                                               "excitation_frequency",
                                                               "inference_shares",
                                                               "inference_counts",
                                                               "centre_height",
                                                               "centre_offset",
                                                               "radius_of_gyration",
                                                               "left_edge",
                                                               "right_edge",
                                                               "base_left",
                                                               "base_right",
                                                               "mean_right_restitution",
                                                               "slip",
                                                               "vertical_size",
                                                               "vertical_frequency",
                                                               "vertical_phase",
                                                               "building_frequency",
                                                               "building_damping",
                                                               "building_height"};

/// Empty of a number that no source has.
[[nodiscard]] constexpr std::string_view to_string(Source source) {
  const auto place = static_cast<std::size_t>(source) - 1;
  return place < source_names.size() ? source_names[place] : std::string_view();
}

/// Whether draws for this purpose are made again and again along a motion, rather than once at its start or apart from it.
[[nodiscard]] constexpr bool is_drawn_along_the_way(Source source) { return source <= Source::amplitude; }

}  // namespace rocking::random

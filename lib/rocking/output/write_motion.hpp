#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rocking/studies/motion/motion.hpp"

namespace rocking {

/// Value of `format` in the output of `rocking motion`.
inline constexpr std::string_view motion_format = "rocking.motion/1";

/// Whether the output contains what a figure needs: the motions sample by sample, and a fine response spectrum.
enum class MotionDetail : std::uint8_t { measures, series };

/// `rocking.motion/1` (lib/docs/ground-motions.md).
[[nodiscard]] std::string motion_text(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question,
                                      MotionDetail detail);

/// The same for a terminal.
[[nodiscard]] std::string motion_table(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question);

}  // namespace rocking

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/fields/struct_type.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// What was read of the file of a ground motion.
struct GroundMotionFacts {
  std::string file;
  std::string format;
  std::string unit;
  bool unit_is_assumed = false;
  std::vector<std::string> columns;  ///< of a file of numbers; empty for other formats
  std::optional<std::string> component;
  std::vector<std::string> components;  ///< among which it was chosen; empty: the file holds one
  std::optional<double> header_peak_m_s2;
  std::optional<bool> header_peak_agrees;
  std::optional<std::string> vertical_file;
  bool has_vertical = false;
  std::uint64_t samples = 0;
  std::optional<std::uint64_t> declared_samples;
  std::optional<double> time_step_s;
  double duration_s = 0.0;
  std::vector<std::string> warnings;

  friend bool operator==(const GroundMotionFacts&, const GroundMotionFacts&) = default;
};

[[nodiscard]] const StructType& fields_of(const GroundMotionFacts*);
[[nodiscard]] GroundMotionFacts facts_of(const GroundMotion& motion);

/// How a file was read, in a sentence without its name: `peer_at2, accelerations in g, horizontal component only`.
[[nodiscard]] std::string reading_in_words(const GroundMotionFacts& facts);

/// A file with the factors by which the conditions of a run multiply its accelerations.
struct UsedGroundMotion {
  GroundMotionFacts facts;
  double least_scale = 0.0;  ///< of a random one the mean, as in each condition
  double largest_scale = 0.0;
};

[[nodiscard]] const StructType& fields_of(const UsedGroundMotion*);

/// The factor on the accelerations of a recorded ground motion, of a random one the mean; absent under other excitations.
[[nodiscard]] std::optional<double> scale_of(const Scene& scene);

/// Peak horizontal accelerations over g, scaled; of random numbers with their means.
struct FloorPeaks {
  double pga_g = 0.0;         ///< of the ground
  double floor_peak_g = 0.0;  ///< of the floor on which the block stands
};

[[nodiscard]] const StructType& fields_of(const FloorPeaks*);

/// Absent of a block that does not stand in a building.
[[nodiscard]] std::optional<FloorPeaks> floor_peaks_of(const Scene& scene);

/// Every file of a run once, in the order of the conditions.
[[nodiscard]] std::vector<UsedGroundMotion> used_ground_motions(const std::vector<Condition>& conditions);

/// Above this factor a record is no longer taken for one of a stronger earthquake without a word. In use are limits of 2
/// to 4 (Bommer & Acevedo 2004, J. Earthq. Eng. 8(S1), 43-91); larger factors bias the response (Luco & Bazzurro 2007,
/// Earthq. Eng. Struct. Dyn. 36(13), 1813-1835).
inline constexpr double largest_usual_scale = 4.0;

/// The name of a file without its folder.
[[nodiscard]] std::string last_part(const std::string& path);

/// `ground motions: ...` and `scale factors: ...`, a line each: how the files were read, together where they were read
/// alike, and the range of the factors. Empty without ground motions.
[[nodiscard]] std::vector<std::string> ground_motion_lines(const std::vector<UsedGroundMotion>& motions);

/// How the files were read, and their scale factors, with a warning where these are large, a line each.
[[nodiscard]] std::string ground_motion_text(const Experiment& experiment);

}  // namespace rocking

// A motion does not depend on how densely the straight lines of its record are sampled: also where the block sticks without
// contact, the end of which is an event of its own.

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "rocking/base/number_text.hpp"
#include "rocking/rocking.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

/// Sines, and a block that they lift off the base between contacts.
struct LiftedBlock {
  double amplitude, frequency, vertical_amplitude, vertical_frequency, phase;
  double width, height, static_friction, kinetic_friction;
};

constexpr int samples = 60;
constexpr double step = 0.02;

/// A sine at its samples, with `more` - 1 points on the line between each two.
std::string lines_of(double amplitude, double frequency, double phase, int more) {
  const auto at = [&](int i) {
    return amplitude * (std::sin(2.0 * std::numbers::pi * frequency * step * i + phase) - std::sin(phase));
  };
  std::string text;
  for (int i = 0; i < samples; ++i) {
    for (int k = 0; k < more && (i + 1 < samples || k == 0); ++k) {
      const double part = static_cast<double>(k) / more;
      text += base::shortest(step * (i + part)) + ' ' + base::shortest(at(i) + part * (at(i + 1) - at(i))) + '\n';
    }
  }
  return text;
}

Trajectory trajectory_of(const LiftedBlock& block, int more, const support::TemporaryFolder& folder) {
  std::ofstream(folder / "h.txt") << lines_of(block.amplitude, block.frequency, 0.0, more);
  std::ofstream(folder / "v.txt") << lines_of(block.vertical_amplitude, block.vertical_frequency, block.phase, more);
  const std::string text =
      R"({"format": "rocking.experiment/1", "excitation": {"kind": "recorded", "file": "h.txt", "vertical_file": "v.txt",
          "format": "columns", "columns": ["time", "horizontal"], "units": "m/s2"}, "block": {"width_m": )" +
      base::shortest(block.width) + R"(, "height_m": )" + base::shortest(block.height) +
      R"(}, "friction": {"static": )" + base::shortest(block.static_friction) + R"(, "kinetic": )" +
      base::shortest(block.kinetic_friction) + "}}";
  return trajectory(parse_experiment(text, folder / ""));
}

TEST(SampledMotion, IsThatOfItsStraightLines) {
  const support::TemporaryFolder folder;
  for (const LiftedBlock& block : {LiftedBlock{3.793, 3.875, 8.319, 6.997, 2.131, 0.6647, 2.576, 1.2822, 0.9098},
                                   LiftedBlock{13.378, 5.7, 9.127, 8.354, 1.828, 0.7396, 2.358, 0.4959, 0.2978},
                                   LiftedBlock{11.852, 3.422, 7.953, 4.453, 0.678, 0.6335, 2.3846, 1.0179, 0.945},
                                   LiftedBlock{24.333, 3.778, 8.625, 9.957, 2.634, 0.2418, 0.9514, 0.3394, 0.2677}}) {
    const Trajectory sparse = trajectory_of(block, 1, folder);
    EXPECT_GT(sparse.losses_of_contact, 0U);
    for (const int more : {8, 64}) {
      const Trajectory dense = trajectory_of(block, more, folder);
      ASSERT_EQ(dense.events.size(), sparse.events.size()) << more;
      for (std::size_t i = 0; i < sparse.events.size(); ++i) {
        EXPECT_EQ(dense.events[i].kind, sparse.events[i].kind) << more << ", event " << i;
        EXPECT_NEAR(dense.events[i].tau, sparse.events[i].tau, 1e-7) << more << ", event " << i;
      }
    }
  }
}

}  // namespace
}  // namespace rocking

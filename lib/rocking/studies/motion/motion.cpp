#include "rocking/studies/motion/motion.hpp"
#include "rocking/plan/thresholds.hpp"

#include <utility>

namespace rocking {

MeasuredMotion measured(std::shared_ptr<const GroundMotion> motion, std::string sha256,
                        const MotionQuestion& question) {
  MeasuredMotion found;
  found.measures = intensity_measures(motion->samples, question.gravity);
  for (const double period : question.periods) {
    found.spectrum.push_back(spectral_point(motion->samples, question.gravity, period, question.damping));
  }
  if (question.block) found.uplift_scale = least_uplift_scale(motion->samples, dynamics::geometry_of(*question.block));
  found.motion = std::move(motion);
  found.sha256 = std::move(sha256);
  return found;
}

}  // namespace rocking

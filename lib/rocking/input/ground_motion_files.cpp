#include "rocking/input/ground_motion_files.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {
constexpr std::size_t most_samples_held = 20 * rules::most_samples;  // half a gigabyte
}

const GroundMotionFiles::File& GroundMotionFiles::file(const std::string& name) {
  const auto known = files_.find(name);
  if (known != files_.end()) return known->second;
  std::string text = source_(name, most_ground_motion_bytes);
  std::string digest = base::to_hex(base::sha256(text));
  return files_.emplace(name, File{std::move(text), std::move(digest)}).first->second;
}

std::shared_ptr<const GroundMotion> GroundMotionFiles::motion(const GroundMotionReading& how, Problems& problems) {
  auto found = readings_.find(how);
  if (found == readings_.end()) found = readings_.emplace(how, read(how)).first;
  const Reading& reading = found->second;
  problems.insert(problems.end(), reading.problems.begin(), reading.problems.end());
  return reading.motion;
}

GroundMotionFiles::Reading GroundMotionFiles::read(const GroundMotionReading& how) {
  Reading reading;
  auto motion = component(how.name, how, reading.problems);
  if (motion) {
    if (const auto why = why_vertical(*motion)) {
      motion->warnings.push_back("is a vertical component " + *why + ", and is used as the horizontal one");
    }
  }
  if (!how.vertical_name.empty()) {
    const auto vertical = component(how.vertical_name, how, reading.problems);
    if (!motion || !vertical || !add_vertical(*vertical, *motion, reading.problems)) return reading;
  }
  if (!motion) return reading;
  samples_ += motion->samples.size();
  if (samples_ > most_samples_held) {
    reading.problems.push_back({how.name, "",
                                "is needed with so many settings that these have more than 20 million samples together",
                                "sweep fewer values of gravity, time step or file in one experiment"});
    return reading;
  }
  reading.motion = std::make_shared<const GroundMotion>(std::move(*motion));
  return reading;
}

std::optional<GroundMotion> GroundMotionFiles::component(const std::string& name, const GroundMotionReading& how,
                                                         Problems& problems) {
  const std::string& text = file(name).text;
  if (text.size() > most_ground_motion_bytes) {
    problems.push_back({name, "", "is longer than 64 MB", "give a shorter or coarser ground motion"});
    return std::nullopt;
  }
  GroundMotionReading alone = how;
  alone.name = name;
  return read_ground_motion(text, alone, problems);
}

double GroundMotionFiles::spectral_acceleration(const std::shared_ptr<const GroundMotion>& motion,
                                                const std::vector<double>& periods, OscillatorAcceleration which) {
  const auto [found, is_new] = spectral_.try_emplace({motion, periods, which}, 0.0);
  if (is_new) {
    found->second = periods.size() == 1 ? rocking::spectral_acceleration(motion->samples, periods.front(), which)
                                        : average_spectral_acceleration(motion->samples, periods.at(0), periods.at(1));
  }
  return found->second;
}

}  // namespace rocking

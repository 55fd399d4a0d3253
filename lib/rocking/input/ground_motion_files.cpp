#include "rocking/input/ground_motion_files.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/digest.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_samples_held = 20 * rules::most_samples;  // half a gigabyte

std::string read_file_name(ObjectReader& keys, std::string_view key) {
  const Json* found = keys.value(key);
  if (found == nullptr) {
    keys.reject(key, "is missing",
                "add \"file\": \"record.txt\", its path relative to the folder of the experiment file, or \"suite\"");
    return {};
  }
  const std::string name = keys.text(key, "");
  if (!found->is_string()) return {};
  if (!name.empty() && name.find('\0') == std::string::npos) return name;
  keys.reject(key, "is not the name of a file", "give its path relative to the folder of the experiment file");
  return {};
}

void check_digest(ObjectReader& keys, std::string_view key, const std::string& digest) {
  const Json* found = keys.value(key);
  if (found == nullptr) return;
  std::string written = found->is_string() ? found->get<std::string>() : std::string();
  std::transform(written.begin(), written.end(), written.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (written == digest) return;
  keys.reject(key, "is not the digest of the file, which is " + digest,
              "restore the intended file, or omit \"" + std::string(key) + "\" to accept the present one");
}

}  // namespace

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

std::string read_named_file(ObjectReader& keys, std::string_view key, std::string_view digest_key,
                            GroundMotionFiles* files) {
  std::string name = read_file_name(keys, key);
  if (name.empty()) {
    static_cast<void>(keys.has(digest_key));
    return name;
  }
  const std::string digest = files == nullptr ? keys.text(digest_key, "") : files->digest(name);
  if (files != nullptr) check_digest(keys, digest_key, digest);
  keys.write(digest_key, digest);
  return name;
}

Quantity scale_for(ObjectReader& keys, const Strength& strength, GroundMotionFiles& files,
                   const std::shared_ptr<const GroundMotion>& motion, double gravity) {
  const std::string_view key = strength.unit.key.name;
  if (key == "scale") return strength.value;
  const double own = key == "pga_g" ? peak_acceleration(motion->samples)
                     : key == "pgv_m_s"
                         ? peak_velocity(motion->samples, gravity)
                         : files.spectral_acceleration(motion, strength.periods,
                                                       key == "sa_absolute_g" ? OscillatorAcceleration::absolute
                                                                              : OscillatorAcceleration::pseudo);
  Quantity scale = divided(strength.value, own);
  if (rules::scale.allows(reach_of(scale).largest)) return scale;
  keys.reject(key,
              "needs a scale above 1e6, since that of " + motion->name + " is " + base::significant(own, 3) +
                  (key == "pgv_m_s" ? " m/s" : " g"),
              "give a smaller number, or a stronger ground motion");
  return 1.0;
}

void refuse_suite_here(ObjectReader& keys, std::string_view key) {
  const std::string place = keys.place_of(key);
  const auto is_refused = [&place](const base::Problem& problem) { return problem.place.starts_with(place); };
  if (std::ranges::any_of(keys.problems(), is_refused)) return;
  keys.reject(key, "cannot stand in a value of the sweep", "write it in \"excitation\"");
}

}  // namespace rocking

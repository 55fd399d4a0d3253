#include "rocking/input/ground_motion_files.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/digest.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_samples_held = 20 * rules::most_samples;  // half a gigabyte

std::string file_name_in(FieldVisitor& in, const Key& key) {
  const Json* found = in.found(key.name);
  std::string name;
  if (found == nullptr) {
    in.reject(key.name,
              {"is missing",
               "add \"file\": \"record.txt\", its path relative to the folder of the experiment file, or \"suite\""});
    return name;
  }
  in.value(key, name, TextType(), Absent::error);
  if (!found->is_string() || (!name.empty() && name.find('\0') == std::string::npos)) return name;
  in.reject(key.name, {"is not the name of a file", "give its path relative to the folder of the experiment file"});
  return {};
}

void check_digest(FieldVisitor& in, std::string_view key, const std::string& digest) {
  const Json* found = in.found(key);
  if (found == nullptr) return;
  if (found->is_string() && in_small_letters(*found) == digest) return;
  in.reject(key, {"is not the digest of the file, which is " + digest,
                  "restore the intended file, or omit \"" + std::string(key) + "\" to accept the present one"});
}

void warn_of_vertical(const GroundMotion& vertical, GroundMotion& motion) {
  const auto is_equal = [](const dynamics::GroundMotionSample& sample) { return sample.horizontal == sample.vertical; };
  if (const auto why = why_horizontal(vertical)) {
    motion.warnings.push_back(vertical.name + " is a horizontal component " + *why +
                              ", and is used as the vertical one");
  } else if (std::ranges::all_of(motion.samples, is_equal)) {
    motion.warnings.push_back("has the same samples as its vertical component, " + vertical.name);
  }
}

/// That a motion ends in motion, in a sentence; absent: its last velocity is below a tenth of the largest.
std::optional<std::string> velocity_at_end(const std::vector<dynamics::GroundMotionSample>& samples, double gravity) {
  constexpr double tolerable = 0.1;
  constexpr std::size_t most_corners = 20;  // of a pulse that is given by the corners of a polyline
  if (samples.size() <= most_corners) return std::nullopt;
  const double peak = peak_velocity(samples, gravity), last = std::abs(final_velocity(samples, gravity));
  if (!(last > tolerable * peak)) return std::nullopt;
  return "ends with a velocity of " + base::significant(last, 3) + " m/s, " +
         std::to_string(std::lround(100.0 * last / peak)) +
         " % of its PGV: its acceleration has an offset, or it is cut in mid-motion; correct its baseline, since PGV, "
         "PGD and long periods are not those of the earthquake";
}

/// That a record ends in strong shaking, in a sentence; absent: its last sample is below a tenth of its PGA, or it is a pulse.
std::optional<std::string> acceleration_at_end(const std::vector<dynamics::GroundMotionSample>& samples) {
  constexpr double tolerable = 0.1, longest_pulse = 5.0;  // [s]
  if (samples.back().time - samples.front().time <= longest_pulse) return std::nullopt;
  const double peak = peak_acceleration(samples), last = std::abs(samples.back().horizontal);
  if (!(last > tolerable * peak)) return std::nullopt;
  return "ends with an acceleration of " + base::significant(last, 3) + " g, " +
         std::to_string(std::lround(100.0 * last / peak)) +
         " % of its PGA: it is cut in mid-motion; give the whole record, or taper its end";
}

/// What a motion has that records have not, and that another unit than the one that is taken would explain.
void warn_of_units(GroundMotion& motion) {
  constexpr double most_usual_g = 5.0;                                     // the strongest records reach 4.4 g
  constexpr double longest_usual_step = 0.1, shortest_usual_record = 1.0;  // [s]
  constexpr std::size_t most_in_a_pulse = 1000;
  const double duration = motion.samples.back().time - motion.samples.front().time;
  const double step = duration / static_cast<double>(motion.samples.size() - 1);
  const double peak = peak_acceleration(motion.samples);
  if (step > longest_usual_step) {
    motion.warnings.push_back("has a sample in " + base::significant(step, 3) +
                              " s, which is unusual: time steps are in seconds, 1 ms is 0.001");
  }
  if (duration < shortest_usual_record && motion.samples.size() > most_in_a_pulse) {
    motion.warnings.push_back("has " + std::to_string(motion.samples.size()) + " samples in " +
                              base::significant(duration, 3) +
                              " s, which is unusual: times and time steps are in seconds");
  }
  if (peak > most_usual_g) {
    motion.warnings.push_back("has a peak of " + base::significant(peak, 3) +
                              " g before it is scaled; recorded ground motions reach 4 g: check \"units\"");
  }
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
  auto motion = component(how.name, Role::horizontal, how, reading.problems);
  if (motion) {
    if (const auto why = why_vertical(*motion)) {
      motion->warnings.push_back("is a vertical component " + *why + ", and is used as the horizontal one");
    }
  }
  if (!how.vertical_name.empty()) {
    const auto vertical = component(how.vertical_name, Role::vertical, how, reading.problems);
    if (!motion || !vertical || !add_vertical(*vertical, *motion, reading.problems)) return reading;
    warn_of_vertical(*vertical, *motion);
  }
  if (!motion) return reading;
  warn_of_units(*motion);
  for (const auto& why : {velocity_at_end(motion->samples, how.gravity), acceleration_at_end(motion->samples)}) {
    if (why) motion->warnings.push_back(*why);
  }
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

std::optional<GroundMotion> GroundMotionFiles::component(const std::string& name, Role role,
                                                         const GroundMotionReading& how, Problems& problems) {
  const std::string& text = file(name).text;
  if (text.size() > most_ground_motion_bytes) {
    problems.push_back({name, "", "is longer than 64 MB", "give a shorter or coarser ground motion"});
    return std::nullopt;
  }
  GroundMotionReading alone = how;
  alone.name = name;
  alone.takes_vertical = role == Role::vertical;
  if (alone.takes_vertical) alone.component.clear();
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

void FiledRecords::file(FieldVisitor& in, const Key& file, const Key& digest, std::string& name) {
  name = file_name_in(in, file);
  std::string stated;
  if (name.empty()) {
    static_cast<void>(in.found(digest.name));
  } else if (files_ == nullptr) {
    in.value(digest, stated, TextType(), Absent::standard);
  } else {
    stated = files_->digest(name);
    check_digest(in, digest.name, stated);
    in.write(digest.name, stated);
  }
}

bool FiledRecords::suite(FieldVisitor& in, const Key& key) {
  if (in.found(key.name) == nullptr) return true;
  // One that stands in "excitation" was taken out before, or is refused already.
  if (in.problem_count() == 0)
    in.reject(key.name, {"cannot stand in a value of the sweep", "write it in \"excitation\""});
  in.ignore_others();
  return false;
}

void FiledRecords::ground_motion(FieldVisitor& in, const GroundMotionReading& how,
                                 const std::optional<Strength>& strength, Recorded& recorded) {
  if (how.format == RecordFormat::columns && !how.unit && in.found("units") == nullptr) {
    return in.reject("units", {"is missing; \"format\": \"columns\" does not state the unit of the accelerations",
                               "add \"units\": \"m/s2\"; known: " + record_units_in_words()});
  }
  if (how.name.empty() || files_ == nullptr) return;
  auto motion = files_->motion(how, in.problems());
  if (!motion) return;
  if (strength) {
    recorded.scale = scale_for(in, *strength, motion, how.gravity);
    recorded.measure_periods = strength->periods;
  }
  recorded.ground_motion = std::move(motion);
}

Quantity FiledRecords::scale_for(FieldVisitor& in, const Strength& strength,
                                 const std::shared_ptr<const GroundMotion>& motion, double gravity) {
  const std::string_view key = strength.key;
  if (key == "scale") return strength.value;
  const double own = key == "pga_g" ? peak_acceleration(motion->samples)
                     : key == "pgv_m_s"
                         ? peak_velocity(motion->samples, gravity)
                         : files_->spectral_acceleration(motion, strength.periods,
                                                         key == "sa_absolute_g" ? OscillatorAcceleration::absolute
                                                                                : OscillatorAcceleration::pseudo);
  const auto in_motion = key == "pgv_m_s" ? velocity_at_end(motion->samples, gravity) : std::nullopt;
  if (in_motion) {
    in.reject(key, {"needs the PGV of " + motion->name + ", which " + *in_motion,
                    "correct the baseline of the record, or sweep pga_g or sa_g"});
    return 1.0;
  }
  Quantity scale = divided(strength.value, own);
  if (rules::scale.allows(reach_of(scale).largest)) return scale;
  in.reject(key, {"needs a scale above 1e6, since that of " + motion->name + " is " + base::significant(own, 3) +
                      (key == "pgv_m_s" ? " m/s" : " g"),
                  "give a smaller number, or a stronger ground motion"});
  return 1.0;
}

}  // namespace rocking

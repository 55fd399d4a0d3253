#include "rocking/input/read_recorded.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/ground_motion_peaks.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

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

/// A file and its digest; empty where there is no usable name.
std::string read_named_file(ObjectReader& keys, std::string_view key, std::string_view digest_key,
                            GroundMotionFiles& files) {
  std::string name = read_file_name(keys, key);
  if (name.empty()) {
    static_cast<void>(keys.has(digest_key));
    return name;
  }
  const std::string digest = files.digest(name);
  check_digest(keys, digest_key, digest);
  keys.write(digest_key, digest);
  return name;
}

/// Place of the word at `key` among `names`, which is written out. Absent, and reported, if it is none of them.
std::optional<std::size_t> read_word(ObjectReader& keys, std::string_view key,
                                     std::span<const std::string_view> names) {
  const std::size_t problems_before = keys.problems().size();
  const std::size_t chosen = keys.choice(key, names, 0);
  if (keys.problems().size() != problems_before) return std::nullopt;
  return chosen;
}

/// `format` and `units`. The standard, `auto`, is not written out, as it was not in files before there was the key.
void read_format_and_unit(ObjectReader& keys, GroundMotionReading& how) {
  const Json* format = keys.value("format");
  if (format != nullptr && *format != "auto") {
    constexpr std::array<std::string_view, 4> names{"columns", "peer_at2", "esm_asc", "auto"};
    if (const auto chosen = read_word(keys, "format", names)) how.format = static_cast<RecordFormat>(*chosen);
  }
  if (keys.has("units")) {
    if (const auto chosen = read_word(keys, "units", record_unit_names)) how.unit = static_cast<RecordUnit>(*chosen);
  } else if (how.format == RecordFormat::columns) {
    keys.reject("units", "is missing; \"format\": \"columns\" does not state the unit of the accelerations",
                "add \"units\": \"m/s2\"; known: " + record_units_in_words());
  }
}

/// A key for how strong the motion is.
struct StrengthKey {
  std::string_view key;
  const NumberRule& rule;
};
constexpr std::array<StrengthKey, 3> strength_keys{
    {{"scale", rules::scale}, {"pga_g", rules::pga_g}, {"pgv_m_s", rules::pgv_m_s}}};

struct Strength {
  std::size_t key = 0;  ///< place among the keys
  double value = 1.0;
};

/// At most one of the keys; the standard is a scale of 1.
Strength read_strength(ObjectReader& keys) {
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < strength_keys.size(); ++i) {
    if (!keys.has(strength_keys[i].key)) continue;
    if (given) {
      keys.reject(strength_keys[i].key, "excludes \"" + std::string(strength_keys[*given].key) + '"',
                  "keep one of them");
    } else {
      given = i;
    }
  }
  const StrengthKey& key = strength_keys[given.value_or(0)];
  return {.key = given.value_or(0), .value = keys.number(key.key, key.rule.with_default(1.0))};
}

/// The factor that gives the motion its strength.
double scale_for(ObjectReader& keys, const Strength& strength, const GroundMotion& motion, double gravity) {
  if (strength.key == 0) return strength.value;
  const bool is_acceleration = strength.key == 1;
  const double peak = is_acceleration ? peak_acceleration(motion.samples) : peak_velocity(motion.samples, gravity);
  const double scale = strength.value / peak;
  if (rules::scale.allows(scale)) return scale;
  keys.reject(strength_keys[strength.key].key,
              "needs a scale above 1e6, since the peak of " + motion.name + " is " + base::significant(peak, 3) +
                  (is_acceleration ? " g" : " m/s"),
              "give a smaller number, or a ground motion with a larger peak");
  return 1.0;
}

/// A suite is taken out before an excitation is read, unless it was refused or stands within a sweep.
void refuse_suite_here(ObjectReader& keys) {
  const std::string place = keys.place_of("suite");
  const auto is_refused = [&place](const base::Problem& problem) { return problem.place.starts_with(place); };
  if (std::ranges::any_of(keys.problems(), is_refused)) return;
  keys.reject("suite", "cannot stand in a value of the sweep", "write it in \"excitation\"");
}

}  // namespace

Recorded read_recorded(ObjectReader& keys, const dynamics::Block& block, const SceneReading& reading) {
  Recorded excitation;
  if (keys.has("suite")) {
    refuse_suite_here(keys);
    keys.ignore_others();
    return excitation;
  }
  const bool block_is_sound = block.width > 0.0 && block.height > 0.0 && block.gravity > 0.0;
  GroundMotionReading how{.name = read_named_file(keys, "file", "sha256", reading.files),
                          .time_step = {},
                          .gravity = block_is_sound ? block.gravity : 1.0};
  if (keys.has("vertical_file")) {
    how.vertical_name = read_named_file(keys, "vertical_file", "vertical_sha256", reading.files);
    if (how.vertical_name.empty()) how.name.clear();
  }
  const auto is_sound = [&keys](const auto& read) {
    const std::size_t problems_before = keys.problems().size();
    read();
    return keys.problems().size() == problems_before;
  };
  if (!is_sound([&] { read_format_and_unit(keys, how); })) how.name.clear();
  Strength strength;
  const bool has_strength = is_sound([&] { strength = read_strength(keys); });
  const bool has_times = is_sound([&] {
    if (keys.has("time_step_s")) how.time_step = keys.number("time_step_s", rules::time_step);
  });
  if (!has_times) how.name.clear();
  const double strobe = block_is_sound ? strobe_once_a_second(block) : 1.0;
  excitation.frequency_ratio =
      keys.derived_number("frequency_ratio", rules::frequency_ratio, strobe, reading.of_recorded);
  if (strength.key == 0) excitation.scale = strength.value;
  if (how.name.empty()) return excitation;
  auto motion = reading.files.motion(how, keys.problems());  // what is wrong with it is told whatever the block
  if (!block_is_sound || !motion) return excitation;
  if (has_strength) excitation.scale = scale_for(keys, strength, *motion, how.gravity);
  excitation.ground_motion = std::move(motion);
  return excitation;
}

}  // namespace rocking

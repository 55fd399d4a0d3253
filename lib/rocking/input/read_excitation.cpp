#include "rocking/input/read_excitation.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/input/read_quantity.hpp"
#include "rocking/input/read_recorded.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr std::array<std::string_view, 3> kinds{"harmonic", "recorded", "pulse"};
/// In the order of dynamics::PulseShape.
constexpr std::array<std::string_view, 3> pulse_shapes{"sine", "cosine", "ricker"};

/// A key that gives a number in its own unit.
struct UnitKey {
  std::string_view key;
  const NumberRule& rule;
};
using UnitKeys = std::array<UnitKey, 3>;

/// The first gives A_h; the others are in the order of AccelerationUnit.
constexpr UnitKeys amplitude_keys{
    {{"amplitude", rules::amplitude}, {"amplitude_g", rules::amplitude_g}, {"amplitude_m_s2", rules::amplitude_m_s2}}};
/// The first gives Omega_h; the others are in the order of FrequencyUnit.
constexpr UnitKeys frequency_keys{{{"frequency_ratio", rules::frequency_ratio},
                                   {"frequency_hz", rules::frequency_hz},
                                   {"period_s", rules::period_s}}};

std::string example_of(const UnitKey& unit) {
  return '"' + std::string(unit.key) + "\": " + std::string(unit.rule.example);
}

struct GivenNumber {
  std::size_t key;  ///< place among the keys
  double value;
};

/// The number that exactly one of the keys must give; absent where there is none, and the problem is reported.
std::optional<GivenNumber> read_one_of(ObjectReader& keys, const UnitKeys& units) {
  const std::size_t problems_before = keys.problems().size();
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (!keys.has(units[i].key)) continue;
    if (given) {
      keys.reject(units[i].key, "excludes \"" + std::string(units[*given].key) + '"', "keep one of them");
    } else {
      given = i;
    }
  }
  if (!given) {
    keys.reject(units[0].key, "is missing",
                "add " + example_of(units[0]) + ", or " + example_of(units[1]) + ", or " + example_of(units[2]));
    return std::nullopt;
  }
  const double value = keys.number(units[*given].key, units[*given].rule);
  if (keys.problems().size() != problems_before) return std::nullopt;
  return GivenNumber{*given, value};
}

/// Of a kind that has both.
template <class Kind>
void read_amplitude_and_frequency(ObjectReader& keys, Kind& excitation) {
  if (const auto amplitude = read_one_of(keys, amplitude_keys)) {
    const auto [key, value] = *amplitude;
    if (key == 0) {
      excitation.amplitude = value;
    } else {
      excitation.physical_amplitude = PhysicalAmplitude{value, static_cast<AccelerationUnit>(key - 1)};
    }
  }
  if (const auto frequency = read_one_of(keys, frequency_keys)) {
    const auto [key, value] = *frequency;
    if (key == 0) {
      excitation.frequency_ratio = value;
    } else {
      excitation.physical_frequency = PhysicalFrequency{value, static_cast<FrequencyUnit>(key - 1)};
    }
  }
}

Harmonic read_harmonic(ObjectReader& keys) {
  Harmonic excitation;
  read_amplitude_and_frequency(keys, excitation);
  excitation.phase = read_quantity(keys, "phase_rad", rules::phase.with_default(mean_of(excitation.phase)));
  return excitation;
}

void refuse(ObjectReader& keys, std::string_view key, std::string reason, std::string remedy) {
  if (keys.has(key)) keys.reject(key, std::move(reason), std::move(remedy));
}

Recorded read_recorded_keys(ObjectReader& keys, const dynamics::Block& block, const SceneReading& reading) {
  for (const UnitKey& unit : amplitude_keys) {
    refuse(keys, unit.key, "is for harmonic excitation and pulses; a ground motion has a scale",
           "write \"scale\" instead");
  }
  for (const std::string_view key : {"frequency_hz", "period_s"}) {
    refuse(keys, key, "is for harmonic excitation and pulses; a ground motion has no frequency",
           "omit it: a strobe period is one second, unless \"frequency_ratio\" is given");
  }
  refuse(keys, "phase_rad", "is for harmonic excitation; a ground motion has no phase",
         "shift the times of the ground motion");
  return read_recorded(keys, block, reading);
}

Pulse read_pulse(ObjectReader& keys) {
  for (const std::string_view key : {"file", "suite", "sha256", "time_step_s"}) {
    refuse(keys, key, "is for a ground motion; a pulse is given by its shape",
           "write \"kind\": \"recorded\", or omit it");
  }
  refuse(keys, "scale", "is for a ground motion; a pulse has an amplitude", "write \"amplitude\" instead");
  refuse(keys, "phase_rad", "is for harmonic excitation; a pulse begins with the run and has no phase",
         "omit it, or choose another \"shape\"");
  Pulse excitation;
  if (keys.has("shape")) {
    excitation.shape = static_cast<dynamics::PulseShape>(keys.choice("shape", pulse_shapes, 0));
  } else {
    keys.reject("shape", "is missing", "add \"shape\": \"sine\", \"cosine\" or \"ricker\"");
  }
  read_amplitude_and_frequency(keys, excitation);
  return excitation;
}

}  // namespace

Excitation read_excitation(ObjectReader& in, const dynamics::Block& block, const SceneReading& reading) {
  Excitation excitation;
  in.object("excitation", [&](ObjectReader& keys) {
    const std::size_t problems_before = keys.problems().size();
    const std::size_t kind = keys.choice("kind", kinds, 0);
    if (keys.problems().size() != problems_before) return keys.ignore_others();
    switch (kind) {
      case 0: excitation = read_harmonic(keys); break;
      case 1: excitation = read_recorded_keys(keys, block, reading); break;
      default: excitation = read_pulse(keys);
    }
  });
  return excitation;
}

}  // namespace rocking

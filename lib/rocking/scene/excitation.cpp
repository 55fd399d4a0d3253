#include "rocking/scene/excitation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr auto kind_names = []<class... Kinds>(std::variant<Kinds...>*) {
  return std::array{Kinds::name...};
}(static_cast<Excitation*>(nullptr));
/// In the order of dynamics::PulseShape.
constexpr std::array<std::string_view, 8> pulse_shapes{"sine",      "cosine",   "ricker", "half_sine",
                                                       "rectangle", "triangle", "type_c", "mavroeidis_papageorgiou"};

/// The first gives A_h; the others are in the order of AccelerationUnit.
constexpr std::array<UnitKey, 3> amplitude_units{
    {{{"amplitude", "A_h: the peak base acceleration over psi g"}, rules::amplitude},
     {{"amplitude_g", "the peak base acceleration over gravity_m_s2"}, rules::amplitude_g},
     {{"amplitude_m_s2", "the peak base acceleration [m/s^2]"}, rules::amplitude_m_s2}}};
/// The first gives Omega_h; the others are in the order of FrequencyUnit.
constexpr std::array<UnitKey, 3> frequency_units{
    {{{"frequency_ratio", "Omega_h = omega/p; a strobe period is 2 pi/omega"}, rules::frequency_ratio},
     {{"frequency_hz", "omega/(2 pi) [Hz]"}, rules::frequency_hz},
     {{"period_s", "2 pi/omega [s]"}, rules::period_s}}};
constexpr std::array<UnitKey, 3> vertical_amplitude_units{
    {{{"amplitude", "A_v: the peak vertical acceleration over psi g"}, rules::amplitude},
     {{"amplitude_g", "the peak vertical acceleration over gravity_m_s2"}, rules::amplitude_g},
     {{"amplitude_m_s2", "the peak vertical acceleration [m/s^2]"}, rules::amplitude_m_s2}}};
constexpr std::array<UnitKey, 3> vertical_frequency_units{
    {{{"frequency_ratio",
       "Omega_v over p; where strobe points are asked for a whole multiple of Omega_h, or Omega_h over a whole number"},
      rules::frequency_ratio},
     {{"frequency_hz", "Omega_v p/(2 pi) [Hz]; likewise"}, rules::frequency_hz},
     {{"period_s", "2 pi/(Omega_v p) [s]; likewise"}, rules::period_s}}};
/// Of a ground motion.
constexpr std::array<UnitKey, all_strengths.size()> strength_units{
    {{{"scale", "factor on the recorded accelerations"}, rules::scale},
     {{"pga_g", "in place of scale: the peak horizontal acceleration over gravity_m_s2"}, rules::pga_g},
     {{"pgv_m_s", "in place of scale: the peak horizontal velocity [m/s]"}, rules::pgv_m_s},
     {{"sa_g",
       "in place of scale: the spectral acceleration of hazard models, which is the pseudo-acceleration at period_s "
       "with 5 % damping, over gravity_m_s2"},
      rules::pga_g},
     {{"sa_p_g", "in place of scale: the same at the period 2 pi/p of the mean block"}, rules::pga_g},
     {{"avgsa_g", "in place of scale: the geometric mean of the same over periods_s, at ten periods with equal ratios"},
      rules::pga_g},
     {{"sa_absolute_g",
       "in place of scale: the largest absolute acceleration of the oscillator of period_s with 5 % damping, over "
       "gravity_m_s2; hazard and ground-motion models are not given in it"},
      rules::pga_g}}};

/// The number as it is given: `normalised`, or in the physical unit.
template <class Physical>
QuantityInUnit number_of(const Quantity& normalised, const std::optional<Physical>& physical) {
  if (!physical) return {0, normalised};
  return {static_cast<std::size_t>(physical->unit) + 1, physical->value};
}

template <class Physical>
void set(const QuantityInUnit& number, Quantity& normalised, std::optional<Physical>& physical) {
  if (number.unit == 0) {
    normalised = number.value;
  } else {
    physical = Physical{number.value, static_cast<decltype(Physical::unit)>(number.unit - 1)};
  }
}

/// Of a kind that has both.
template <class Kind>
void keys_of_amplitude_and_frequency(FieldVisitor& in, Kind& kind, const std::array<UnitKey, 3>& amplitudes,
                                     const std::array<UnitKey, 3>& frequencies) {
  QuantityInUnit amplitude = number_of(kind.amplitude, kind.physical_amplitude);
  if (one_of(in, amplitudes, amplitude, Absent::error)) set(amplitude, kind.amplitude, kind.physical_amplitude);
  QuantityInUnit frequency = number_of(kind.frequency_ratio, kind.physical_frequency);
  if (one_of(in, frequencies, frequency, Absent::error)) {
    set(frequency, kind.frequency_ratio, kind.physical_frequency);
  }
}

void refuse_building(FieldVisitor& in) {
  in.refuse("building",
            "is for a ground motion: the motion of a floor under harmonic shaking or a pulse is not computed",
            "write \"kind\": \"recorded\", or give the amplitude of the floor");
}

void keys_of(FieldVisitor& in, Harmonic& harmonic, const dynamics::Block&, RecordFields&) {
  refuse_building(in);
  keys_of_amplitude_and_frequency(in, harmonic, amplitude_units, frequency_units);
  in.value({"phase_rad", "Phi [rad]"}, harmonic.phase, rules::phase, Absent::standard);
  in.optional("vertical", harmonic.vertical, [&in](VerticalHarmonic& vertical) {
    in.object({"vertical", "vertical motion: a_v/g = A_v psi times the sine of Omega_v tau + Phi_v, > 0 upwards"},
              Absent::omitted, [&vertical](FieldVisitor& keys) {
                keys_of_amplitude_and_frequency(keys, vertical, vertical_amplitude_units, vertical_frequency_units);
                keys.value({"phase_rad", "Phi_v at the start [rad]"}, vertical.phase, rules::phase, Absent::standard);
              });
  });
}

void refuse_keys_of_others(FieldVisitor& in, const Recorded&) {
  for (const UnitKey& unit : amplitude_units) {
    in.refuse(unit.key.name, "is for harmonic excitation and pulses; a ground motion has a scale",
              "write \"scale\" instead");
  }
  in.refuse("vertical", "is for harmonic excitation; a ground motion has a vertical component",
            "give \"vertical_file\", or a column \"vertical\"");
  in.refuse("frequency_hz", "is for harmonic excitation and pulses; a ground motion has no frequency",
            "omit it: a strobe period is one second, unless \"frequency_ratio\" is given");
  in.refuse("phase_rad", "is for harmonic excitation; a ground motion has no phase",
            "shift the times of the ground motion");
}

void keys_of_format_and_unit(FieldVisitor& in, GroundMotionReading& how, const RecordFields& records) {
  in.field({"format", "of the file; auto, as without this key: recognised by its first lines (ground-motions.md)"},
           records.format_type(), &how.format, Absent::omitted);
  if (in.stands("component", !how.component.empty())) {
    in.value({"component",
              "of a file that holds several, as its header names it: \"N10E\", \"90\"; two of one name are \"channel "
              "1\" and \"channel 2\""},
             how.component, TextType(), Absent::omitted);
  }
  in.optional("units", how.unit, [&in](RecordUnit& unit) {
    in.choice({"units",
               "of the accelerations; must agree with a file that states its unit; absent: that of the file, and m/s2 "
               "for columns of numbers, but format columns needs it"},
              unit, record_unit_names, Absent::omitted);
  });
}

class ColumnsType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json names = Json::array();
    for (const RecordColumn column : *static_cast<const Columns*>(value)) names.push_back(name_of(column));
    return names;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto& names = record_column_names;
    const auto place_of = [&](const Json& word) {
      return std::ranges::find(names, word.is_string() ? word.get<std::string>() : "");
    };
    const auto is_known = [&](const Json& word) { return place_of(word) != names.end(); };
    auto& columns = *static_cast<Columns*>(value);
    columns.clear();
    if (!json.is_array() || json.empty() || !std::all_of(json.begin(), json.end(), is_known)) {
      return place.reject(json, "must be a list of " + quoted_words(names),
                          "give \"columns\": [\"time\", \"horizontal\"]");
    }
    for (const Json& word : json) columns.push_back(static_cast<RecordColumn>(place_of(word) - names.begin()));
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    const NamesType<RecordColumn> column(record_column_names);
    return {{"type", "array"}, {"items", column.schema(rule)}, {"minItems", 1}};
  }
  [[nodiscard]] Shown shown(const void*) const override {
    return {.allowed = "list of " + words_in_code(record_column_names), .standard = ""};
  }

 private:
  using Columns = std::vector<RecordColumn>;
};

void keys_of_columns(FieldVisitor& in, GroundMotionReading& how) {
  if (!in.stands("columns", !how.columns.empty())) return;
  const std::size_t problems_before = in.problem_count();
  in.value({"columns",
            "of a file of numbers, in its order; it must be given where the file has a header, more than two columns, "
            "more than one beside time_step_s, or times that are not evenly spaced"},
           how.columns, ColumnsType(), Absent::omitted);
  if (!in.is_reading() || in.problem_count() != problems_before) return;
  if (auto refusal = refuse_columns(how.columns, in.stands("time_step_s", how.time_step.has_value()))) {
    in.reject("columns", *std::move(refusal));
  }
}

/// The periods of the spectral accelerations by which a file gives the strength of a motion; empty: none.
std::vector<double> keys_of_periods(FieldVisitor& in, std::string_view strength, const dynamics::Block* block) {
  std::vector<double> periods;
  const bool is_sa = strength == "sa_g" || strength == "sa_absolute_g";
  if (is_sa || in.stands("period_s", false)) {
    double period = 1.0;
    if (in.is_reading() && !is_sa) {
      in.refuse("period_s", "is for \"sa_g\" and \"sa_absolute_g\", and for harmonic excitation and pulses",
                strength == "avgsa_g" ? "write \"periods_s\": [shortest, longest]" : "omit it");
    } else {
      in.value({"period_s", "with sa_g or sa_absolute_g: period of the oscillator [s]"}, period,
               rules::oscillator_period_s, is_sa ? Absent::error : Absent::omitted);
      if (is_sa) periods = {period};
    }
  }
  const bool is_average = strength == "avgsa_g";
  if (is_average || in.stands("periods_s", false)) {
    if (in.is_reading() && !is_average) {
      in.refuse("periods_s", "is for \"avgsa_g\"", is_sa ? "write \"period_s\": 1.0" : "omit it");
    } else {
      std::vector<double> range{0.5, 2.0};
      in.value({"periods_s", "with avgsa_g: shortest and longest period [s]"}, range,
               NumbersType({.least = 2, .most = 2}, rules::oscillator_period_s),
               is_average ? Absent::error : Absent::omitted);
      const bool is_sound = range.size() == 2 && range[0] < range[1];
      if (range.size() == 2 && !is_sound) in.reject("periods_s", {"must rise", "write [shortest, longest]"});
      if (is_average && is_sound) periods = range;
    }
  }
  if (strength == "sa_p_g" && block != nullptr) {
    periods = {2.0 * std::numbers::pi / dynamics::geometry_of(*block).frequency_parameter};
  }
  return periods;
}

void keys_of(FieldVisitor& in, Building& building) {
  const Json* modes = in.found("modes");
  const bool has_list = modes != nullptr ? modes->is_array() : !building.modes.empty();
  if (has_list) {
    for (const std::string_view key : {"frequency_hz", "damping_ratio", "height_ratio"}) {
      in.refuse(key, "excludes a list of modes, each of which has a frequency, a damping ratio and a factor",
                "omit it");
    }
  } else {
    in.value({"frequency_hz", "of the first mode of a uniform shear building [Hz]"}, building.frequency_hz,
             rules::building_frequency_hz, in.describes() ? Absent::omitted : Absent::error);
    in.value({"damping_ratio", "of each of its modes, over critical"}, building.damping_ratio, rules::damping_ratio,
             Absent::standard);
    in.value({"height_ratio", "of the floor over that of the building"}, building.height_ratio, rules::height_ratio,
             in.describes() ? Absent::omitted : Absent::error);
  }
  in.value({"modes",
            "their number; or, in place of the keys above, a list of modes: frequency_hz, damping_ratio, and factor, "
            "the participation factor times the shape at the floor"},
           building, modes_type(), Absent::standard);
}

/// What a table says of a record that it selects. Returns the factor on its accelerations.
double keys_of_selection(FieldVisitor& in, Recorded& recorded) {
  const auto number = [&in](const Key& key, std::optional<double>& value, const Rule& rule) {
    in.optional(key.name, value, [&](double& found) { in.value(key, found, rule, Absent::omitted); });
  };
  std::optional<double> factor;
  number({"factor", "of a record as a table selects it, which scale multiplies"}, factor, rules::selected_number);
  number({"level", "of intensity, of a record that is selected for one"}, recorded.level, rules::selected_number);
  number({"return_period_years", "of the level, in its place [years]"}, recorded.return_period, rules::selected_number);
  number({"magnitude", "of the earthquake of the record"}, recorded.magnitude, rules::magnitude);
  number({"distance_km", "from the station to the rupture [km]"}, recorded.distance_km, rules::selected_number);
  return factor.value_or(1.0);
}

void keys_of(FieldVisitor& in, Recorded& recorded, const dynamics::Block& block, RecordFields& records) {
  refuse_keys_of_others(in, recorded);
  if (!records.suite(
          in, {"suite", "several ground motions, each a point of the sweep: a pattern or a list, in place of file"})) {
    return;
  }
  const bool block_is_sound = block.width > 0.0 && block.height > 0.0 && block.gravity > 0.0;
  GroundMotionReading how{.gravity = block_is_sound ? block.gravity : 1.0};
  const auto is_sound = [&in](const auto& part) {
    const std::size_t problems_before = in.problem_count();
    part();
    return in.problem_count() == problems_before;
  };
  records.file(in, {"file", "path of the record, seen from the folder of the experiment file"},
               {"sha256", "of the file; must match it; absent: the file's"}, how.name);
  if (in.stands("vertical_file", true)) {
    records.file(in, {"vertical_file", "of the vertical component, in formats with one component a file"},
                 {"vertical_sha256", "of that file; must match it; absent: the file's"}, how.vertical_name);
    if (how.vertical_name.empty()) how.name.clear();
  }
  if (!is_sound([&] { keys_of_format_and_unit(in, how, records); })) how.name.clear();
  QuantityInUnit strength{.unit = 0, .value = recorded.scale};
  std::vector<double> periods;
  const bool has_strength = is_sound([&] {
    one_of(in, strength_units, strength, Absent::standard);
    periods = keys_of_periods(in, strength_units[strength.unit].key.name, block_is_sound ? &block : nullptr);
  });
  const double factor = keys_of_selection(in, recorded);
  if (strength.unit == 0 && factor != 1.0) {
    auto* const number = std::get_if<double>(&strength.value);
    strength.value = number != nullptr ? Quantity(*number * factor) : divided(strength.value, 1.0 / factor);
  }
  const bool has_times = is_sound([&] {
    in.optional("time_step_s", how.time_step, [&in](double& time_step) {
      in.value({"time_step_s",
                "between samples [s], of columns without times; absent: the file gives it, or the time of each sample"},
               time_step, rules::time_step, Absent::omitted);
    });
    keys_of_columns(in, how);
  });
  if (!has_times) how.name.clear();
  if (in.is_reading()) recorded.frequency_ratio = block_is_sound ? strobe_once_a_second(block) : 1.0;
  in.optional("building", recorded.building, [&in](Building& building) {
    in.object({"building", "on a floor of which the block stands, a linear one; absent: on the ground"},
              Absent::omitted, [&building](FieldVisitor& keys) { keys_of(keys, building); });
  });
  in.value({"frequency_ratio", "of the strobe; absent: a strobe period of the mean block is a second"},
           recorded.frequency_ratio, rules::frequency_ratio, in.follows_from({"/block", "/excitation/kind"}));
  if (strength.unit == 0) recorded.scale = strength.value;
  std::optional<Strength> wanted;
  if (has_strength && block_is_sound) {
    wanted.emplace(Strength{strength_units[strength.unit].key.name, strength.value, std::move(periods)});
  }
  records.ground_motion(in, how, wanted, recorded);
}

/// Omega_v/Omega_h. One that is a whole number n, or 1/n, up to the rounding of units counts as that number: its cycles
/// are counted without loss then.
void set_ratio(double ratio, dynamics::VerticalSine& sine) {
  constexpr double rounding = 0x1p-48;
  const auto whole = [](double number) {
    const double nearest = std::round(number);
    return nearest >= 1.0 && std::abs(number - nearest) <= rounding * nearest ? nearest : 0.0;
  };
  if (const double cycles = whole(ratio); cycles > 0.0) {
    sine.cycles = cycles;
  } else if (const double periods = whole(1.0 / ratio); periods > 0.0) {
    sine.periods = periods;
  } else {
    sine.cycles = ratio;
  }
}

void keys_of(FieldVisitor& in, Pulse& pulse, const dynamics::Block&, RecordFields&) {
  for (const std::string_view key : {"file", "suite", "sha256", "time_step_s"}) {
    in.refuse(key, "is for a ground motion; a pulse is given by its shape", "write \"kind\": \"recorded\", or omit it");
  }
  in.refuse("scale", "is for a ground motion; a pulse has an amplitude", "write \"amplitude\" instead");
  in.refuse("vertical", "is for harmonic excitation", "omit it, or write \"kind\": \"harmonic\"");
  refuse_building(in);
  const std::size_t problems_before = in.problem_count();
  in.choice({"shape",
             "f, of length 2 pi/Omega_h for sine and cosine, half of it for half_sine, rectangle and triangle; ricker, "
             "second derivative of a Gaussian, cut below 1e-6 of its peak; type_c, C_n of Makris (1997); or the pulse "
             "of Mavroeidis and Papageorgiou (2003), whose A_h is that of omega times its velocity amplitude"},
            pulse.shape, pulse_shapes, Absent::error);
  const bool is_known = in.problem_count() == problems_before;
  keys_of_amplitude_and_frequency(in, pulse, amplitude_units, frequency_units);
  const auto number = [&](const Key& key, double& value, const Rule& rule, bool has_it, Absent absent,
                          std::string_view refusal) {
    if (in.describes() || has_it) return in.value(key, value, rule, in.describes() ? Absent::omitted : absent);
    if (in.found(key.name) != nullptr && is_known) in.reject(key.name, {std::string(refusal), "omit it"});
  };
  using enum dynamics::PulseShape;
  const bool is_mavroeidis = pulse.shape == mavroeidis_papageorgiou;
  number({"phase_rad", "of sine, cosine and mavroeidis_papageorgiou (nu): in their argument [rad]; absent: 0"},
         pulse.phase_of_shape, rules::phase, is_mavroeidis || pulse.shape == sine || pulse.shape == cosine,
         Absent::omitted, "is for the shapes sine, cosine and mavroeidis_papageorgiou; this one has no phase");
  number({"cycles", "n of type_c, a whole number; gamma of mavroeidis_papageorgiou; required by both"}, pulse.cycles,
         rules::cycles, is_mavroeidis || pulse.shape == type_c, Absent::error,
         "is for the shapes type_c and mavroeidis_papageorgiou");
}

}  // namespace

dynamics::VerticalSine Harmonic::vertical_sine(const dynamics::Geometry& own, double gravity) const {
  if (!vertical) return {};
  const auto& [amplitude_v, ratio_v, phase_v, physical_amplitude_v, physical_frequency_v] = *vertical;
  dynamics::VerticalSine sine{.amplitude = mean_of(amplitude_v) * own.shape_angle, .phase = mean_of(phase_v)};
  if (physical_amplitude_v) {
    const bool in_g = physical_amplitude_v->unit == AccelerationUnit::gravity;
    sine.amplitude = mean_of(physical_amplitude_v->value) / (in_g ? 1.0 : gravity);
  }
  const double frequency =
      physical_frequency_v ? rocking::frequency_ratio(*physical_frequency_v, own) : mean_of(ratio_v);
  set_ratio(frequency / frequency_ratio_for(own, own), sine);
  return sine;
}

dynamics::Excitation Harmonic::motion(const dynamics::Geometry&, const dynamics::Clock& clock,
                                      const DrawnShaking& drawn) const {
  if (vertical) return dynamics::HarmonicExcitation<true>(drawn.vertical, clock);
  return dynamics::HarmonicExcitation<false>();
}

dynamics::Excitation Recorded::motion(const dynamics::Geometry& block, const dynamics::Clock& clock,
                                      const DrawnShaking& drawn) const {
  const auto on_clock = [&](const std::vector<dynamics::GroundMotionSample>& samples) {
    return std::make_shared<const dynamics::NormalisedGroundMotion>(samples, block.frequency_parameter, clock);
  };
  const auto& ground = ground_motion->samples;
  const auto knots = on_clock(drawn.building ? floor_motion(ground, *drawn.building) : ground);
  if (ground_motion->has_vertical) return dynamics::RecordedExcitation<true>(knots, drawn.size);
  return dynamics::RecordedExcitation<false>(knots, drawn.size);
}

dynamics::Excitation Pulse::motion(const dynamics::Geometry& block, const dynamics::Clock& clock,
                                   const DrawnShaking&) const {
  const bool is_triangle = shape == dynamics::PulseShape::triangle;
  if (!is_triangle && shape != dynamics::PulseShape::rectangle) return dynamics::PulseExcitation(form(), clock);
  const double peak = block.shape_angle, end = dynamics::pulse_length(form()) * clock.period_length();
  using Corners = std::vector<dynamics::GroundMotionSample>;
  const Corners corners = is_triangle ? Corners{{0.0, 0.0, 0.0}, {0.5 * end, peak, 0.0}, {end, 0.0, 0.0}}
                                      : Corners{{0.0, peak, 0.0}, {end, peak, 0.0}};
  return dynamics::RecordedExcitation<false>(
      std::make_shared<const dynamics::NormalisedGroundMotion>(corners, 1.0, clock), 1.0);
}

void keys_of(FieldVisitor& in, Excitation& excitation, const dynamics::Block& block, RecordFields& records) {
  in.kinds({"kind",
            "harmonic: a_h/g = A_h psi times the sine of Omega_h tau + Phi; recorded: linear between the samples of a "
            "file; pulse: from tau = 0 on one pulse a_h/g = A_h psi f(Omega_h tau), the base is still after it"},
           kind_names, excitation.index(), [&](FieldVisitor& keys, std::size_t kind) {
             if (excitation.index() != kind) excitation = alternative_at<Excitation>(kind);
             std::visit([&](auto& asked) { keys_of(keys, asked, block, records); }, excitation);
           });
}

}  // namespace rocking

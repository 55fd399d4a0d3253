#include "rocking/output/shaking_text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr int digits_of_a_cell = 4;

const ShakingNumber& entry_of(std::string_view key) {
  const auto found = std::ranges::find(shaking_numbers, key, &ShakingNumber::key);
  ROCKING_EXPECT(found != shaking_numbers.end());
  return *found;
}

bool is_swept(const std::vector<std::string>& swept, std::string_view key) {
  return std::ranges::find(swept, "/excitation/" + std::string(key)) != swept.end();
}

bool differs(Shakings shakings, std::string_view key) {
  return std::ranges::any_of(shakings, [&](const std::optional<Shaking>& shaking) {
    if (!shaking || !shakings.front()) return shaking.has_value() != shakings.front().has_value();
    return number_of(*shaking, key) != number_of(*shakings.front(), key);
  });
}

using Given = std::array<std::string, 2>;

Given given_of(const Shaking& shaking) {
  return {std::string(shaking.given_amplitude), std::string(shaking.given_frequency)};
}

void set_given(const Given& read, const ReadingPlace& place, Shaking& shaking) {
  constexpr std::size_t amplitudes = shaking_numbers.size() / 2;
  const auto key_among = [&](std::size_t first, const std::string& name, std::string_view& key) {
    const ShakingNumber* const begin = shaking_numbers.data() + first;
    const auto* const found =
        std::find_if(begin, begin + amplitudes, [&](const auto& each) { return each.key == name; });
    if (found == begin + amplitudes) return place.reject(Json(name), "is not the key of an amplitude or a frequency");
    key = found->key;
  };
  key_among(0, read[0], shaking.given_amplitude);
  key_among(amplitudes, read[1], shaking.given_frequency);
}

using GivenType = ConvertedType<Shaking, Given, given_of, set_given>;

}  // namespace

bool is_amplitude(std::string_view key) { return key.starts_with("amplitude"); }

std::string_view other_form_of(std::string_view key) {
  if (key == "amplitude") return "amplitude_g";
  if (key == "frequency_ratio") return "frequency_hz";
  return is_amplitude(key) ? "amplitude" : "frequency_ratio";
}

double number_of(const Shaking& shaking, std::string_view key) { return shaking.*entry_of(key).number; }

std::string in_unit(std::string_view key, const std::string& number) {
  if (key == "amplitude") return "A_h " + number;
  if (key == "frequency_ratio") return "Omega_h " + number;
  if (key == "amplitude_g") return number + " g";
  if (key == "amplitude_m_s2") return number + " m/s^2";
  return number + (key == "frequency_hz" ? " Hz" : " s");
}

std::string in_both_forms(const Shaking& shaking, std::string_view given_key) {
  const std::string_view other = other_form_of(given_key);
  return in_unit(given_key, significant(number_of(shaking, given_key), 6)) + " = " +
         in_unit(other, significant(number_of(shaking, other), 3));
}

std::vector<std::string_view> shown_forms(Shakings shakings) {
  std::vector<std::string_view> keys;
  for (const auto given : {&Shaking::given_amplitude, &Shaking::given_frequency}) {
    for (const auto& shaking : shakings) {
      if (!shaking) continue;
      for (const std::string_view key : {(*shaking).*given, other_form_of((*shaking).*given)}) {
        if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
      }
    }
  }
  return keys;
}

std::vector<std::string_view> shaking_columns(const std::vector<std::string>& swept, Shakings shakings) {
  std::vector<std::string_view> keys = shown_forms(shakings);
  std::erase_if(keys, [&](std::string_view key) { return is_swept(swept, key) || !differs(shakings, key); });
  return keys;
}

std::string common_shaking(const std::vector<std::string>& swept, Shakings shakings) {
  std::array<std::string, 2> forms;  // of the amplitude, of the frequency
  for (const std::string_view key : shown_forms(shakings)) {
    if (is_swept(swept, key) || differs(shakings, key)) continue;
    std::string& form = forms[is_amplitude(key) ? 0 : 1];
    const int shown_digits = form.empty() ? 6 : 3;
    form += (form.empty() ? "" : " = ") + in_unit(key, significant(number_of(*shakings.front(), key), shown_digits));
  }
  std::string text;
  for (const auto& [form, is_drawn] :
       {std::pair(forms[0], &Shaking::has_drawn_amplitude), std::pair(forms[1], &Shaking::has_drawn_frequency)}) {
    if (form.empty()) continue;
    const bool is_mean =
        std::ranges::any_of(shakings, [drawn = is_drawn](const auto& each) { return each && (*each).*drawn; });
    text += (text.empty() ? "" : ", ") + form + (is_mean ? " (mean of what is drawn)" : "");
  }
  const auto& vertical = shakings.front() ? shakings.front()->vertical : std::nullopt;
  const bool is_common = vertical && std::ranges::all_of(shakings, [&](const std::optional<Shaking>& shaking) {
                           return shaking && shaking->vertical == vertical;
                         });
  if (!is_common) return text;
  return text + (text.empty() ? "" : ", ") + "vertically " + significant(vertical->amplitude_g, 3) + " g, " +
         significant(vertical->frequency_hz, 3) + " Hz, phase " + significant(vertical->phase_rad, 3) + " rad";
}

std::string column_cell(const std::optional<Shaking>& shaking, std::string_view key) {
  return shaking ? significant(number_of(*shaking, key), digits_of_a_cell) : ".";
}

const StructType& fields_of(const VerticalShaking*) {
  static const StructType fields{
      "VerticalShaking",
      field<&VerticalShaking::amplitude_g>("amplitude_g", "peak acceleration over gravity", rule::not_negative),
      field<&VerticalShaking::frequency_hz>("frequency_hz", "[Hz]", rule::not_negative),
      field<&VerticalShaking::phase_rad>("phase_rad", "at the start of the run"),
  };
  return fields;
}

const StructType& fields_of(const Shaking*) {
  static const StructType fields{
      "Shaking",
      of_owner<Shaking>("given", "keys of the experiment: of the amplitude, of the frequency", the_only<GivenType>()),
      field<&Shaking::amplitude>("amplitude", "A_h", rule::not_negative),
      field<&Shaking::amplitude_g>("amplitude_g", "peak acceleration over gravity", rule::not_negative),
      field<&Shaking::amplitude_m_s2>("amplitude_m_s2", "peak acceleration [m/s^2]", rule::not_negative),
      field<&Shaking::frequency_ratio>("frequency_ratio", "Omega_h", rule::not_negative),
      field<&Shaking::frequency_hz>("frequency_hz", "[Hz]", rule::not_negative),
      field<&Shaking::period_s>("period_s", "[s]", rule::not_negative),
      field<&Shaking::vertical>("vertical", "vertical sine beside it; omitted without one", rule::none,
                                WithoutValue::omitted),
  };
  return fields;
}

std::vector<std::optional<Shaking>> shakings_of(const Report& report) {
  std::vector<std::optional<Shaking>> shakings;
  for (const ReportedCondition& each : report.conditions) {
    shakings.push_back(each.shaking ? shaking_of(each.asked.scene) : std::nullopt);
  }
  return shakings;
}

std::string impacts_text(const Report& report) {
  RateRatios ratios;
  for (const ReportedCondition& condition : report.conditions) ratios.add(condition.asked.scene);
  return ratios.text();
}

}  // namespace rocking

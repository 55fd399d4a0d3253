#include "rocking/output/shaking_text.hpp"

#include <algorithm>
#include <array>

#include "rocking/base/error.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr int digits_of_a_cell = 4;

const ShakingNumber& entry_of(std::string_view key) {
  const auto* const found = std::ranges::find(shaking_numbers, key, &ShakingNumber::key);
  ROCKING_EXPECT(found != shaking_numbers.end());
  return *found;
}

bool is_amplitude(std::string_view key) { return key.starts_with("amplitude"); }

bool is_swept(const std::vector<std::string>& swept, std::string_view key) {
  return std::ranges::find(swept, "/excitation/" + std::string(key)) != swept.end();
}

bool differs(Shakings shakings, std::string_view key) {
  return std::ranges::any_of(shakings, [&](const std::optional<Shaking>& shaking) {
    if (!shaking || !shakings.front()) return shaking.has_value() != shakings.front().has_value();
    return number_of(*shaking, key) != number_of(*shakings.front(), key);
  });
}

}  // namespace

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
  std::string text;
  bool follows_amplitude = false;
  for (const std::string_view key : shown_forms(shakings)) {
    if (is_swept(swept, key) || differs(shakings, key)) continue;
    const bool is_other = !text.empty() && follows_amplitude == is_amplitude(key);
    text += (text.empty() ? ""
             : is_other   ? " = "
                          : ", ") +
            in_unit(key, significant(number_of(*shakings.front(), key), is_other ? 3 : 6));
    follows_amplitude = is_amplitude(key);
  }
  return text;
}

std::string column_cell(const std::optional<Shaking>& shaking, std::string_view key) {
  return shaking ? significant(number_of(*shaking, key), digits_of_a_cell) : ".";
}

}  // namespace rocking

#include "rocking/output/shaking_fields.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"

namespace rocking {
namespace {

using Given = std::array<std::string, 2>;

Given given_of(const Shaking& shaking) {
  return {std::string(shaking.given_amplitude), std::string(shaking.given_frequency)};
}

void set_given(const Given& read, const ReadingPlace& place, Shaking& shaking) {
  constexpr std::size_t amplitudes = shaking_numbers.size() / 2;
  const auto key_among = [&](std::size_t first, const std::string& name, std::string_view& key) {
    const auto* const begin = shaking_numbers.begin() + first;
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
  };
  return fields;
}

}  // namespace rocking

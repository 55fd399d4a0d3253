#include "rocking/scene/ground_motion_reading.hpp"

namespace rocking {

std::string record_units_in_words() {
  std::string words;
  for (const std::string_view name : record_unit_names) {
    if (!words.empty()) words += name == record_unit_names.back() ? " or " : ", ";
    words += name;
  }
  return words;
}

}  // namespace rocking

#include "rocking/scene/ground_motion_reading.hpp"

#include <algorithm>

namespace rocking {

std::string record_units_in_words() {
  std::string words;
  for (const std::string_view name : record_unit_names) {
    if (!words.empty()) words += name == record_unit_names.back() ? " or " : ", ";
    words += name;
  }
  return words;
}

std::optional<Refusal> refuse_columns(const std::vector<RecordColumn>& columns, bool has_time_step) {
  const auto count = [&columns](RecordColumn column) { return std::ranges::count(columns, column); };
  if (count(RecordColumn::horizontal) != 1) {
    return Refusal{"must name the horizontal component once", R"(give, for example, ["time", "horizontal"])"};
  }
  if (count(RecordColumn::vertical) > 1 || count(RecordColumn::time) > 1) {
    return Refusal{"names a column twice", R"(call the columns that are not to be used "other")"};
  }
  const bool has_times = count(RecordColumn::time) == 1;
  if (has_times == has_time_step) {
    return has_times
               ? Refusal{"has a column of times beside a time step",
                         R"(omit the time step, or call the column "other" to use the time step)"}
               : Refusal{"has no column of times, and there is no time step", R"(name "time", or give the time step)"};
  }
  return std::nullopt;
}

}  // namespace rocking

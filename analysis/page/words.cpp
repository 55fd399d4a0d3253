#include "analysis/page/words.hpp"

#include <array>

#include "analysis/sweep_view.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string spoken(int number) {
  constexpr std::array<const char*, 13> words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                                              "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  const auto place = static_cast<std::size_t>(number);
  return place < words.size() ? words[place] : std::to_string(number);
}

std::string times(int number) { return number == 1 ? "once" : number == 2 ? "twice" : spoken(number) + " times"; }

}  // namespace

std::string probability_text(double probability, const stats::Interval& interval) {
  return per_cent(probability) + " % " + per_cent(interval);
}

std::string meaning_of(const section::ResponseMode& mode) {
  switch (mode.kind) {
    case section::ResponseKind::periodic:
      if (mode.periods == 1) return "rocks " + times(mode.rocks) + " in every period";
      return "rocks " + times(mode.rocks) + " in " + spoken(mode.periods) + " periods";
    case section::ResponseKind::chaotic: return "never repeats";
    case section::ResponseKind::overturned: return "overturns";
    case section::ResponseKind::rest: return "does not rock, or has stopped rocking";
    case section::ResponseKind::unresolved: return "could not be classified";
  }
  return "";
}

std::string condition_name(const RunReport& report, std::size_t condition) {
  const std::string name = name_of_condition(report, report.conditions[condition]);
  return name.empty() ? "the only condition" : name;
}

}  // namespace rocking::analysis

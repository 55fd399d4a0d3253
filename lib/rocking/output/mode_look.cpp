#include "rocking/output/mode_look.hpp"

#include <array>
#include <cstddef>

namespace rocking {
namespace {

using section::ResponseKind;

constexpr std::array<ModeLook, 5> looks_of_others{
    {{"#f0e442", 2, 6, 4}, {"#7f5fc7", 4, 8, 5}, {"#8c564b", 5, 3, 1}, {"#17a2a2", 2, 15, 6}, {"#7a7a00", 4, 14, 7}}};

ModeLook look_of_periodic(const section::ResponseMode& mode) {
  if (mode.rocks == 1) {
    switch (mode.periods) {
      case 1: return {"#0072b2", 1, 7, 0};
      case 2: return {"#009e73", 4, 5, 5};
      case 3: return {"#d55e00", 2, 9, 4};
      case 4: return {"#56b4e9", 5, 11, 1};
      case 5: return {"#e69f00", 3, 13, 6};
      default: break;
    }
  }
  return looks_of_others[static_cast<std::size_t>(mode.rocks * 3 + mode.periods) % looks_of_others.size()];
}

std::string in_words(int number) {
  constexpr std::array<const char*, 13> words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                                              "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  const auto place = static_cast<std::size_t>(number);
  return place < words.size() ? words[place] : std::to_string(number);
}

std::string times(int number) { return number == 1 ? "once" : number == 2 ? "twice" : in_words(number) + " times"; }

}  // namespace

std::string meaning_of(const section::ResponseMode& mode) {
  if (mode.kind != section::ResponseKind::periodic) return std::string(section::meaning_of(mode.kind));
  if (mode.periods == 1) return "rocks " + times(mode.rocks) + " in every period";
  return "rocks " + times(mode.rocks) + " in " + in_words(mode.periods) + " periods";
}

ModeLook look_of(const section::ResponseMode& mode) {
  switch (mode.kind) {
    case ResponseKind::periodic: return look_of_periodic(mode);
    case ResponseKind::quasi_periodic: return {"#332288", 2, 12, 3};
    case ResponseKind::chaotic: return {"#cc79a7", 3, 2, 2};
    case ResponseKind::overturned: return {"#000000", 1, 10, 0};
    case ResponseKind::slide: return {"#d2b48c", 4, 3, 1};
    case ResponseKind::rest: return {"#b4b4b4", 5, 4, 0};
    case ResponseKind::unresolved: break;
  }
  return {"#f0f0f0", 3, 1, 5};
}

}  // namespace rocking

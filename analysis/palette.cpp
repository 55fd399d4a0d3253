#include "analysis/palette.hpp"

#include <array>

namespace rocking::analysis {
namespace {

using section::ResponseKind;
using section::ResponseMode;

struct Look {
  const char* colour;
  int dash;
  int marker;
  int hatch;
};

namespace look {

constexpr Look harmonic{"#0072b2", 1, 7, 0};
constexpr Look third{"#d55e00", 2, 9, 4};
constexpr Look second{"#009e73", 4, 5, 5};
constexpr Look fourth{"#56b4e9", 5, 11, 1};
constexpr Look fifth{"#e69f00", 3, 13, 6};
constexpr Look chaotic{"#cc79a7", 3, 2, 2};
constexpr Look overturned{"#000000", 1, 10, 0};
constexpr Look rest{"#b4b4b4", 5, 4, 0};
constexpr Look unresolved{"#f0f0f0", 3, 1, 5};
constexpr Look others{"#8c8c8c", 4, 12, 1};
constexpr std::array<Look, 5> more{
    {{"#f0e442", 2, 6, 4}, {"#7f5fc7", 4, 8, 5}, {"#8c564b", 5, 3, 1}, {"#17a2a2", 2, 15, 6}, {"#7a7a00", 4, 14, 7}}};

}  // namespace look

Style style_from(const Look& look) {
  return {.colour = look.colour, .dash = look.dash, .marker = look.marker, .hatch = look.hatch};
}

Look look_of_periodic(const ResponseMode& mode) {
  if (mode.rocks == 1) {
    switch (mode.periods) {
      case 1: return look::harmonic;
      case 2: return look::second;
      case 3: return look::third;
      case 4: return look::fourth;
      case 5: return look::fifth;
      default: break;
    }
  }
  return look::more[static_cast<std::size_t>(mode.rocks * 3 + mode.periods) % look::more.size()];
}

}  // namespace

Style style_of(const ResponseMode& mode) {
  switch (mode.kind) {
    case ResponseKind::periodic: return style_from(look_of_periodic(mode));
    case ResponseKind::chaotic: return style_from(look::chaotic);
    case ResponseKind::overturned: return style_from(look::overturned);
    case ResponseKind::rest: return style_from(look::rest);
    case ResponseKind::unresolved: break;
  }
  return style_from(look::unresolved);
}

Style style_of_others() { return style_from(look::others); }

Style style_of_contact(std::string_view contact) {
  if (contact == "slide") return {.colour = "#56b4e9", .hatch = 4, .opacity = 0.45};
  if (contact == "rock_slide") return {.colour = "#e69f00", .hatch = 5, .opacity = 0.45};
  if (contact == "rest") return {.colour = "#c8c8c8", .opacity = 0.6};
  if (contact == "overturned") return {.colour = "#000000", .opacity = 0.3};
  return {.colour = "#ffffff"};
}

Style style_of_curve(std::size_t number) {
  constexpr std::array<Look, 7> looks{look::harmonic, look::third, look::second,    look::chaotic,
                                      look::fourth,   look::fifth, look::overturned};
  return style_from(looks[number % looks.size()]);
}

}  // namespace rocking::analysis

#include "rocking/figures/palette.hpp"

#include <array>

#include "rocking/output/mode_look.hpp"

namespace rocking::analysis {
namespace {

using section::periodic;
using section::ResponseKind;
using section::ResponseMode;

Style style_from(const ModeLook& look) {
  return {.colour = look.colour, .dash = look.dash, .marker = look.marker, .hatch = look.hatch};
}

}  // namespace

Style style_of(const ResponseMode& mode) { return style_from(look_of(mode)); }

Style style_of_others() { return style_from({"#8c8c8c", 4, 12, 1}); }

Style style_of_contact(std::string_view contact) {
  if (contact == "slide") return {.colour = "#56b4e9", .hatch = 4, .opacity = 0.45};
  if (contact == "rock_slide") return {.colour = "#e69f00", .hatch = 5, .opacity = 0.45};
  if (contact == "rest") return {.colour = "#c8c8c8", .opacity = 0.6};
  if (contact == "overturned") return {.colour = "#000000", .opacity = 0.3};
  return {.colour = "#ffffff"};
}

Style style_of_curve(std::size_t number) {
  constexpr std::array modes{periodic(1, 1),
                             periodic(1, 3),
                             periodic(1, 2),
                             ResponseMode{.kind = ResponseKind::chaotic},
                             periodic(1, 4),
                             periodic(1, 5),
                             ResponseMode{.kind = ResponseKind::overturned}};
  return style_of(modes[number % modes.size()]);
}

Style ribbon_of(Style style, double opacity) {
  style.hatch = 0;
  style.opacity = opacity;
  return style;
}

}  // namespace rocking::analysis

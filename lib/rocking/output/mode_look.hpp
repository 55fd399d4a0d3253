#pragma once

#include <string>

#include "rocking/section/response_mode.hpp"

namespace rocking {

/// Explains a response mode to a reader who is new to it: `rocks once in three periods`.
[[nodiscard]] std::string meaning_of(const section::ResponseMode& mode);

/// How a response mode is drawn in all figures.
struct ModeLook {
  const char* colour = "";  ///< `#rrggbb`
  int dash = 1;             ///< number of gnuplot's dash type
  int marker = 7;           ///< number of gnuplot's point type
  int hatch = 0;            ///< number of gnuplot's fill pattern; 0: filled
};

/// The look of a response mode. The colours are those of Okabe and Ito (2008), which readers with a colour vision
/// deficiency can distinguish; hatching, dashes and markers distinguish them in grey. Rest, slide, chaotic, overturned,
/// unresolved, (1,1), (1,2), (1,3), (1,4) and (1,5) have distinct looks; other (m,n) share five further ones.
[[nodiscard]] ModeLook look_of(const section::ResponseMode& mode);

}  // namespace rocking

#include "analysis/page/sections.hpp"

#include <fmt/format.h>

#include "analysis/page/html.hpp"

namespace rocking::analysis {
namespace {

struct Limit {
  const char* assumption;
  const char* consequence;
};

constexpr Limit limits[] = {
    {"Two dimensions",
     "The block rocks about two parallel edges. Under shaking in two horizontal directions, or oblique to an edge, a "
     "real block also rolls on a corner and twists, which can change whether it overturns (Chatzis &amp; Smyth 2012b). "
     "For a block whose two widths are similar, the result is a first estimate only."},
    {"One rigid block",
     "The block does not deform. A flexible body, moving parts or contents change uplift and overturning (Acikgoz "
     "&amp; DeJong 2012). Its mass may be anywhere above its base, but must not move."},
    {"Sharp edges",
     "The block turns about ideal edges. Rounded or crushed edges move the pivot inwards, so that the block is less "
     "stable than its width suggests. Give the effective width."},
    {"Level, rigid floor",
     "A soft floor or foundation lets the block rock before an edge lifts, and takes energy from it (Psycharis &amp; "
     "Jennings 1983; Chatzis &amp; Smyth 2012a). A slope makes one direction weaker. The floor moves without "
     "rotation."},
    {"Energy loss at impacts",
     "Apart from friction, energy is lost in impacts only, by default as much as the conservation of angular momentum "
     "requires (Housner 1963). Measured losses differ, and they decide how long a block rocks. Give them as "
     "<code>restitution</code> if they are known."},
    {"Coulomb friction",
     "Friction has a static and a kinetic coefficient. They may fluctuate, but they do not depend on speed, pressure "
     "or wear. Whether a block slides or rocks depends on them (Shenton 1996)."},
    {"No anchorage",
     "No bolts, restrainers, ties or neighbours; a wall is rigid, moves with the floor, holds one side, and the block "
     "does not slide from it. Anchorage is not favourable under every shaking (Makris &amp; Zhang 2001)."},
    {"No flight",
     "An edge always touches the floor. A block that hops or bounces is outside the model (Ishiyama 1982); "
     "realisations in which the contact force vanishes are counted in the checks."},
};

constexpr const char* references[] = {
    "Acikgoz, S. & DeJong, M. J. (2012). The interaction of elasticity and rocking in flexible structures allowed to "
    "uplift. Earthq. Eng. Struct. Dyn. 41(15), 2177-2194.",
    "Chatzis, M. N. & Smyth, A. W. (2012a). Robust modeling of the rocking problem. J. Eng. Mech. 138(3), 247-262.",
    "Chatzis, M. N. & Smyth, A. W. (2012b). Modeling of the 3D rocking problem. Int. J. Non-Linear Mech. 47(4), 85-98.",
    "Housner, G. W. (1963). The behavior of inverted pendulum structures during earthquakes. Bull. Seismol. Soc. Am. "
    "53(2), 403-417.",
    "Ishiyama, Y. (1982). Motions of rigid bodies and criteria for overturning by earthquake excitations. Earthq. Eng. "
    "Struct. Dyn. 10(5), 635-650.",
    "Makris, N. & Zhang, J. (2001). Rocking response of anchored blocks under pulse-type motions. J. Eng. Mech. "
    "127(5), 484-493.",
    "Psycharis, I. N. & Jennings, P. C. (1983). Rocking of slender rigid bodies allowed to uplift. Earthq. Eng. "
    "Struct. Dyn. 11(1), 57-76.",
    "Shenton, H. W. (1996). Criteria for initiation of slide, rock, and slide-rock rigid-body modes. J. Eng. Mech. "
    "122(7), 690-693.",
    "Yim, C.-S., Chopra, A. K. & Penzien, J. (1980). Rocking response of rigid blocks to earthquakes. Earthq. Eng. "
    "Struct. Dyn. 8(6), 565-587.",
    "Zhang, J. & Makris, N. (2001). Rocking response of free-standing blocks under cycloidal pulses. J. Eng. Mech. "
    "127(5), 473-483.",
};

}  // namespace

std::string limits_html() {
  std::string rows;
  for (const Limit& limit : limits) {
    rows += fmt::format("<dt>{}</dt><dd>{}</dd>\n", limit.assumption, limit.consequence);
  }
  std::string sources;
  for (const char* reference : references) sources += fmt::format("<li>{}</li>\n", escaped(reference));
  return fmt::format(
      "<p>The intervals on this page cover the chance of the random numbers only, not the difference between the model "
      "and a real block. A single response is very sensitive to details of the ground motion, so that only "
      "probabilities over many ground motions describe a site (Yim, Chopra &amp; Penzien 1980; Zhang &amp; Makris "
      "2001).</p>\n<dl class=\"limits\">\n{}</dl>\n<details><summary>Literature</summary>\n<ul>\n{}</ul></details>\n",
      rows, sources);
}

}  // namespace rocking::analysis

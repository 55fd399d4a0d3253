#include "analysis/page/sections.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace rocking::analysis {
namespace {

using section::ResponseKind;

/// Places in the drawing.
struct Sheet {
  double width = 150.0;
  double height = 46.0;
  double middle = 17.0;  ///< height of zero tilt
  double reach = 14.0;   ///< largest tilt
  double base = 40.0;    ///< height of zero base acceleration
  double swing = 4.0;    ///< amplitude of the base acceleration
};
constexpr Sheet sheet;

/// Half of a rock: the block leaves the floor on one side and comes back.
struct Arc {
  double length;  ///< in periods of the excitation
  double top;     ///< over the largest tilt; the sign is the side
};

/// Arcs on alternating sides.
std::vector<Arc> arcs_of(const std::vector<double>& lengths, const std::vector<double>& tops) {
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    arcs.push_back({.length = lengths[i], .top = (i % 2 == 0 ? 1.0 : -1.0) * tops[i]});
  }
  return arcs;
}

/// At least four periods of a response that rocks m times in n periods. Rocks of one cycle differ in height, so that
/// the cycle is visible.
std::vector<Arc> periodic_arcs(int rocks, int periods) {
  std::vector<Arc> arcs;
  const double half = 0.5 * periods / rocks;
  const int cycles = std::max(2, (4 + periods - 1) / periods);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (int rock = 0; rock < rocks; ++rock) {
      const double top = 1.0 - 0.55 * rock / rocks;
      arcs.push_back({.length = half, .top = top});
      arcs.push_back({.length = half, .top = -top});
    }
  }
  return arcs;
}

/// None: the mode has no sketch.
std::vector<Arc> arcs_of(const section::ResponseMode& mode) {
  const std::vector<Arc> flat{{.length = 4.0, .top = 0.0}};
  switch (mode.kind) {
    case ResponseKind::periodic: return mode.rocks > 0 ? periodic_arcs(mode.rocks, mode.periods) : flat;
    case ResponseKind::quasi_periodic:
      return arcs_of({0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, {0.9, 0.75, 0.5, 0.4, 0.55, 0.8, 0.9, 0.7, 0.45});
    case ResponseKind::chaotic:
      return arcs_of({0.5, 0.7, 0.4, 0.9, 1.1, 0.5, 0.6, 0.4, 0.9}, {0.5, 0.75, 0.35, 0.9, 1.0, 0.4, 0.7, 0.3, 0.85});
    case ResponseKind::overturned: return arcs_of({0.4, 0.5, 0.6, 0.75, 0.9, 1.6}, {0.12, 0.18, 0.27, 0.4, 0.55, 0.0});
    case ResponseKind::rest: return arcs_of({0.6, 0.5, 0.4, 0.3, 2.2}, {0.5, 0.35, 0.2, 0.1, 0.0});
    case ResponseKind::slide: return flat;
    case ResponseKind::unresolved: break;
  }
  return {};
}

/// Parabolas, as quadratic Bezier curves; the last arc of an overturning leaves the drawing instead.
std::string tilt_path(const std::vector<Arc>& arcs, double scale, bool overturns) {
  std::string path = fmt::format("M0 {}", sheet.middle);
  double x = 0.0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const double end = x + scale * arcs[i].length;
    if (overturns && i + 1 == arcs.size()) {
      path += fmt::format("Q{:.1f} {:.1f} {:.1f} {:.1f}", x + 0.65 * (end - x), sheet.middle + 0.4 * sheet.reach, end,
                          sheet.middle + 1.25 * sheet.reach);
    } else {
      path += fmt::format("Q{:.1f} {:.1f} {:.1f} {}", 0.5 * (x + end), sheet.middle - 2.0 * sheet.reach * arcs[i].top,
                          end, sheet.middle);
    }
    x = end;
  }
  return path;
}

/// A sine, with one quadratic curve for each half period.
std::string base_path(double periods, double scale) {
  std::string path = fmt::format("M0 {}", sheet.base);
  for (int half = 0; 0.5 * half < periods - 1e-9; ++half) {
    const double x = scale * 0.5 * half;
    const double way = half % 2 == 0 ? -1.0 : 1.0;
    path += fmt::format("Q{:.1f} {:.1f} {:.1f} {}", x + 0.25 * scale, sheet.base + 2.0 * way * sheet.swing,
                        x + 0.5 * scale, sheet.base);
  }
  return path;
}

}  // namespace

std::string mode_drawing(const section::ResponseMode& mode) {
  const std::vector<Arc> arcs = arcs_of(mode);
  if (arcs.empty()) return "";
  double periods = 0.0;
  for (const Arc& arc : arcs) periods += arc.length;
  const double scale = sheet.width / periods;
  return fmt::format(
      "<svg class=\"mode\" viewBox=\"-2 0 {0} {1}\" aria-hidden=\"true\"><path class=\"axis\" d=\"M0 {2}H{3}\"/><path "
      "class=\"base\" d=\"{4}\"/><path class=\"tilt\" d=\"{5}\"/></svg>",
      sheet.width + 4.0, sheet.height, sheet.middle, sheet.width, base_path(periods, scale),
      tilt_path(arcs, scale, mode.kind == ResponseKind::overturned));
}

}  // namespace rocking::analysis

#include "analysis/page/animation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Time in the unit in which the motion is shown.
double shown_time(const Animation& motion, double time) { return motion.period > 0.0 ? time / motion.period : time; }

std::string shown_part(const Animation& motion) {
  const char* unit = motion.period > 0.0 ? "periods of the excitation" : "seconds";
  return fmt::format("{} to {} of {} {}", significant(shown_time(motion, motion.samples.front().time), 5),
                     significant(shown_time(motion, motion.samples.back().time), 5),
                     significant(shown_time(motion, motion.length), 5), unit);
}

/// The tilt against time.
std::string still(const Animation& motion) {
  constexpr double width = 600.0;
  constexpr double height = 90.0;
  const auto& samples = motion.samples;
  double most = 1e-9;
  for (const MotionSample& sample : samples) most = std::max(most, std::abs(sample.tilt));
  const double start = samples.front().time;
  const double length = samples.back().time - start;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / 1200);
  std::string points;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", width * (samples[i].time - start) / length,
                          height * (0.5 - 0.47 * samples[i].tilt / most));
  }
  return fmt::format(
      "<div class=\"still\"><p>{0}: tilt against time, {1}; largest tilt {2} of the angle of balance.</p>\n<svg "
      "viewBox=\"0 0 {3} {4}\" role=\"img\" aria-label=\"{0}: tilt against time\"><path class=\"axis\" d=\"M0 "
      "{5}H{3}\"/><polyline class=\"tilt\" points=\"{6}\"/></svg></div>\n",
      escaped(motion.name), shown_part(motion), significant(most, 3), width, height, 0.5 * height, points);
}

}  // namespace

std::string animations_html(const std::vector<Animation>& motions) {
  Json all = Json::array();
  std::size_t samples = 0;
  std::string stills;
  std::string commands;
  for (const Animation& motion : motions) {
    all.push_back(motion_json(motion));
    samples += motion.samples.size();
    stills += still(motion);
    commands += fmt::format("<li>{}, {}: <code>{}</code></li>\n", escaped(motion.name), shown_part(motion),
                            escaped(motion.command));
  }
  const std::string data = json_for_script(all);
  const auto has_sides = [](const Animation& motion) { return motion.shape_angles[0] != motion.shape_angles[1]; };
  const auto is_guessed = [](const Animation& motion) { return !motion.block.is_given; };
  const std::string of_block =
      std::string(std::ranges::any_of(motions, has_sides) ? "&Theta; is the tilt over &psi; of the side on which the "
                                                            "block is: at 1 it is in balance on either side. "
                                                          : "") +
      (std::ranges::any_of(motions, is_guessed) ? "The outline of the block is not known: a rectangle between its "
                                                  "edges, twice as high as its centre of mass. "
                                                : "");
  return fmt::format(
      "<div class=\"motions\" data-motions=\"motions\"></div>\n<script type=\"application/json\" "
      "id=\"data-motions\">{}</script>\n<div class=\"stills\">\n{}</div>\n<p class=\"small\">The block is drawn "
      "relative to the floor; the arrow below the floor is the acceleration of the floor. The motion of the floor is "
      "not drawn. Shaded: sliding (blue), rocking and sliding (yellow), at rest (grey). Tilt, slip and block have one "
      "scale unless a larger factor is chosen; the factor stands in the drawing. {}The drawing takes {} samples, {} kB "
      "of this page. The numbers:</p>\n<ul class=\"small\">\n{}</ul>\n",
      data, stills, of_block, samples, (data.size() + 999) / 1000, commands);
}

std::string animation_page_text(const std::string& title, const Animation& motion) {
  const Frame frame{.title = title.empty() ? "A rocking block" : title, .has_charts = false};
  return framed(frame,
                "<section id=\"motion\" aria-label=\"Animation\">\n" + animations_html({motion}) + "</section>\n");
}

}  // namespace rocking::analysis

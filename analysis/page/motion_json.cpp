// A motion as the script of the page reads it.

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "analysis/page/animation.hpp"

namespace rocking::analysis {
namespace {

/// Rounded so that its text is short. `parts`: of one, a power of ten.
double rounded(double number, double parts) { return std::round(number * parts) / parts + 0.0; }

int place_of(std::string_view contact) {
  constexpr std::array<std::string_view, 5> contacts{"rest", "slide", "rock", "rock_slide", "overturned"};
  return static_cast<int>(std::ranges::find(contacts, contact) - contacts.begin());
}

}  // namespace

Json motion_json(const Animation& motion) {
  const BlockOutline& block = motion.block;
  Json json = {{"name", motion.name},
               {"base", block.base},
               {"extent", {block.left(), block.right(), block.top()}},
               {"rectangles", Json::array()},
               {"centre", {block.centre_x, block.centre_height}},
               {"shapes", motion.shape_angles},
               {"unit", motion.half_diagonal},
               {"period", motion.period},
               {"length", motion.length},
               {"times", Json::array()},
               {"tilts", Json::array()},
               {"rates", Json::array()},
               {"slips", Json::array()},
               {"bases", Json::array()},
               {"contacts", Json::array()}};
  if (block.open_side != 0.0) json["wall"] = block.open_side > 0.0 ? block.right() : block.left();
  for (const auto& [left, right, bottom, top] : block.rectangles)
    json["rectangles"].push_back({left, right, bottom, top});
  for (const MotionSample& sample : motion.samples) {
    json["times"].push_back(rounded(sample.time, 1e4));
    json["tilts"].push_back(rounded(sample.tilt, 1e5));
    json["rates"].push_back(rounded(sample.tilt_rate, 1e4));
    json["slips"].push_back(rounded(sample.slip, 1e6));
    json["bases"].push_back(rounded(sample.base_acceleration, 1e4));
    json["contacts"].push_back(place_of(sample.contact));
  }
  return json;
}

}  // namespace rocking::analysis

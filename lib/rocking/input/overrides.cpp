#include "rocking/input/overrides.hpp"

#include <algorithm>

namespace rocking {
namespace {

void refuse_swept_flag(const Overrides& overrides, const std::vector<SweepAxis>& axes, Problems& problems) {
  if (!overrides.realisations || std::ranges::find(axes, "/realisations", &SweepAxis::pointer) == axes.end()) return;
  problems.push_back(
      {"--realisations", *overrides.realisations, "the sweep of the file sets the realisations", "omit the flag"});
}

}  // namespace

void apply(const Overrides& overrides, Json& document) {
  if (!document.is_object()) return;
  if (overrides.seed) document["seed"] = *overrides.seed;
  if (overrides.realisations) {
    const Json number = Json::parse(*overrides.realisations, nullptr, false);
    document["realisations"] = number.is_number() ? number : Json(*overrides.realisations);
  }
}

void apply(const Overrides& overrides, std::vector<SweepAxis>& axes, Problems& problems) {
  refuse_swept_flag(overrides, axes, problems);
  const auto axis = std::ranges::find_if(axes, [](const SweepAxis& each) {
    return std::ranges::find(all_intensity_pointers, each.pointer) != all_intensity_pointers.end();
  });
  for (const double level : overrides.levels) {
    const auto reject = [&](const char* reason, const char* remedy) {
      problems.push_back({"--levels", Json(level).dump(), reason, remedy});
    };
    if (axis == axes.end()) {
      return reject("needs a sweep of an intensity", "sweep, for example, /excitation/pga_g");
    }
    if (!(level > 0.0)) return reject("must be positive", "give intensities above 0");
    if (!std::ranges::all_of(axis->values, &Json::is_number)) {
      return reject("needs a sweep of numbers", "give the new values in the experiment file");
    }
    if (std::ranges::find(axis->values, Json(level)) != axis->values.end()) {
      return reject("is a level of the run", "omit it");
    }
    axis->evenly_spaced = false;
    const auto place = std::ranges::find_if(axis->values, [level](const Json& value) { return value > level; });
    if (!axis->names.empty()) axis->names.insert(axis->names.begin() + (place - axis->values.begin()), "");
    axis->values.insert(place, level);
  }
}

void name_flags(const Overrides& overrides, Problems& problems) {
  for (base::Problem& problem : problems) {
    if (overrides.seed && problem.place == "/seed") problem.place = "--seed";
    if (overrides.realisations && problem.place == "/realisations") problem.place = "--realisations";
  }
}

}  // namespace rocking

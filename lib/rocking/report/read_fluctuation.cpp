#include <cmath>
#include <string_view>

#include "rocking/report/read_scene.hpp"
#include "rocking/report/rules.hpp"

namespace rocking::report {
namespace {

// How far a source scatters, as written: in the unit of the mean, or as a fraction of it.
struct Scatter {
  double sigma = 0.0;
  double relative_sigma = 0.0;

  [[nodiscard]] double about(double mean) const { return sigma + relative_sigma * std::abs(mean); }
};

Scatter read_scatter(ObjectReader& in) {
  Scatter scatter;
  const bool relative = in.has("relative_sigma");
  if (relative && in.has("sigma")) {
    in.reject("relative_sigma", "excludes \"sigma\"", "keep one of them");
  } else if (relative) {
    scatter.relative_sigma = in.number("relative_sigma", rules::sigma);
  } else {
    scatter.sigma = in.number("sigma", rules::sigma);
  }
  return scatter;
}

class FluctuationReader {
 public:
  FluctuationReader(ObjectReader& in, experiment::Scene& scene) : in_(in), scene_(scene) {}

  void read() {
    read_friction();
    if (in_.has("restitution")) {
      in_.object("restitution", [this](ObjectReader& keys) {
        scene_.fluctuation.restitution = read_scatter(keys).about(scene_.restitution);
      });
    }
    if (in_.has("amplitude")) {
      if (!is_periodic(scene_.excitation)) {
        in_.reject("amplitude", "is redrawn at each period of the excitation, and a ground motion has no periods",
                   "sweep \"/excitation/scale\" to vary the size of the motion");
      }
      in_.object("amplitude", [this](ObjectReader& keys) {
        scene_.fluctuation.amplitude = read_scatter(keys).about(size_of(scene_.excitation));
      });
    }
  }

 private:
  void read_friction() {
    const experiment::Friction mean = scene_.friction.value_or(experiment::Friction{});
    for (const std::string_view key : {"friction", "static_friction", "kinetic_friction"}) {
      if (!in_.has(key)) continue;
      check_may_stand(key);
      in_.object(key, [&](ObjectReader& keys) {
        const Scatter scatter = read_scatter(keys);
        experiment::Fluctuation& fluctuation = scene_.fluctuation;
        if (key != "kinetic_friction") fluctuation.static_friction = scatter.about(mean.static_coefficient);
        if (key == "static_friction") return;
        fluctuation.kinetic_friction = scatter.about(mean.kinetic_coefficient);
        fluctuation.refreshes_per_period = static_cast<int>(keys.integer("refreshes_per_period", rules::refreshes));
      });
    }
  }

  void check_may_stand(std::string_view key) {
    if (!scene_.friction) {
      in_.reject(key, "the file has no friction that could fluctuate",
                 "add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}");
    }
    if (key != "friction" && in_.has("friction")) {
      in_.reject(key, "excludes \"friction\", which sets both static and kinetic friction", "keep one of them");
    }
  }

  ObjectReader& in_;
  experiment::Scene& scene_;
};

}  // namespace

void read_fluctuation(ObjectReader& in, experiment::Scene& scene) {
  if (!in.has("fluctuation")) return;
  in.object("fluctuation", [&scene](ObjectReader& keys) { FluctuationReader(keys, scene).read(); });
}

}  // namespace rocking::report

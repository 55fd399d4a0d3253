#include "rocking/input/read_fluctuation.hpp"

#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "rocking/scene/relations.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

// How far a source scatters, as written: in the unit of the mean, or as a fraction of it.
struct Scatter {
  double sigma = 0.0;
  double relative_sigma = 0.0;
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

/// Standard deviation of the source about `mean`; `in` is where it is written.
double sigma_about(double mean, const Scatter& scatter, ObjectReader& in) {
  const double sigma = scatter.sigma + scatter.relative_sigma * std::abs(mean);
  if (rules::sigma.allows(sigma)) return sigma;
  in.reject("relative_sigma", "makes a standard deviation above 1e6", "give a smaller fraction of the mean");
  return 0.0;
}

class FluctuationReader {
 public:
  FluctuationReader(ObjectReader& in, Scene& scene) : in_(in), scene_(scene) {}

  void read() {
    read_friction();
    if (in_.has("restitution")) {
      in_.object("restitution", [this](ObjectReader& keys) {
        scene_.fluctuation.restitution = sigma_about(mean_restitution(), read_scatter(keys), keys);
      });
    }
    if (in_.has("amplitude")) {
      if (amplitude_draws(scene_.excitation) == AmplitudeDraws::refused) {
        Refusal refusal = relations::no_period_to_fluctuate();
        in_.reject("amplitude", std::move(refusal.reason), std::move(refusal.remedy));
      }
      in_.object("amplitude", [this](ObjectReader& keys) {
        scene_.fluctuation.amplitude = sigma_about(size_of(scene_.excitation), read_scatter(keys), keys);
      });
    }
  }

 private:
  void read_friction() {
    const Friction mean = scene_.friction.value_or(Friction{});
    for (const std::string_view key : {"friction", "static_friction", "kinetic_friction"}) {
      if (!in_.has(key)) continue;
      check_may_stand(key);
      in_.object(key, [&](ObjectReader& keys) {
        const Scatter scatter = read_scatter(keys);
        Fluctuation& fluctuation = scene_.fluctuation;
        if (key != "kinetic_friction")
          fluctuation.static_friction = sigma_about(mean.static_coefficient, scatter, keys);
        if (key == "static_friction") return;
        fluctuation.kinetic_friction = sigma_about(mean.kinetic_coefficient, scatter, keys);
        fluctuation.refreshes_per_period = static_cast<int>(
            keys.integer("refreshes_per_period", rules::refreshes.with_default(fluctuation.refreshes_per_period)));
      });
    }
  }

  /// As it is given; under `jy25` e of the mean block.
  double mean_restitution() const {
    if (const auto* ratio = std::get_if<RateRatio>(&scene_.restitution)) return ratio->value;
    const dynamics::Block block = mean_block(scene_);
    const bool is_sound = block.width > 0.0 && block.height > 0.0;  // else it is already reported
    return is_sound ? restitution_of(scene_, dynamics::geometry_of(block)) : 0.0;
  }

  void check_may_stand(std::string_view key) {
    if (!scene_.friction) {
      Refusal refusal = relations::no_friction_to_fluctuate();
      in_.reject(key, std::move(refusal.reason), std::move(refusal.remedy));
    }
    if (key != "friction" && in_.has("friction")) {
      in_.reject(key, "excludes \"friction\", which sets both static and kinetic friction", "keep one of them");
    }
  }

  ObjectReader& in_;
  Scene& scene_;
};

}  // namespace

void read_fluctuation(ObjectReader& in, Scene& scene) {
  if (!in.has("fluctuation")) return;
  in.object("fluctuation", [&scene](ObjectReader& keys) { FluctuationReader(keys, scene).read(); });
}

}  // namespace rocking

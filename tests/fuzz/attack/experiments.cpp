// Experiment files that are damaged, or valid but unusual.

#include "fuzz/attack/attack.hpp"
#include "fuzz/mutate_json.hpp"

namespace rocking::fuzz {
namespace {

constexpr const char* features[] = {
    R"({ "excitation": { "kind": "recorded", "file": "pulse.txt", "scale": 1.0 }, "friction": null, "fluctuation": null,
         "sweep": [ { "parameter": "/excitation/scale", "values": [0.1, 10.0] } ], "horizon": null })",
    R"({ "initial": { "tilt": { "uniform": [-0.5, 0.5] }, "tilt_rate": { "normal": { "mean": 0, "sigma": 0.1 } } } })",
    R"({ "realisations": { "until": { "half_width": 0.2, "at_most": 40 } } })",
    R"json({ "realisations": { "until": { "relative_half_width": 0.5, "mode": "(1,3)", "at_most": 40 } } })json",
    R"({ "sweep": [ { "parameter": "/excitation/amplitude", "from": 2.0, "to": 4.0, "step": 1.0 },
                    { "parameter": "/friction", "values": [ { "static": 0.4, "kinetic": 0.3 } ] } ] })",
    R"({ "formulation": "as-printed", "accuracy": { "tolerance": 1e-8 }, "confidence": 0.9 })",
    R"({ "excitation": { "amplitude": null, "amplitude_g": 1.0, "frequency_ratio": null, "period_s": 0.4 },
         "restitution": { "rate_ratio": 0.9 },
         "sweep": [ { "parameter": "/block/width_m", "values": [0.9, 1.2] } ] })",
    R"({ "fluctuation": { "amplitude": { "relative_sigma": 0.1 }, "restitution": { "sigma": 0.01 } } })"};

}  // namespace

void attack_experiments(Attack& attack) {
  Json experiment = Json::parse(attack.read(attack.sound().folder / "quick.json"));
  if (attack.random.below(3) > 0) experiment.merge_patch(Json::parse(attack.one_of(features)));
  JsonMutator mutator(attack.random.bits());
  attack.write("bad.json", attack.random.below(4) == 0 ? mutator.damaged_text(experiment.dump(1))
                                                       : mutator.damaged(experiment).dump(1));
  attack.write("pulse.txt", attack.read(attack.sound().folder / "pulse.txt"));

  const Ending checked = attack.run({"validate", "bad.json"}, {0, 65, 66});
  attack.run({"run", "bad.json", "--dry-run", "-o", "out"}, {0, 65, 66, 74});
  const Ending ran =
      attack.run({"run", "bad.json", "-j", "2", "--max-time", "1s", "-q", "-o", "out"}, {0, 65, 66, 74, 75});
  if (checked.exit_code == 65 && ran.exit_code != 65) attack.find("`run` accepts what `validate` refuses");
  attack.look_at_page("out/report.html");
}

}  // namespace rocking::fuzz

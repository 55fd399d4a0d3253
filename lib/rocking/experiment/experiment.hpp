#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/formulation.hpp"
#include "rocking/experiment/excitation.hpp"

namespace rocking::experiment {

struct Friction {
  double static_coefficient = 0.0;   ///< mean of mu_s [-]
  double kinetic_coefficient = 0.0;  ///< mean of mu_k [-]
};

/// Standard deviations, in the unit of the mean. 0: the source is off and no number is drawn for it.
struct Fluctuation {
  double static_friction = 0.0;
  double kinetic_friction = 0.0;
  int refreshes_per_period = 200;  ///< intervals of constant kinetic friction in an excitation period
  double restitution = 0.0;
  double amplitude = 0.0;
};

struct InitialState {
  Quantity tilt = 0.0;       ///< Theta = theta/psi
  Quantity tilt_rate = 0.0;  ///< Theta' = w/psi
  Quantity slip_rate = 0.0;  ///< V
};

/// One block on one shaken base: all that a realisation's motion depends on, but for its draws.
struct Scene {
  dynamics::Block block;
  dynamics::SlideInertia slide_inertia = dynamics::SlideInertia::centroidal;
  dynamics::ImpactSlipRule impact_slip_rule = dynamics::ImpactSlipRule::absolute;
  double restitution = 0.0;  ///< mean of e; `jy25` is worked out by the reader
  Excitation excitation;
  std::optional<Friction> friction;  ///< absent: the block cannot slide, and nothing of sliding is computed
  Fluctuation fluctuation;
  InitialState initial;
};

struct Horizon {
  int transient_periods = 500;  ///< dropped before the response is named
  int sampled_periods = 120;    ///< of which the strobe points are used
};

/// What a sweep changed for a condition: a pointer into the experiment file and the value there, as JSON text.
struct Parameter {
  std::string pointer;
  std::string value;
};

/// Sampling goes on until every mode's interval is narrow enough.
struct Until {
  double half_width = 0.0;  ///< of every interval, in (0, 1/2)
};

/// Some realisations are named once more by a longer run, which is taken for the truth.
struct LabelCheck {
  std::uint64_t every = 20;         ///< every so manieth realisation, at least 1
  std::uint64_t times_longer = 20;  ///< sampled periods of the longer run, in those of the shorter one, at least 2
};

/// One point of the sweep.
struct Condition {
  std::vector<Parameter> parameters;
  Scene scene;
  Horizon horizon;
  double tolerance = 1e-13;         ///< largest last Taylor term of a step, in units of Theta, Theta'
  std::uint64_t repeat_every = 10;  ///< every so manieth realisation is run at a tighter tolerance too; 0: none
  std::uint64_t realisations = 1;   ///< with `until`: at most
  std::optional<Until> until;
  std::optional<LabelCheck> label_check;  ///< absent: none
  double confidence = 0.95;
};

/// A question, as a user declared it.
struct Experiment {
  std::string title;
  std::uint64_t seed = 0;
  std::vector<Condition> conditions;  ///< the sweep's grid; its last entry varies fastest
  std::string canonical_text;  ///< the file with every default written out: JSON text, the same for equal questions
  std::vector<std::size_t> sweep_sizes = {};  ///< points of each entry of the sweep
};

/// Whether anything in the scene is drawn at random. If not, one realisation says all.
[[nodiscard]] bool is_random(const Scene& scene);

/// The confidence that all conditions have; absent where a sweep goes over it.
[[nodiscard]] std::optional<double> common_confidence(const Experiment& experiment);

/// Of an interval over all conditions together: it holds at the confidence of each.
[[nodiscard]] double highest_confidence(const Experiment& experiment);

}  // namespace rocking::experiment

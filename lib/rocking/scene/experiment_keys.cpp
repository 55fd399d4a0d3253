#include "rocking/scene/experiment_keys.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

// In the order of the enumerators.
constexpr std::array<std::string_view, 3> formulation_names{"consistent", "as-printed", "as-plotted"};
constexpr std::array<std::string_view, 2> slide_inertia_names{"centroidal", "edge"};
constexpr std::array<std::string_view, 2> impact_slip_rule_names{"absolute", "signed"};
constexpr std::array<std::string_view, 2> motion_end_names{"overturned", "balance"};

/// The form of a block that a file has; one that it must not have as well is refused.
void choose_form(FieldVisitor& in, SceneMass& mass) {
  const auto refuse = [&in](std::initializer_list<std::string_view> keys, std::string_view reason) {
    for (const std::string_view key : keys) in.refuse(key, reason, "keep one of the two forms");
  };
  const bool has_p = in.found("p_rad_s") != nullptr, has_slenderness = in.found("slenderness_rad") != nullptr;
  if (has_p || has_slenderness) {
    refuse({"width_m", "height_m", "centre_height_m", "centre_offset_m", "radius_of_gyration_m", "edges_m", "parts",
            "base_m"},
           "excludes \"p_rad_s\" and \"slenderness_rad\", which give a uniform rectangle");
    mass = GivenSlenderness{};
  } else if (in.found("edges_m") != nullptr) {
    refuse({"width_m", "height_m", "centre_offset_m"}, "is for a block with an outline; this one has \"edges_m\"");
    refuse({"parts", "base_m"}, "excludes \"edges_m\"");
    mass = GivenEdges{};
  } else if (in.found("parts") != nullptr) {
    refuse({"width_m", "height_m", "centre_height_m", "centre_offset_m", "radius_of_gyration_m"},
           "follows from the parts");
    mass = GivenParts{};
  } else {
    in.refuse("base_m", "is for a block of parts", "give \"parts\", or omit it");
    for (const std::string_view key : {"centre_height_m", "centre_offset_m", "radius_of_gyration_m"}) {
      if (in.found(key) != nullptr) mass = GivenCentre{};
    }
  }
}

constexpr Key centre_height_key{"centre_height_m",
                                "of the centre of mass above the base [m]; beside width_m absent: half the height"};
constexpr Key radius_key{"radius_of_gyration_m",
                         "sqrt(I/m) about the centre of mass [m]; beside width_m absent: that of a uniform rectangle"};

void keys_of(FieldVisitor& in, SceneBlock& block, GivenCentre& centre, Absent absent) {
  in.value({"width_m", "B [m]"}, block.width, rules::length, absent);
  in.value({"height_m", "H [m]"}, block.height, rules::length, absent);
  in.optional(centre_height_key.name, centre.height,
              [&in](Quantity& height) { in.value(centre_height_key, height, rules::length, Absent::omitted); });
  in.optional("centre_offset_m", centre.offset, [&in](Quantity& offset) {
    in.value({"centre_offset_m", "of the centre of mass to the right of the middle of the base [m]"}, offset,
             rules::offset, Absent::omitted);
  });
  in.optional(radius_key.name, centre.radius_of_gyration,
              [&in](Quantity& radius) { in.value(radius_key, radius, rules::length, Absent::omitted); });
}

/// The ratio of the rates at a wall is a law of restitution, in place of that of the floor alone.
void keys_of_wall(FieldVisitor& in, SceneBlock& block, Restitution& restitution) {
  in.optional("wall", block.wall, [&](dynamics::Side& side) {
    in.object(
        {"wall", "at one side of the block, which turns away from it only; without friction; absent: none"},
        Absent::omitted, [&](FieldVisitor& keys) {
          auto* const known = std::get_if<WallRatio>(&restitution);
          WallRatio ratio = known == nullptr ? WallRatio{} : *known;
          keys.choice({"side", "of the block at which the wall stands"}, side, dynamics::side_names, Absent::error);
          keys.value({"rate_ratio", "abs(w2/w1) of an impact on floor and wall"}, ratio.value, rules::wall_ratio,
                     Absent::error);
          if (keys.is_reading()) restitution = ratio;
        });
  });
}

void keys_of(FieldVisitor& in, SceneBlock& block, Restitution& restitution) {
  if (in.is_reading()) choose_form(in, block.mass);
  const bool describes = in.describes();
  in.require_one_of({"width_m", "edges_m", "parts", "p_rad_s"});
  GivenCentre none;
  auto* const centre = std::get_if<GivenCentre>(&block.mass);
  if (centre != nullptr || std::holds_alternative<UniformMass>(block.mass)) {
    keys_of(in, block, centre == nullptr ? none : *centre, describes ? Absent::omitted : Absent::error);
  }
  GivenEdges described_edges;
  if (auto* const edges = describes ? &described_edges : std::get_if<GivenEdges>(&block.mass)) {
    in.value({"edges_m", "in place of width_m: distances of the left and the right edge from the centre of mass [m]"},
             edges->edges, QuantityPairType(rules::length), Absent::omitted);
    if (!describes) {
      in.value(centre_height_key, edges->centre_height, rules::length, Absent::error);
      in.value(radius_key, edges->radius_of_gyration, rules::length, Absent::error);
    }
  }
  GivenParts described_parts;
  if (auto* const parts = describes ? &described_parts : std::get_if<GivenParts>(&block.mass)) {
    in.value({"parts",
              "in place of width_m: uniform rectangles, each with width_m, height_m, mass_kg, x_m of its middle and "
              "bottom_m above the floor"},
             parts->parts, parts_type(), Absent::omitted);
    in.optional("base_m", parts->base, [&in](std::array<Quantity, 2>& base) {
      in.value({"base_m", "x of the left and the right end of the base [m]; absent: of the parts on the floor"}, base,
               QuantityPairType(rules::offset), Absent::omitted);
    });
  }
  GivenSlenderness described_slenderness;
  if (auto* const given = describes ? &described_slenderness : std::get_if<GivenSlenderness>(&block.mass)) {
    const Absent absent = describes ? Absent::omitted : Absent::error;
    in.value({"p_rad_s", "in place of width_m: p = sqrt(3 g/(4 R)) of a uniform rectangle [rad/s]"},
             given->frequency_parameter, rules::frequency_parameter, absent);
    in.value({"slenderness_rad", "with p_rad_s: psi = arctan(B/H), which papers call alpha [rad]"}, given->slenderness,
             rules::slenderness, absent);
  }
  in.value({"gravity_m_s2", "g [m/s^2]"}, block.gravity, rules::gravity, Absent::standard);
  keys_of_wall(in, block, restitution);
}

void keys_of_formulation(FieldVisitor& in, Scene& scene) {
  Formulation formulation = Formulation::consistent;
  in.choice(
      {"formulation", "reading of the equations (model.md); the next three keys follow from it where they are absent"},
      formulation, formulation_names, Absent::standard);
  const FormulationOptions options = options_of(formulation);
  if (in.is_reading()) {
    scene.slide_inertia = options.slide_inertia;
    scene.impact_slip_rule = options.impact_slip_rule;
    if (options.is_jy25 && !scene.block.wall) scene.restitution = Jy25Restitution{};
  }
  const Absent follows = in.follows_from({"/formulation"});
  in.choice({"slide_inertia", "inertia in the slip equations"}, scene.slide_inertia, slide_inertia_names, follows);
  if (scene.block.wall && !in.describes()) {
    in.refuse("restitution", "is that of an impact on the floor alone; at a wall it is the rate ratio of the wall",
              "omit it");
    return in.choice({"impact_slip_rule", ""}, scene.impact_slip_rule, impact_slip_rule_names, follows);
  }
  Formed restitution = formed(scene.restitution);
  in.value({"restitution",
            "vertical restitution e of an impact; \"jy25\": 1 - 1.5 sin^2(psi); rate_ratio: the measured ratio "
            "abs(w2/w1) of the tilt rates across an impact without slip, from which e follows; a list of two: where "
            "the left and where the right edge lands"},
           restitution, restitution_type(), in.follows_from({"/formulation", "/block/wall"}));
  scene.restitution = restitution_of(std::move(restitution));
  in.choice({"impact_slip_rule", "when an impact slips"}, scene.impact_slip_rule, impact_slip_rule_names, follows);
}

void keys_of(FieldVisitor& in, Friction& friction) {
  in.value({"static", "mu_s; its mean is at least that of mu_k"}, friction.static_coefficient,
           rules::friction_coefficient, Absent::error);
  Formed kinetic = friction.kinetic_ratio ? Formed{.form = 1, .value = *friction.kinetic_ratio}
                                          : Formed{.form = 0, .value = friction.kinetic_coefficient};
  constexpr std::array<Form, 2> forms{{{.name = "", .rule = &rules::friction_coefficient},
                                       {.name = "ratio", .rule = &rules::kinetic_ratio, .may_be_drawn = false}}};
  in.value({"kinetic",
            "mu_k, or its ratio to the mu_s that was drawn; its mean is below the limit of Painleve's paradox for "
            "every block that can be drawn"},
           kinetic, FormsType(forms, ""), Absent::error);
  if (kinetic.form == 1) {
    friction.kinetic_ratio = mean_of(kinetic.value);
  } else {
    friction.kinetic_coefficient = kinetic.value;
  }
}

void key_of_law(FieldVisitor& in, FluctuationLaw& law) {
  in.choice({"law", "with this mean and standard deviation; absent: normal"}, law, fluctuation_law_names,
            Absent::omitted);
}

/// A standard deviation that a file may give relative to its mean.
struct Scatter {
  double* sigma;
  std::function<double()> mean;
};

/// `sigma`, in the unit of the mean, or `relative_sigma`, for all of these.
void keys_of_scatter(FieldVisitor& in, std::initializer_list<Scatter> of) {
  const Key sigma{"sigma", "standard deviation, in the unit in which the mean is given; or relative_sigma"};
  const Key relative{"relative_sigma", "in place of sigma: over the absolute value of the mean"};
  in.require_one_of({sigma.name, relative.name});
  if (!in.is_reading()) {
    for (const Scatter& each : of) {
      in.value(sigma, *each.sigma, rules::sigma, Absent::omitted);
      if (in.stands(relative.name, false)) return in.value(relative, *each.sigma, rules::sigma, Absent::omitted);
    }
    return;
  }
  const bool is_relative = in.stands(relative.name, false);
  if (is_relative && in.stands(sigma.name, false)) {
    return in.reject(relative.name, {"excludes \"sigma\"", "keep one of them"});
  }
  double given = 0.0;
  in.value(is_relative ? relative : sigma, given, rules::sigma, Absent::error);
  for (const Scatter& each : of) {
    const double absolute = is_relative ? given * std::abs(each.mean()) : given;
    if (rules::sigma.allows(absolute)) {
      *each.sigma = absolute;
    } else {
      in.reject(relative.name, {"makes a standard deviation above 1e6", "give a smaller fraction of the mean"});
    }
  }
}

/// `friction` is both static and kinetic friction, which a condition in C++ has apart.
void keys_of_friction_fluctuation(FieldVisitor& in, Scene& scene) {
  Fluctuation& fluctuation = scene.fluctuation;
  const auto mean = [&scene](double (*mean_of)(const Friction&)) {
    return [&scene, mean_of] { return mean_of(scene.friction.value_or(Friction{})); };
  };
  const Scatter of_static{&fluctuation.static_friction, mean(mean_static)};
  const Scatter of_kinetic{&fluctuation.kinetic_friction, mean(mean_kinetic)};
  const auto stands = [&in, &scene](std::string_view key, bool is_given) {
    if (!in.stands(key, is_given)) return false;
    if (!scene.friction) in.reject(key, relations::no_friction_to_fluctuate());
    if (key == "friction") return true;
    in.exclude(key, "friction",
               {"excludes \"friction\", which sets both static and kinetic friction", "keep one of them"});
    return true;
  };
  const auto refreshes = [&fluctuation](FieldVisitor& keys) {
    keys.optional("refresh_slip_m", fluctuation.refresh_slip_m, [&keys](double& length) {
      keys.exclude("refresh_slip_m", "refreshes_per_period",
                   {"excludes \"refreshes_per_period\": friction belongs to the place or is drawn again in time",
                    "keep one of them"});
      keys.value({"refresh_slip_m", "length of the cells of the base along the slip, each with its own friction [m]"},
                 length, rules::refresh_slip, Absent::omitted);
    });
    if (keys.is_reading() && fluctuation.refresh_slip_m) return;
    keys.value({"refreshes_per_period", "intervals of constant kinetic friction in an excitation period"},
               fluctuation.refreshes_per_period, rules::refreshes, Absent::standard);
  };
  if (stands("friction", false)) {
    in.object({"friction", "of static and kinetic friction alike"}, Absent::omitted, [&](FieldVisitor& keys) {
      keys_of_scatter(keys, {of_static, of_kinetic});
      key_of_law(keys, fluctuation.laws.static_friction);
      fluctuation.laws.kinetic_friction = fluctuation.laws.static_friction;
      keys.value({"correlation",
                  "of the normal numbers from which static and kinetic friction in force follow (Gaussian copula)"},
                 fluctuation.friction_correlation, rules::correlation, Absent::omitted);
      refreshes(keys);
    });
  }
  if (stands("static_friction", true)) {
    in.object({"static_friction", "in place of friction"}, Absent::omitted, [&](FieldVisitor& keys) {
      keys_of_scatter(keys, {of_static});
      key_of_law(keys, fluctuation.laws.static_friction);
    });
  }
  if (stands("kinetic_friction", true)) {
    in.object({"kinetic_friction", "in place of friction"}, Absent::omitted, [&](FieldVisitor& keys) {
      keys_of_scatter(keys, {of_kinetic});
      key_of_law(keys, fluctuation.laws.kinetic_friction);
      refreshes(keys);
    });
  }
}

/// Of the restitution as it is given, for the mean block.
double mean_restitution_of(const Scene& scene) {
  const dynamics::Block block = mean_block(scene);
  const bool is_sound = block.width > 0.0 && block.height > 0.0;  // else it is already reported
  return is_sound ? mean_as_given(scene.restitution, dynamics::geometry_of(block)) : 0.0;
}

void keys_of_fluctuation(FieldVisitor& in, Scene& scene) {
  keys_of_friction_fluctuation(in, scene);
  if (in.stands("restitution", true)) {
    in.object(
        {"restitution", "in the unit of the restitution: of e, or of the rate ratio"}, Absent::omitted,
        [&](FieldVisitor& keys) {
          keys_of_scatter(keys, {{&scene.fluctuation.restitution, [&scene] { return mean_restitution_of(scene); }}});
          key_of_law(keys, scene.fluctuation.laws.restitution);
        });
  }
  if (!in.stands("amplitude", true)) return;
  if (amplitude_draws(scene.excitation) == AmplitudeDraws::refused) {
    in.reject("amplitude", relations::no_period_to_fluctuate());
  }
  in.object({"amplitude", "in the unit of the amplitude; drawn at each period, of a pulse once"}, Absent::omitted,
            [&](FieldVisitor& keys) {
              keys_of_scatter(keys, {{&scene.fluctuation.amplitude, [&scene] { return size_of(scene.excitation); }}});
              key_of_law(keys, scene.fluctuation.laws.amplitude);
            });
}

/// Keys of each number of a state, in the order of StateUnit.
constexpr std::array<UnitKey, 3> tilt_units{
    {{{"tilt", "Theta = theta/psi; abs(theta) < pi/2 for every block that can be drawn"}, rules::initial_value},
     {{"tilt_rad", "in place of tilt: theta [rad], > 0 about the left edge"}, rules::initial_value},
     {{"tilt_deg", "likewise [degrees]"}, rules::initial_value}}};
constexpr std::array<UnitKey, 2> tilt_rate_units{
    {{{"tilt_rate", "Theta' = dTheta/dtau"}, rules::initial_value},
     {{"tilt_rate_rad_s", "in place of tilt_rate: dtheta/dt [rad/s]"}, rules::initial_value}}};
constexpr std::array<UnitKey, 2> slip_units{
    {{{"slip", "X, displacement of the edge relative to the base, over R, from which X goes on; needs friction"},
      rules::initial_value},
     {{"slip_m", "in place of slip: the displacement [m]"}, rules::initial_value}}};
constexpr std::array<UnitKey, 2> slip_rate_units{
    {{{"slip_rate", "V, of the edge relative to the base, over p R; needs friction"}, rules::initial_value},
     {{"slip_rate_m_s", "in place of slip_rate: the velocity [m/s]"}, rules::initial_value}}};

void keys_of(FieldVisitor& in, InitialState& initial, bool slides) {
  const auto number = [&in](const auto& keys, Quantity& value, StateUnit& unit, Absent absent) {
    QuantityInUnit given{.unit = static_cast<std::size_t>(unit), .value = value};
    if (!one_of(in, keys, given, absent)) return;
    value = std::move(given.value);
    unit = static_cast<StateUnit>(given.unit);
  };
  auto& [tilt, tilt_rate, slip, slip_rate, units] = initial;
  number(tilt_units, tilt, units.tilt, Absent::standard);
  number(tilt_rate_units, tilt_rate, units.tilt_rate, Absent::standard);
  number(slip_units, slip, units.slip, Absent::omitted);
  const bool in_si = units.slip_rate == StateUnit::si;
  if (!slides && !in.stands("slip_rate", !in_si) && !in.stands("slip_rate_m_s", in_si)) return;
  number(slip_rate_units, slip_rate, units.slip_rate, Absent::standard);
}

void keys_of(FieldVisitor& in, Scene& scene, RecordFields& records) {
  in.object({"block", "a rigid block: a uniform rectangle, or with its mass elsewhere"}, Absent::error,
            [&](FieldVisitor& keys) { keys_of(keys, scene.block, scene.restitution); });
  keys_of_formulation(in, scene);
  in.object({"excitation", "how the base moves"}, Absent::error,
            [&](FieldVisitor& keys) { keys_of(keys, scene.excitation, mean_block(scene), records); });
  in.optional("friction", scene.friction, [&](Friction& friction) {
    in.object({"friction", "absent: the block does not slide"}, Absent::omitted,
              [&](FieldVisitor& keys) { keys_of(keys, friction); });
  });
  if (in.stands("fluctuation", true)) {
    in.object({"fluctuation", "what is drawn again along the way; absent: nothing"}, Absent::omitted,
              [&](FieldVisitor& keys) { keys_of_fluctuation(keys, scene); });
  }
  in.object({"initial", "the state at the start"}, Absent::standard,
            [&](FieldVisitor& keys) { keys_of(keys, scene.initial, scene.friction.has_value()); });
}

void keys_of(FieldVisitor& in, UntilClassified& until) {
  in.value({"at_most_periods", "from the start on; at least transient_periods + sampled_periods"},
           until.at_most_periods, rules::at_most_periods, Absent::error);
  in.value({"held_windows", "settled if so many successive windows give the same response mode"}, until.held_windows,
           rules::held_windows, Absent::standard);
  in.value({"watch_windows", "further windows in which a settled response is observed, until it is left"},
           until.watch_windows, rules::watch_windows, Absent::standard);
  // Absent from the canonical text, too, as before there were these keys.
  in.value({"long_run_every",
            "every N-th realisation is observed up to at_most_periods, and its windows in the second half are counted "
            "by response mode; 0: none"},
           until.long_run_every, rules::long_run_every, Absent::omitted);
  in.value({"exponent_pause",
            "after a window whose exponent stayed unclear in its longest run, it counts as unclear in so many windows "
            "and is not computed"},
           until.exponent_pause, rules::exponent_pause, Absent::omitted);
}

void keys_of(FieldVisitor& in, Horizon& horizon, const Scene& scene) {
  const bool is_reading = in.is_reading();
  const DefaultHorizon standard =
      is_reading ? default_horizon(scene) : DefaultHorizon{horizon.transient_periods, horizon.sampled_periods};
  const Absent follows = in.follows_from(horizon_follows_from(scene.excitation));
  const bool is_too_long = !rules::sampled_periods.allows(static_cast<double>(standard.sampled_periods));
  if (is_reading) {
    horizon.transient_periods = static_cast<int>(standard.transient_periods);
    if (!is_too_long) horizon.sampled_periods = static_cast<int>(standard.sampled_periods);
  }
  if (is_reading && !is_periodic(scene.excitation) && !impacts_take_energy(scene) &&
      !in.stands("sampled_periods", true)) {
    in.reject("sampled_periods",
              {"is missing: at a rate ratio of 1 impacts take nothing, so that the block never comes to rest",
               "give the strobe periods to observe, such as 100"});
  }
  in.value({"transient_periods", "periods that are not used for the classification; harmonic: 500, else 0"},
           horizon.transient_periods, rules::transient_periods, follows);
  if (is_reading && is_too_long && !in.stands("sampled_periods", true)) {
    return in.reject(
        "sampled_periods",
        {"would be " + std::to_string(standard.sampled_periods) + ", until the block rests after the shaking",
         "lower the frequency, so that strobe periods are longer, or give at most 1000000"});
  }
  in.value({"sampled_periods",
            "periods whose strobe points are used; harmonic: 120, and at least 24 to classify a response, 48 of a "
            "random one; else until the block rests after the shaking"},
           horizon.sampled_periods, rules::sampled_periods, follows);
  in.optional("until_classified", horizon.until_classified, [&](UntilClassified& until) {
    in.object({"until_classified",
               "a realisation that is unresolved goes on, window by window of sampled_periods, until its response is "
               "classified (settling.md); periodic excitation only"},
              Absent::omitted, [&](FieldVisitor& keys) { keys_of(keys, until); });
  });
  in.choice({"until",
             "the end of a motion that overturns: abs(theta) = pi/2, or balance: abs(theta) = psi for the first time, "
             "from which the base could have brought the block back; both count as overturned"},
            horizon.until, motion_end_names, Absent::omitted);
}

void keys_of_goal(FieldVisitor& in, Until& until, Condition& condition) {
  in.optional("half_width", until.half_width, [&](double& half_width) {
    in.value({"half_width",
              "of the interval of every response mode, or of that of mode, valid whenever one looks; or "
              "relative_half_width"},
             half_width, rules::half_width, Absent::omitted);
  });
  in.optional("relative_half_width", until.relative_half_width, [&](double& half_width) {
    in.value({"relative_half_width", "half-width of the interval of mode, over the estimate of its probability"},
             half_width, rules::relative_half_width, Absent::omitted);
  });
  in.value({"mode", "the response mode whose interval decides; absent: every one"}, until.mode, mode_type(),
           Absent::omitted);
  in.value({"at_most", "realisations, whatever the intervals"}, condition.realisations, rules::at_most, Absent::error);
}

void keys_of_realisations(FieldVisitor& in, Condition& condition) {
  const auto number = [&](FieldVisitor& keys) {
    keys.value({"realisations", "of each condition"}, condition.realisations, rules::realisations, Absent::standard);
  };
  const auto goal = [&](FieldVisitor& keys) {
    Until until = condition.until.value_or(Until{});
    keys.object({"until", "as many realisations as it takes (methods.md, section 2)"}, Absent::error,
                [&](FieldVisitor& inner) {
                  keys_of_goal(inner, until, condition);
                  condition.until = until;
                  const auto of_every_mode = relations::relative_half_width_of_every_mode(condition);
                  if (of_every_mode && !inner.stands("mode", true)) inner.reject("mode", *of_every_mode);
                  if (const auto refusal = relations::one_half_width(condition)) inner.reject("", *refusal);
                });
  };
  in.value_or_object({"realisations", "of each condition"}, condition.until.has_value(), number, goal);
}

}  // namespace

void keys_of(FieldVisitor& in, UnsweptExperiment& question, RecordFields& records) {
  Condition& condition = question.condition;
  in.value({"title", "the question, in words"}, question.title, TextType(), Absent::standard);
  keys_of(in, condition.scene, records);
  in.object({"horizon", "in periods of the excitation"}, Absent::standard,
            [&](FieldVisitor& keys) { keys_of(keys, condition.horizon, condition.scene); });
  in.object({"accuracy", "of the trajectories"}, Absent::standard, [&](FieldVisitor& keys) {
    keys.value({"tolerance", "largest last Taylor term of a step, in units of Theta and Theta'"}, condition.tolerance,
               rules::tolerance, Absent::standard);
    keys.value(
        {"rerun_every",
         "every N-th realisation is run again at a hundred times tighter tolerance, with the same draws; 0: none"},
        condition.rerun_every, rules::rerun_every, Absent::standard);
  });
  in.field({"sweep", "several entries form a grid; the last varies fastest"}, sweep_type(), nullptr, Absent::omitted);
  in.field({"unknown", "one to three numbers that counted tests are to determine; of `rocking infer` alone"},
           unknown_type(), nullptr, Absent::omitted);
  keys_of_realisations(in, condition);
  in.value({"confidence", "level of the intervals"}, condition.confidence, rules::confidence, Absent::standard);
  in.value({"seed", "64 bits: \"0x2012\", \"8210\" or 8210"}, question.seed, written_seed_type(), Absent::standard);
}

}  // namespace rocking

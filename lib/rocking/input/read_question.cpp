#include "rocking/input/read_question.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "rocking/input/read_quantity.hpp"
#include "rocking/input/read_scene.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/relations.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/seed_text.hpp"

namespace rocking {
namespace {

void read_format(ObjectReader& in) {
  const Json* format = in.value("format");
  if (format == nullptr) {
    in.reject("format", "is missing", "add \"format\": \"" + std::string(experiment_format) + '"');
  } else if (*format != experiment_format) {
    in.reject("format", "is not a format that this version reads", "write \"" + std::string(experiment_format) + '"');
  }
  in.write("format", experiment_format);
}

void read_until_classified(ObjectReader& in, Horizon& horizon) {
  if (!in.has("until_classified")) return;
  UntilClassified until;
  in.object("until_classified", [&until](ObjectReader& keys) {
    until.at_most_periods = keys.integer("at_most_periods", rules::at_most_periods);
    until.held_windows =
        static_cast<int>(keys.integer("held_windows", rules::held_windows.with_default(until.held_windows)));
    until.watch_windows =
        static_cast<int>(keys.integer("watch_windows", rules::watch_windows.with_default(until.watch_windows)));
    if (keys.has("long_run_every")) {  // otherwise absent from the canonical text, too, as before these keys
      until.long_run_every =
          static_cast<std::uint64_t>(keys.integer("long_run_every", rules::long_run_every.with_default(0)));
    }
    if (keys.has("exponent_pause")) {
      until.exponent_pause = static_cast<int>(keys.integer("exponent_pause", rules::exponent_pause.with_default(0)));
    }
  });
  horizon.until_classified = until;
}

Horizon read_horizon(ObjectReader& in, const Scene& scene, DefaultSpelling spelling) {
  const DefaultHorizon standard = default_horizon(scene);
  Horizon horizon;
  in.object("horizon", [&](ObjectReader& keys) {
    horizon.transient_periods = static_cast<int>(
        keys.derived_integer("transient_periods", rules::transient_periods, standard.transient_periods, spelling));
    if (standard.sampled_periods > rules::sampled_periods.high && !keys.has("sampled_periods")) {
      keys.reject("sampled_periods",
                  "would be " + std::to_string(standard.sampled_periods) + ", until the block rests after the shaking",
                  "lower the frequency, so that strobe periods are longer, or give at most 1000000");
      return;
    }
    horizon.sampled_periods = static_cast<int>(
        keys.derived_integer("sampled_periods", rules::sampled_periods, standard.sampled_periods, spelling));
    read_until_classified(keys, horizon);
  });
  return horizon;
}

std::optional<section::ResponseMode> read_mode(ObjectReader& in) {
  const Json* found = in.value("mode");
  if (found == nullptr) return std::nullopt;
  const auto mode = found->is_string() ? section::response_mode_named(found->get<std::string>()) : std::nullopt;
  const bool exists =
      mode && (mode->kind != section::ResponseKind::periodic || (mode->rocks >= 0 && mode->periods > 0));
  if (!exists) {
    in.reject("mode", "is not the name of a response mode",
              "give \"overturned\", \"rest\", \"chaotic\", \"unresolved\", or (m,n) such as \"(1,3)\"");
    return std::nullopt;
  }
  in.write("mode", to_string(*mode));
  return mode;
}

Until read_goal(ObjectReader& in) {
  Until until;
  if (in.has("half_width")) until.half_width = in.number("half_width", rules::half_width);
  if (in.has("relative_half_width")) {
    until.relative_half_width = in.number("relative_half_width", rules::relative_half_width);
  }
  until.mode = read_mode(in);
  return until;
}

void read_until(ObjectReader& in, Condition& condition) {
  in.object("realisations", [&condition](ObjectReader& keys) {
    keys.object("until", [&condition](ObjectReader& goal) {
      condition.until = read_goal(goal);
      condition.realisations = static_cast<std::uint64_t>(goal.integer("at_most", rules::at_most));
      auto refusal = relations::relative_half_width_of_every_mode(condition);
      if (refusal && !goal.has("mode")) goal.reject("mode", std::move(refusal->reason), std::move(refusal->remedy));
    });
    const Json* goal = keys.value("until");
    auto refusal = relations::one_half_width(condition);
    if (refusal && (goal == nullptr || goal->is_object())) {
      keys.reject("until", std::move(refusal->reason), std::move(refusal->remedy));
    }
  });
}

void read_realisations(ObjectReader& in, Condition& condition) {
  const Json* found = in.value("realisations");
  if (found != nullptr && found->is_object()) return read_until(in, condition);
  condition.realisations =
      static_cast<std::uint64_t>(in.integer("realisations", rules::realisations.with_default(condition.realisations)));
}

void read_label_check(ObjectReader& in, Condition& condition) {
  if (!in.has("check_labels")) return;
  LabelCheck check;
  in.object("check_labels", [&check](ObjectReader& keys) {
    check.every = static_cast<std::uint64_t>(keys.integer("every", rules::check_every.with_default(check.every)));
    check.times_longer =
        static_cast<std::uint64_t>(keys.integer("times_longer", rules::times_longer.with_default(check.times_longer)));
  });
  condition.label_check = check;
}

std::optional<std::uint64_t> seed_in(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_string()) return std::nullopt;
  return seed_from_text(value.get_ref<const std::string&>());
}

std::uint64_t read_seed(ObjectReader& in) {
  const Json* found = in.value("seed");
  std::uint64_t seed = 0;
  if (found != nullptr) {
    const auto read = seed_in(*found);
    if (!read)
      in.reject("seed", "must be a whole number of at most 64 bits", "give a value such as \"0x2012\" or 8210");
    seed = read.value_or(0);
  }
  in.write("seed", seed_text(seed));
  return seed;
}

/// Whether the sweep changes what stands at `place`, or something within it.
bool is_swept(const Json* sweep, std::string_view place) {
  if (sweep == nullptr || !sweep->is_array()) return false;
  return std::any_of(sweep->begin(), sweep->end(), [place](const Json& axis) {
    if (!axis.is_object() || !axis.contains("parameter") || !axis["parameter"].is_string()) return false;
    const auto& pointer = axis["parameter"].get_ref<const std::string&>();
    return is_within(pointer, place) || is_within(place, pointer);
  });
}

DefaultSpelling unless_swept(const Json* sweep, std::span<const std::string_view> places) {
  const bool swept = std::any_of(places.begin(), places.end(), [sweep](auto place) { return is_swept(sweep, place); });
  return swept ? DefaultSpelling::as_written : DefaultSpelling::all;
}
DefaultSpelling unless_swept(const Json* sweep, std::initializer_list<std::string_view> places) {
  return unless_swept(sweep, std::span(places.begin(), places.size()));
}

}  // namespace

Question read_question(const Json& document, GroundMotionFiles& files, Problems& problems) {
  Question question;
  Condition& condition = question.condition;
  ObjectReader in(document, "", problems);
  read_format(in);
  question.title = in.text("title", "");
  const Json* sweep = in.value("sweep");
  const DefaultSpelling strobe = unless_swept(sweep, {"/block", "/excitation/kind"});
  condition.scene =
      read_scene(in, {.options = unless_swept(sweep, {"/formulation"}), .of_recorded = strobe, .files = files});
  condition.horizon =
      read_horizon(in, condition.scene, unless_swept(sweep, horizon_follows_from(condition.scene.excitation)));
  in.object("accuracy", [&condition](ObjectReader& keys) {
    condition.tolerance = keys.number("tolerance", rules::tolerance.with_default(condition.tolerance));
    condition.rerun_every =
        static_cast<std::uint64_t>(keys.integer("rerun_every", rules::rerun_every.with_default(condition.rerun_every)));
  });
  if (sweep != nullptr) in.write("sweep", *sweep);
  read_realisations(in, condition);
  read_label_check(in, condition);
  condition.confidence = in.number("confidence", rules::confidence.with_default(condition.confidence));
  question.seed = read_seed(in);
  question.canonical = in.finish();
  return question;
}

}  // namespace rocking

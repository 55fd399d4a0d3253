#include "rocking/report/read_question.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "rocking/report/read_quantity.hpp"
#include "rocking/report/read_scene.hpp"
#include "rocking/report/record_horizon.hpp"
#include "rocking/report/rules.hpp"
#include "rocking/report/sweep.hpp"

namespace rocking::report {
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

experiment::Horizon read_horizon(ObjectReader& in, const experiment::Scene& scene, DefaultSpelling spelling) {
  const bool recorded = !is_periodic(scene.excitation);
  const std::int64_t transient = recorded ? 0 : *rules::transient_periods.standard;
  const std::int64_t sampled = recorded ? periods_under_record(scene) : *rules::sampled_periods.standard;
  experiment::Horizon horizon;
  in.object("horizon", [&](ObjectReader& keys) {
    horizon.transient_periods =
        static_cast<int>(keys.derived_integer("transient_periods", rules::transient_periods, transient, spelling));
    if (sampled > rules::sampled_periods.high && !keys.has("sampled_periods")) {
      keys.reject("sampled_periods",
                  "would be " + std::to_string(sampled) + ", until the block rests after the ground motion",
                  "lower \"frequency_ratio\", so that strobe periods are longer, or give at most 1000000");
      return;
    }
    horizon.sampled_periods =
        static_cast<int>(keys.derived_integer("sampled_periods", rules::sampled_periods, sampled, spelling));
  });
  return horizon;
}

void read_until(ObjectReader& in, experiment::Condition& condition) {
  in.object("realisations", [&condition](ObjectReader& keys) {
    keys.object("until", [&condition](ObjectReader& goal) {
      condition.until = experiment::Until{.half_width = goal.number("half_width", rules::half_width)};
      condition.realisations = static_cast<std::uint64_t>(goal.integer("at_most", rules::at_most));
    });
  });
}

void read_realisations(ObjectReader& in, experiment::Condition& condition) {
  const Json* found = in.value("realisations");
  if (found != nullptr && found->is_object()) return read_until(in, condition);
  condition.realisations = static_cast<std::uint64_t>(in.integer("realisations", rules::realisations));
}

void read_label_check(ObjectReader& in, experiment::Condition& condition) {
  if (!in.has("check_labels")) return;
  in.object("check_labels", [&condition](ObjectReader& keys) {
    condition.label_check = experiment::LabelCheck{
        .every = static_cast<std::uint64_t>(keys.integer("every", rules::check_every)),
        .times_longer = static_cast<std::uint64_t>(keys.integer("times_longer", rules::times_longer))};
  });
  if (condition.until) {
    in.reject("check_labels", "has no valid correction if the data determine the number of realisations",
              "give a number of realisations");
  }
  const std::int64_t longer =
      std::int64_t{condition.horizon.sampled_periods} * static_cast<std::int64_t>(condition.label_check->times_longer);
  if (longer > rules::sampled_periods.high) {
    in.reject("check_labels", "would sample " + std::to_string(longer) + " periods", "lower \"times_longer\"");
  }
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

DefaultSpelling unless_swept(const Json* sweep, std::initializer_list<std::string_view> places) {
  const bool swept = std::any_of(places.begin(), places.end(), [sweep](auto place) { return is_swept(sweep, place); });
  return swept ? DefaultSpelling::as_written : DefaultSpelling::all;
}

}  // namespace

Question read_question(const Json& document, MotionFiles& files, Problems& problems) {
  Question question;
  experiment::Condition& condition = question.condition;
  ObjectReader in(document, "", problems);
  read_format(in);
  question.title = in.text("title", "");
  const Json* sweep = in.value("sweep");
  const DefaultSpelling strobe = unless_swept(sweep, {"/block", "/excitation/kind"});
  condition.scene =
      read_scene(in, {.options = unless_swept(sweep, {"/formulation"}), .of_record = strobe, .files = files});
  // A harmonic horizon follows from nothing but the kind of the excitation.
  const DefaultSpelling horizon =
      is_periodic(condition.scene.excitation)
          ? unless_swept(sweep, {"/excitation/kind"})
          : unless_swept(sweep, {"/block", "/formulation", "/restitution", "/excitation/kind",
                                 "/excitation/time_step_s", "/excitation/frequency_ratio"});
  condition.horizon = read_horizon(in, condition.scene, horizon);
  in.object("accuracy", [&condition](ObjectReader& keys) {
    condition.tolerance = keys.number("tolerance", rules::tolerance);
    condition.repeat_every = static_cast<std::uint64_t>(keys.integer("repeat_every", rules::repeat_every));
  });
  if (sweep != nullptr) in.write("sweep", *sweep);
  read_realisations(in, condition);
  read_label_check(in, condition);
  condition.confidence = in.number("confidence", rules::confidence);
  question.seed = read_seed(in);
  question.canonical = in.finish();
  return question;
}

}  // namespace rocking::report

#include "rocking/report/read_question.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "rocking/report/read_quantity.hpp"
#include "rocking/report/read_scene.hpp"
#include "rocking/report/rules.hpp"

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

experiment::Horizon read_horizon(ObjectReader& in) {
  experiment::Horizon horizon;
  in.object("horizon", [&horizon](ObjectReader& keys) {
    horizon.transient_periods = static_cast<int>(keys.integer("transient_periods", rules::transient_periods));
    horizon.sampled_periods = static_cast<int>(keys.integer("sampled_periods", rules::sampled_periods));
  });
  return horizon;
}

std::uint64_t read_realisations(ObjectReader& in) {
  const Json* found = in.value("realisations");
  if (found != nullptr && found->is_object() && found->contains("until")) {
    in.reject("realisations", "stopping at a width of the interval is not available in this version",
              "give a number such as 200");
    return 1;
  }
  return static_cast<std::uint64_t>(in.integer("realisations", rules::realisations));
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

OptionSpelling spelling_for(const Json* sweep) {
  if (sweep == nullptr || !sweep->is_array()) return OptionSpelling::all;
  const bool swept = std::any_of(sweep->begin(), sweep->end(), [](const Json& axis) {
    return axis.is_object() && axis.contains("parameter") && axis["parameter"] == "/formulation";
  });
  return swept ? OptionSpelling::as_written : OptionSpelling::all;
}

}  // namespace

Question read_question(const Json& document, Problems& problems) {
  Question question;
  experiment::Condition& condition = question.condition;
  ObjectReader in(document, "", problems);
  read_format(in);
  question.title = in.text("title", "");
  const Json* sweep = in.value("sweep");
  condition.scene = read_scene(in, spelling_for(sweep));
  condition.horizon = read_horizon(in);
  in.object("accuracy",
            [&condition](ObjectReader& keys) { condition.tolerance = keys.number("tolerance", rules::tolerance); });
  if (sweep != nullptr) in.write("sweep", *sweep);
  condition.realisations = read_realisations(in);
  condition.confidence = in.number("confidence", rules::confidence);
  question.seed = read_seed(in);
  question.canonical = in.finish();
  return question;
}

}  // namespace rocking::report

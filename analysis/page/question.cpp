#include "analysis/page/question.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "analysis/overview.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "analysis/quantity.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/input/excitation_words.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_listed = 4;

std::string number(const Json& value) {
  return value.is_number() ? significant(value.get<double>(), 6) : escaped(brief(value));
}

/// Geometry of the mean block, from which the other numbers are computed.
struct Shape {
  double width, height, gravity;
  [[nodiscard]] double shape_angle() const { return std::atan2(width, height); }
  [[nodiscard]] double half_diagonal() const { return 0.5 * std::hypot(width, height); }
  [[nodiscard]] double frequency_parameter() const { return std::sqrt(0.75 * gravity / half_diagonal()); }
};

Shape shape_of(const Json& experiment) {
  const Json& block = experiment.at("block");
  return {.width = mean_of(block.at("width_m")),
          .height = mean_of(block.at("height_m")),
          .gravity = block.at("gravity_m_s2")};
}

bool is_swept(const RunReport& report, const std::string& pointer) {
  for (const std::string& swept : report.swept) {
    if (swept == pointer || pointer.starts_with(swept + '/')) return true;
  }
  return false;
}

std::string swept_mark(const RunReport& report, const std::string& pointer) {
  return is_swept(report, pointer) ? " (swept)" : "";
}

std::string shaking_in_brief(const RunReport& report) {
  const Json& excitation = report.experiment.at("excitation");
  const auto kind = excitation.at("kind").get<std::string>();
  std::string text = fmt::format("on a base that {}", excitation_in_words(kind));
  if (excitation.contains("file")) return text + " in " + escaped(excitation.at("file").get<std::string>());
  if (excitation.contains("shape") && !is_swept(report, "/excitation/shape")) {
    text += fmt::format(" ({})", escaped(excitation.at("shape").get<std::string>()));
  }
  if (!is_swept(report, "/excitation/amplitude")) {
    text += fmt::format(" with amplitude {} = {}", symbol_html("A_h"), number(excitation.at("amplitude")));
  }
  if (!is_swept(report, "/excitation/frequency_ratio")) {
    const double ratio = excitation.at("frequency_ratio");
    const double hertz = ratio * shape_of(report.experiment).frequency_parameter() / (2.0 * std::numbers::pi);
    text +=
        fmt::format(" at {} = {} ({} Hz)", "<i>&Omega;</i><sub>h</sub>", significant(ratio, 6), significant(hertz, 3));
  }
  return text;
}

std::string friction_in_brief(const RunReport& report) {
  const Json& experiment = report.experiment;
  std::string text;
  if (!experiment.contains("friction")) {
    text = "It cannot slide.";
  } else if (is_swept(report, "/friction")) {
    text = "It can slide.";
  } else {
    const Json& friction = experiment["friction"];
    text = fmt::format("It can slide: static friction {}{}, kinetic {}{}.", number(friction.at("static")),
                       swept_mark(report, "/friction/static"), number(friction.at("kinetic")),
                       swept_mark(report, "/friction/kinetic"));
  }
  if (!experiment.contains("fluctuation")) return text + " Nothing is random.";
  std::string what;
  for (const auto& [name, scatter] : experiment["fluctuation"].items()) {
    std::string spoken = name;
    for (char& c : spoken) c = c == '_' ? ' ' : c;
    what += (what.empty() ? "" : ", ") + escaped(spoken);
    if (scatter.contains("sigma")) what += " with &sigma; = " + number(scatter["sigma"]);
    if (scatter.contains("relative_sigma")) what += " with relative &sigma; = " + number(scatter["relative_sigma"]);
  }
  return text + (what.empty() ? "" : " Random: " + what + '.');
}

/// The distinct values of an entry of the sweep, in order.
std::vector<Json> values_of(const RunReport& report, std::size_t entry) {
  std::vector<Json> values;
  std::set<std::string> seen;
  for (const ConditionReport& condition : report.conditions) {
    const Json& value = condition.parameters[entry];
    if (seen.insert(value.dump()).second) values.push_back(value);
  }
  return values;
}

std::string sweep_in_brief(const RunReport& report) {
  std::string text;
  for (std::size_t entry = 0; entry < report.swept.size(); ++entry) {
    const std::string& pointer = report.swept[entry];
    const Axis axis = axis_of_parameter(pointer);
    const auto values = values_of(report, entry);
    const auto spoken = [&](const Json& value) { return escaped(short_value(pointer, value)); };
    text += (text.empty() ? "" : "; ") + escaped(axis.quantity);
    if (!axis.symbol.empty()) text += ' ' + symbol_html(axis.symbol);
    if (values.size() <= most_listed) {
      for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? " " : ", ") + spoken(values[i]);
    } else {
      text += fmt::format(" from {} to {} ({} values)", spoken(values.front()), spoken(values.back()), values.size());
    }
  }
  return text;
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), value);
}

/// Adds a row for every setting below a place of the experiment.
void add_settings(const RunReport& report, const std::string& pointer, const Json& value, std::string& rows) {
  if (value.is_object()) {
    for (const auto& [key, part] : value.items()) {
      add_settings(report, child_pointer(pointer, key), part, rows);
    }
    return;
  }
  rows +=
      row(pointer, escaped(value.is_string() ? value.get<std::string>() : brief(value)) + swept_mark(report, pointer));
}

std::string horizon_in_brief(const RunReport& report) {
  if (!report.periods()) return "each as long as the base moves, and until the block has come to rest";
  const Json& horizon = report.experiment.at("horizon");
  return fmt::format("{} of transient, then {} sampled",
                     counted(horizon.at("transient_periods").get<std::uint64_t>(), "period"),
                     number(horizon.at("sampled_periods")));
}

}  // namespace

std::string question_in_brief(const RunReport& report) {
  const Json& block = report.experiment.at("block");
  std::string text =
      fmt::format("<p>A block {} m wide and {} m high stands {}. {}</p>\n", spoken_quantity(block.at("width_m")),
                  spoken_quantity(block.at("height_m")), shaking_in_brief(report), friction_in_brief(report));
  const std::string sweep = sweep_in_brief(report);
  if (!sweep.empty()) text += fmt::format("<p>Swept: {}.</p>\n", sweep);
  return text + fmt::format("<p>{}, {} in all; {}.</p>\n", counted(report.conditions.size(), "condition"),
                            counted(realisations_of(report), "realisation"), horizon_in_brief(report));
}

std::string question_in_full(const RunReport& report) {
  const Shape shape = shape_of(report.experiment);
  std::string rows;
  rows += row("shape angle", fmt::format("&psi; = {} rad", significant(shape.shape_angle(), 4)));
  rows += row("half diagonal", fmt::format("<i>R</i> = {} m", significant(shape.half_diagonal(), 4)));
  rows += row("frequency parameter", fmt::format("<i>p</i> = {} rad/s", significant(shape.frequency_parameter(), 4)));
  for (const auto& [key, value] : report.experiment.items()) {
    if (key != "format" && key != "title" && key != "sweep") {
      add_settings(report, child_pointer("", key), value, rows);
    }
  }
  return fmt::format(
      "<dl class=\"settings\">\n{}</dl>\n<details><summary>The experiment file, with every default written "
      "out</summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
      rows, escaped(report.experiment.dump(2)));
}

}  // namespace rocking::analysis

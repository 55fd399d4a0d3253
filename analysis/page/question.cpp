#include "analysis/page/sections.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/page/html.hpp"
#include "analysis/page/question_values.hpp"
#include "analysis/page/words.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_listed = 4;

/// `0.5 to 2`: a side of the blocks of all conditions; of random ones that of the first.
std::string side_in_words(const Report& report, Quantity SceneBlock::*side) {
  const auto side_of = [side](const auto& each) { return each.asked.scene.block.*side; };
  if (std::ranges::any_of(report.conditions, [&](const auto& each) { return is_drawn(side_of(each)); })) {
    return quantity_in_words(side_of(report.conditions.front()));
  }
  return over_conditions(report, 6, [&](const auto& each) { return mean_of(side_of(each)); });
}

/// Of its outline, or where the mass is laid out otherwise of the mean numbers of the first condition.
std::string block_in_brief(const Report& report) {
  const SceneBlock& asked = report.conditions.front().asked.scene.block;
  if (std::holds_alternative<UniformMass>(asked.mass)) {
    return fmt::format("{} m wide{} and {} m high{}", side_in_words(report, &SceneBlock::width),
                       swept_mark(report, "/block/width_m"), side_in_words(report, &SceneBlock::height),
                       swept_mark(report, "/block/height_m"));
  }
  if (std::holds_alternative<GivenSlenderness>(asked.mass)) {
    return fmt::format("with p = {} rad/s{} and ψ = {} rad{}",
                       of_block(report, 6, &dynamics::Geometry::frequency_parameter),
                       swept_mark(report, "/block/p_rad_s"), of_block(report, 6, &dynamics::Geometry::shape_angle),
                       swept_mark(report, "/block/slenderness_rad"));
  }
  const dynamics::Block block = mean_of(asked);
  const auto number = [](double metres) { return significant(metres, 4); };
  return fmt::format(
      "with its centre of mass {} m above its base, {} m from the left and {} m from the right edge, and a radius of "
      "gyration of {} m,",
      number(block.mass->centre_height), number(block.mass->left_edge), number(block.mass->right_edge),
      number(block.mass->radius_of_gyration));
}

std::string shaking_in_brief(const Report& report) {
  const Scene& scene = report.conditions.front().asked.scene;
  std::string text =
      fmt::format("on a base that {}", std::visit([](const auto& kind) { return kind.in_words; }, scene.excitation));
  const Json& excitation = report.input.experiment.at("excitation");
  if (excitation.contains("file")) return text + " in " + escaped(excitation.at("file").get<std::string>());
  if (excitation.contains("suite")) {
    return fmt::format("{} in a suite of {}", text, counted(excitation.at("suite").size(), "ground motion"));
  }
  if (excitation.contains("shape") && !is_swept(report, "/excitation/shape")) {
    text += fmt::format(" ({})", escaped(excitation.at("shape").get<std::string>()));
  }
  const std::vector<NamedPlace> drawn = drawn_once(scene);
  for (const std::string_view key : common_keys(report)) {
    const std::string pointer = "/excitation/" + std::string(key);
    if (is_swept(report, pointer)) continue;
    text += is_amplitude(key) ? " with amplitude " : key == "period_s" ? " at a period of " : " at ";
    text += both_forms_html(report, key);
    if (std::ranges::find(drawn, pointer, &NamedPlace::place) != drawn.end()) text += " on average";
  }
  const auto has_random_block = [](const auto& each) { return is_drawn(each.asked.scene.block); };
  const bool is_of_mean = std::ranges::any_of(report.conditions, has_random_block);
  return text + (is_of_mean && report.conditions.front().shaking ? " for the mean block" : "");
}

/// What each realisation draws, `friction with &sigma; = 0.03, phase`; empty if nothing is random.
std::string random_in_brief(const Report& report) {
  std::vector<std::string> parts;
  const Json sources = report.input.experiment.value("fluctuation", Json::object());
  for (const auto& [name, scatter] : sources.items()) {
    std::string& words = parts.emplace_back(escaped(name));
    std::ranges::replace(words, '_', ' ');
    for (const auto& [key, format] :
         {std::pair("sigma", " with &sigma; = {}"), std::pair("relative_sigma", " with relative &sigma; = {}"),
          std::pair("law", ", law {}"), std::pair("correlation", ", correlation {}"),
          std::pair("refresh_slip_m", ", of the place: drawn for each {} m of slip")}) {
      if (!scatter.contains(key)) continue;
      const std::string place = "/fluctuation/" + name + '/' + key;
      words += fmt::format(fmt::runtime(format), setting_html(report, place, scatter.at(key)));
      words += swept_mark(report, place);
    }
  }
  std::set<std::string_view> drawn;
  for (const ReportedCondition& condition : report.conditions) {
    for (const NamedPlace& each : drawn_once(condition.asked.scene)) {
      if (drawn.insert(each.place).second) parts.emplace_back(each.name);
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string friction_in_brief(const Report& report) {
  const std::optional<Friction>& friction = report.conditions.front().asked.scene.friction;
  const std::string random = random_in_brief(report);
  const std::string what = random.empty() ? " Nothing is random." : " Random: " + random + '.';
  if (is_swept(report, "/friction")) return "It can slide." + what;
  if (!friction) return "It cannot slide." + what;
  return fmt::format("It can slide: static friction {}{}, kinetic {}{}.{}",
                     quantity_in_words(friction->static_coefficient), swept_mark(report, "/friction/static"),
                     friction->kinetic_ratio ? quantity_in_words(*friction->kinetic_ratio) + " of it"
                                             : quantity_in_words(friction->kinetic_coefficient),
                     swept_mark(report, "/friction/kinetic"), what);
}

/// `base amplitude A_h 4, 4.5`, or `from 4 to 6 (21 values)`: an entry of the sweep, its values in order.
std::string entry_in_brief(const Report& report, std::size_t entry) {
  const Axis axis = axis_of_parameter(report.swept[entry]);
  const std::string name = escaped(axis.quantity) + (axis.symbol.empty() ? "" : ' ' + symbol_html(axis.symbol));
  const bool is_named = !report.conditions.front().asked.parameters[entry].name.empty();
  const std::string unit = axis.unit.empty() || is_named ? "" : ' ' + escaped(axis.unit);
  std::vector<std::string> values;
  std::set<SweptValue> seen;
  for (const ReportedCondition& condition : report.conditions) {
    const Parameter& parameter = condition.asked.parameters[entry];
    if (seen.insert(parameter.value).second) values.push_back(escaped(short_value(parameter)));
  }
  if (values.size() <= most_listed) return fmt::format("{} {}{}", name, fmt::join(values, ", "), unit);
  return fmt::format("{} from {} to {}{} ({} values)", name, values.front(), values.back(), unit, values.size());
}

std::string sweep_in_brief(const Report& report) {
  std::string text;
  for (std::size_t entry = 0; entry < report.swept.size(); ++entry) {
    const std::string& pointer = report.swept[entry];
    if (report.has_suite() && pointer == "/excitation/file") continue;  // the suite is told of above
    text += (text.empty() ? "" : "; ") + entry_in_brief(report, entry);
    for (const std::string_view key : common_keys(report)) {
      if (pointer == "/excitation/" + std::string(key)) text += other_form_html(report, key);
    }
  }
  return text.empty() ? "" : "<p>Swept: " + text + ".</p>\n";
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), value);
}

/// A row for every setting below a place of the experiment.
std::string setting_rows(const Report& report, const std::string& pointer, const Json& value) {
  if (!value.is_object()) return row(pointer, setting_html(report, pointer, value) + swept_mark(report, pointer));
  std::string rows;
  for (const auto& [key, part] : value.items()) {
    const bool is_shown = !pointer.empty() || (key != "format" && key != "title" && key != "sweep");
    if (is_shown) rows += setting_rows(report, child_pointer(pointer, key), part);
  }
  return rows;
}

std::string horizon_in_brief(const Report& report) {
  if (!std::ranges::all_of(report.conditions, &ReportedCondition::states_horizon)) {
    return "each as long as the base moves, and until the block has come to rest";
  }
  const auto periods = [&report](int Horizon::*part) {
    return over_conditions(report, 10, [part](const auto& each) { return each.asked.horizon.*part; });
  };
  const std::string transient = periods(&Horizon::transient_periods);
  return fmt::format("{} {} of transient, then {} sampled", transient, transient == "1" ? "period" : "periods",
                     periods(&Horizon::sampled_periods));
}

/// At which tilt the block is in balance.
std::string balance_in_words(const Report& report) {
  constexpr double degree = std::numbers::pi / 180.0;
  const std::string left = of_edge(report, 3, 0, &dynamics::Edge::shape_angle, degree);
  const std::string right = of_edge(report, 3, 1, &dynamics::Edge::shape_angle, degree);
  return fmt::format("It is in balance at a tilt of &psi; = {} degrees{}.", left,
                     left == right ? "" : fmt::format(" on the left edge, {} on the right", right));
}

/// The impacts, what a suite is, and how much was run.
std::string further_question(const Report& report) {
  std::string text = fmt::format("<p>{}. {}</p>\n", escaped(impacts_text(report)), balance_in_words(report));
  if (report.has_suite()) {
    text +=
        "<p>Each ground motion stands for one earthquake. Its realisations show what is random in the block; the "
        "differences between ground motions show what differs between earthquakes.</p>\n";
  }
  std::vector<std::string> lines = ground_motion_lines(report.ground_motions);
  for (std::string& line : lines) {
    line = escaped(line) + '.';
    line.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(line.front())));
  }
  if (!lines.empty()) text += fmt::format("<p>{}</p>\n", fmt::join(lines, " "));
  if (const std::string floor = floor_in_words(report); !floor.empty()) {
    text += fmt::format("<p>The block stands {}.</p>\n", escaped(floor));
  }
  return text + fmt::format("<p>{}, {} in all; {}.</p>\n", counted(report.conditions.size(), "condition"),
                            counted(realisations_of(report), "realisation"), horizon_in_brief(report));
}

}  // namespace

std::string question_at_once(const Report& report) {
  const auto& wall = report.conditions.front().asked.scene.block.wall;
  return fmt::format("<p>A block {} stands {}{}. {}</p>\n{}", block_in_brief(report),
                     wall ? fmt::format("at a wall on its {}, ", to_string(*wall)) : "", shaking_in_brief(report),
                     friction_in_brief(report), sweep_in_brief(report));
}

std::string question_in_brief(const Report& report) { return question_at_once(report) + further_question(report); }

std::string question_in_full(const Report& report) {
  using dynamics::Edge, dynamics::Geometry;
  std::string rows = row("shape angle", fmt::format("&psi; = {} rad", of_block(report, 4, &Geometry::shape_angle)));
  if (has_unlike_edges(report)) {
    const auto angle = [&report](std::size_t side) { return of_edge(report, 4, side, &Edge::shape_angle); };
    const auto uplift = [&report](std::size_t side) { return of_edge(report, 4, side, &Edge::tangent); };
    rows =
        row("shape angles",
            fmt::format(
                "&psi; = {} rad at the left edge, {} rad at the right edge; &Theta; is the tilt over that of its side",
                angle(0), angle(1))) +
        row("uplift", fmt::format("base above {} g to the right, or {} g to the left", uplift(0), uplift(1)));
  }
  rows += row("half diagonal", fmt::format("<i>R</i> = {} m", of_block(report, 4, &Geometry::half_diagonal)));
  rows += row("frequency parameter",
              fmt::format("<i>p</i> = {} rad/s", of_block(report, 4, &Geometry::frequency_parameter)));
  for (const std::string_view key : common_keys(report)) {
    rows += row(is_amplitude(key) ? "amplitude of the base" : "frequency of the base", both_forms_html(report, key));
  }
  const std::string settings = setting_rows(report, "", report.input.experiment);
  return further_question(report) + "<dl class=\"settings\">\n" + rows + "</dl>\n" +
         folded("All settings", "<dl class=\"settings\">\n" + settings + "</dl>\n") +
         folded("The experiment file, with every default written out",
                "<pre tabindex=\"0\">" + escaped(report.input.experiment.dump(2)) + "</pre>\n");
}

}  // namespace rocking::analysis

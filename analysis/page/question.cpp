#include "analysis/page/sections.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "analysis/quantity.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_listed = 4;

/// A number of each condition.
template <class Number>
Spread spread_over(const Report& report, Number&& number_of_condition) {
  std::vector<double> numbers;
  for (const ReportedCondition& condition : report.conditions) numbers.push_back(number_of_condition(condition));
  return spread_of(numbers);
}

dynamics::Geometry geometry_in(const ReportedCondition& condition) {
  return dynamics::geometry_of(mean_block(condition.asked.scene));
}

/// Of an edge of the mean block, 0 left and 1 right.
Spread of_edges(const Report& report, std::size_t side, double dynamics::Edge::*number) {
  return spread_over(report, [&](const auto& each) { return geometry_in(each).edges[side].*number; });
}

bool is_swept(const Report& report, const std::string& pointer) {
  return std::ranges::any_of(
      report.swept, [&](const std::string& swept) { return swept == pointer || pointer.starts_with(swept + '/'); });
}

std::string swept_mark(const Report& report, const std::string& pointer) {
  return is_swept(report, pointer) ? " (swept)" : "";
}

/// A form of the shaking over all conditions; absent if one of them has none.
std::optional<Spread> shaking_spread(const Report& report, std::string_view key) {
  if (!std::ranges::all_of(report.conditions, [](const auto& each) { return each.shaking.has_value(); })) return {};
  return spread_over(report, [key](const auto& each) { return number_of(*each.shaking, key); });
}

/// `A_h = 4.5`, `1.1 g`, `0.5 to 1.1 g` in HTML.
std::string form_html(std::string_view key, const Spread& spread, int digits) {
  const std::string text = spread_in_words(spread, digits);
  if (key == "amplitude") return symbol_html("A_h") + " = " + text;
  if (key == "frequency_ratio") return "<i>&Omega;</i><sub>h</sub> = " + text;
  if (key == "amplitude_m_s2") return text + " m/s<sup>2</sup>";
  return in_unit(key, text);
}

/// The amplitude or the frequency as the file gives it, with the other form: `A_h = 4.5 (1.1 g)`. Empty if conditions
/// differ in the kind of their shaking, or have ground motions.
std::string both_forms_html(const Report& report, std::string_view Shaking::*given) {
  const auto& first = report.conditions.front().shaking;
  if (!first) return "";
  const std::string_view key = (*first).*given;
  const auto is_given = [&](const ReportedCondition& each) { return each.shaking && (*each.shaking).*given == key; };
  if (!std::ranges::all_of(report.conditions, is_given)) return "";
  const std::string_view other = other_form_of(key);
  return fmt::format("{} ({})", form_html(key, shaking_spread(report, key).value(), 6),
                     form_html(other, shaking_spread(report, other).value(), 3));
}

/// Whether each realisation has a block of its own size, so that one of the forms is that of the mean block.
bool has_random_block(const Report& report) {
  return std::ranges::any_of(report.conditions, [](const auto& each) { return is_drawn(each.asked.scene.block); });
}

/// `0.5 to 2 m wide (swept)`: a side of the blocks of all conditions.
std::string side_in_brief(const Report& report, Quantity SceneBlock::*side, const std::string& pointer,
                          std::string_view word) {
  const auto in_words = [&](const std::string& size) {
    return fmt::format("{} m {}{}", size, word, swept_mark(report, pointer));
  };
  const auto is_random = [&](const auto& each) { return is_drawn(each.asked.scene.block.*side); };
  if (std::ranges::any_of(report.conditions, is_random)) {
    return in_words(quantity_in_words(report.conditions.front().asked.scene.block.*side));
  }
  const auto mean = [&](const auto& each) { return mean_of(each.asked.scene.block.*side); };
  return in_words(spread_in_words(spread_over(report, mean), 6));
}

/// Of its outline, or where the mass is laid out otherwise of the mean numbers of the first condition.
std::string block_in_brief(const Report& report) {
  const SceneBlock& asked = report.conditions.front().asked.scene.block;
  if (std::holds_alternative<UniformMass>(asked.mass)) {
    return side_in_brief(report, &SceneBlock::width, "/block/width_m", "wide") + " and " +
           side_in_brief(report, &SceneBlock::height, "/block/height_m", "high");
  }
  if (std::holds_alternative<GivenSlenderness>(asked.mass)) {
    const auto spread = [&report](double dynamics::Geometry::*number) {
      return spread_in_words(
          spread_over(report,
                      [&](const auto& each) { return dynamics::geometry_of(mean_of(each.asked.scene.block)).*number; }),
          6);
    };
    return fmt::format("with p = {} rad/s{} and ψ = {} rad{}", spread(&dynamics::Geometry::frequency_parameter),
                       swept_mark(report, "/block/p_rad_s"), spread(&dynamics::Geometry::shape_angle),
                       swept_mark(report, "/block/slenderness_rad"));
  }
  const dynamics::Block block = mean_of(asked);
  const auto number = [](double metres) { return base::significant(metres, 4); };
  return fmt::format(
      "with its centre of mass {} m above its base, {} m from the left and {} m from the right edge, and a radius of "
      "gyration of {} m,",
      number(block.mass->centre_height), number(block.mass->left_edge), number(block.mass->right_edge),
      number(block.mass->radius_of_gyration));
}

std::string shaking_in_brief(const Report& report) {
  const Json& excitation = report.input.experiment.at("excitation");
  const auto kind = excitation.at("kind").get<std::string>();
  std::string text = fmt::format("on a base that {}", excitation_in_words(kind));
  if (excitation.contains("file")) return text + " in " + escaped(excitation.at("file").get<std::string>());
  if (excitation.contains("suite")) {
    return fmt::format("{} in a suite of {}", text, counted(excitation.at("suite").size(), "ground motion"));
  }
  if (excitation.contains("shape") && !is_swept(report, "/excitation/shape")) {
    text += fmt::format(" ({})", escaped(excitation.at("shape").get<std::string>()));
  }
  const auto stands = [&](std::string_view key) {
    return excitation.contains(key) && !is_swept(report, "/excitation/" + std::string(key));
  };
  for (const ShakingNumber& each : shaking_numbers) {
    if (!stands(each.key)) continue;
    const bool is_amplitude = each.key.starts_with("amplitude");
    const std::string both =
        both_forms_html(report, is_amplitude ? &Shaking::given_amplitude : &Shaking::given_frequency);
    const Json& given = excitation.at(std::string(each.key));
    const double written = mean_of(quantity_in(given));
    text += is_amplitude ? " with amplitude " : each.key == "period_s" ? " at a period of " : " at ";
    text += both.empty() ? form_html(each.key, {.low = written, .high = written}, 6) : both;
    if (has_law(given)) text += " on average";
  }
  return text + (has_random_block(report) && report.conditions.front().shaking ? " for the mean block" : "");
}

/// The values of a setting in all conditions: `0.8 to 1.2`, or the first few; if it is not swept, its value.
std::string setting_text(const Report& report, const std::string& pointer, const Json& value) {
  const auto text_of = [](const Json& one) { return one.is_string() ? one.get<std::string>() : brief(one); };
  if (!is_swept(report, pointer)) return text_of(value);
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const ReportedCondition& condition : report.conditions) {
    const Json own = value_at(report, condition, pointer);
    if (own.is_null()) continue;
    if (own.is_number()) numbers.push_back(own);
    const std::string text = text_of(own);
    if (texts.size() <= most_listed && std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
  }
  if (numbers.size() == report.conditions.size()) return spread_in_words(spread_of(numbers), 6);
  std::string list;
  for (std::size_t i = 0; i < std::min(texts.size(), most_listed); ++i) list += (i == 0 ? "" : ", ") + texts[i];
  return texts.size() > most_listed ? list + ", ..." : list;
}

/// What each realisation draws, `friction with &sigma; = 0.03, phase`; empty if nothing is random.
std::string random_in_brief(const Report& report) {
  std::string what;
  const auto add = [&what](const std::string& words) { what += (what.empty() ? "" : ", ") + words; };
  const Json sources = report.input.experiment.value("fluctuation", Json::object());
  for (const auto& [name, scatter] : sources.items()) {
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    words = escaped(words);
    for (const auto& [key, format] :
         {std::pair("sigma", " with &sigma; = {}{}"), std::pair("relative_sigma", " with relative &sigma; = {}{}"),
          std::pair("law", ", law {}{}"), std::pair("correlation", ", correlation {}{}"),
          std::pair("refresh_slip_m", ", of the place: drawn for each {} m of slip{}")}) {
      if (!scatter.contains(key)) continue;
      const std::string place = "/fluctuation/" + name + '/' + key;
      words += fmt::format(fmt::runtime(format), escaped(setting_text(report, place, scatter.at(key))),
                           swept_mark(report, place));
    }
    add(words);
  }
  std::set<std::string_view> drawn;
  for (const ReportedCondition& condition : report.conditions) {
    for (const NamedPlace& each : drawn_once(condition.asked.scene)) {
      if (drawn.insert(each.place).second) add(std::string(each.name));
    }
  }
  return what;
}

std::string friction_in_brief(const Report& report) {
  const std::optional<Friction>& friction = report.conditions.front().asked.scene.friction;
  std::string text;
  if (is_swept(report, "/friction")) {
    text = "It can slide.";
  } else if (!friction) {
    text = "It cannot slide.";
  } else {
    const auto in_words = [](const Quantity& number) { return escaped(quantity_in_words(number)); };
    const std::string kinetic = friction->kinetic_ratio ? in_words(*friction->kinetic_ratio) + " of it"
                                                        : in_words(friction->kinetic_coefficient);
    text = fmt::format("It can slide: static friction {}{}, kinetic {}{}.", in_words(friction->static_coefficient),
                       swept_mark(report, "/friction/static"), kinetic, swept_mark(report, "/friction/kinetic"));
  }
  const std::string random = random_in_brief(report);
  return text + (random.empty() ? " Nothing is random." : " Random: " + random + '.');
}

/// The distinct values of an entry of the sweep, in order.
std::vector<Json> values_of(const Report& report, std::size_t entry) {
  std::vector<Json> values;
  std::set<SweptValue> seen;
  for (const ReportedCondition& condition : report.conditions) {
    const Parameter& parameter = condition.asked.parameters[entry];
    if (seen.insert(parameter.value).second) values.push_back(json_of(parameter.value));
  }
  return values;
}

std::string sweep_in_brief(const Report& report) {
  std::string text;
  for (std::size_t entry = 0; entry < report.swept.size(); ++entry) {
    const std::string& pointer = report.swept[entry];
    if (report.has_suite() && pointer == "/excitation/file") continue;  // the suite is told of above
    const Axis axis = axis_of_parameter(pointer);
    const auto values = values_of(report, entry);
    const std::string unit = axis.unit.empty() ? "" : ' ' + escaped(axis.unit);
    const auto in_words = [&](const Json& value) { return escaped(short_value(pointer, value)); };
    text += (text.empty() ? "" : "; ") + escaped(axis.quantity);
    if (!axis.symbol.empty()) text += ' ' + symbol_html(axis.symbol);
    if (values.size() <= most_listed) {
      for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? " " : ", ") + in_words(values[i]);
      text += unit;
    } else {
      text += fmt::format(" from {} to {}{} ({} values)", in_words(values.front()), in_words(values.back()), unit,
                          values.size());
    }
    for (const ShakingNumber& each : shaking_numbers) {
      if (pointer != "/excitation/" + std::string(each.key)) continue;
      const std::string_view other = other_form_of(each.key);
      if (const auto spread = shaking_spread(report, other)) text += " (" + form_html(other, *spread, 3) + ')';
    }
  }
  return text;
}

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), value);
}

/// Adds a row for every setting below a place of the experiment.
void add_settings(const Report& report, const std::string& pointer, const Json& value, std::string& rows) {
  if (value.is_object()) {
    for (const auto& [key, part] : value.items()) {
      add_settings(report, child_pointer(pointer, key), part, rows);
    }
    return;
  }
  rows += row(pointer, escaped(setting_text(report, pointer, value)) + swept_mark(report, pointer));
}

std::string horizon_in_brief(const Report& report) {
  const auto states = [](const ReportedCondition& condition) { return condition.states_horizon; };
  if (!std::ranges::all_of(report.conditions, states)) {
    return "each as long as the base moves, and until the block has come to rest";
  }
  const auto spread = [&report](int Horizon::*periods) {
    return spread_over(report,
                       [periods](const auto& each) { return static_cast<double>(each.asked.horizon.*periods); });
  };
  const Spread transient = spread(&Horizon::transient_periods);
  return fmt::format("{} of transient, then {} sampled",
                     transient.is_one() ? counted(static_cast<std::uint64_t>(transient.low), "period")
                                        : spread_in_words(transient, 6) + " periods",
                     spread_in_words(spread(&Horizon::sampled_periods), 6));
}

/// At which tilt the block is in balance.
std::string balance_in_words(const Report& report) {
  constexpr double degree = std::numbers::pi / 180.0;
  const auto of_side = [&report](std::size_t side) {
    Spread spread = of_edges(report, side, &dynamics::Edge::shape_angle);
    spread.low /= degree, spread.high /= degree;
    return spread_in_words(spread, 3);
  };
  const std::string left = of_side(0), right = of_side(1);
  return left == right
             ? fmt::format("It is in balance at a tilt of &psi; = {} degrees.", left)
             : fmt::format("It is in balance at a tilt of &psi; = {} degrees on the left edge, {} on the right.", left,
                           right);
}

/// The impacts, what a suite is, and how much was run.
std::string further_question(const Report& report) {
  std::string text = fmt::format("<p>{}. {}</p>\n", escaped(impacts_text(report)), balance_in_words(report));
  if (report.has_suite()) {
    text +=
        "<p>Each ground motion stands for one earthquake. Its realisations show what is random in the block; the "
        "differences "
        "between ground motions show what differs between earthquakes.</p>\n";
  }
  const std::vector<std::string> lines = ground_motion_lines(report.ground_motions);
  for (const std::string& line : lines) {
    std::string sentence = escaped(line);
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    text +=
        fmt::format("{}{}.{}", &line == lines.data() ? "<p>" : " ", sentence, &line == &lines.back() ? "</p>\n" : "");
  }
  if (const std::string floor = floor_in_words(report); !floor.empty()) {
    text += fmt::format("<p>The block stands {}.</p>\n", escaped(floor));
  }
  return text + fmt::format("<p>{}, {} in all; {}.</p>\n", counted(report.conditions.size(), "condition"),
                            counted(realisations_of(report), "realisation"), horizon_in_brief(report));
}

}  // namespace

std::string question_at_once(const Report& report) {
  const std::string sweep = sweep_in_brief(report);
  return fmt::format("<p>A block {} stands {}. {}</p>\n{}", block_in_brief(report), shaking_in_brief(report),
                     friction_in_brief(report), sweep.empty() ? "" : fmt::format("<p>Swept: {}.</p>\n", sweep));
}

std::string question_in_brief(const Report& report) { return question_at_once(report) + further_question(report); }

std::string question_in_full(const Report& report) {
  const auto in_words = [&](double dynamics::Geometry::*number) {
    return spread_in_words(spread_over(report, [=](const auto& each) { return geometry_in(each).*number; }), 4);
  };
  std::string rows;
  if (has_unlike_edges(report)) {
    const auto of_edge = [&](std::size_t side, double dynamics::Edge::*number) {
      return spread_in_words(of_edges(report, side, number), 4);
    };
    rows +=
        row("shape angles",
            fmt::format(
                "&psi; = {} rad at the left edge, {} rad at the right edge; &Theta; is the tilt over that of its side",
                of_edge(0, &dynamics::Edge::shape_angle), of_edge(1, &dynamics::Edge::shape_angle)));
    rows += row("uplift", fmt::format("base above {} g to the right, or {} g to the left",
                                      of_edge(0, &dynamics::Edge::tangent), of_edge(1, &dynamics::Edge::tangent)));
  } else {
    rows += row("shape angle", fmt::format("&psi; = {} rad", in_words(&dynamics::Geometry::shape_angle)));
  }
  rows += row("half diagonal", fmt::format("<i>R</i> = {} m", in_words(&dynamics::Geometry::half_diagonal)));
  rows += row("frequency parameter",
              fmt::format("<i>p</i> = {} rad/s", in_words(&dynamics::Geometry::frequency_parameter)));
  const std::string amplitude = both_forms_html(report, &Shaking::given_amplitude);
  const std::string frequency = both_forms_html(report, &Shaking::given_frequency);
  if (!amplitude.empty()) rows += row("amplitude of the base", amplitude);
  if (!frequency.empty()) rows += row("frequency of the base", frequency);
  for (const auto& [key, value] : report.input.experiment.items()) {
    if (key != "format" && key != "title" && key != "sweep") {
      add_settings(report, child_pointer("", key), value, rows);
    }
  }
  return further_question(report) +
         fmt::format(
             "<dl class=\"settings\">\n{}</dl>\n<details><summary>The experiment file, with every default written "
             "out</summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
             rows, escaped(report.input.experiment.dump(2)));
}

}  // namespace rocking::analysis

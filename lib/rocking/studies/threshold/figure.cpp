#include <algorithm>
#include <set>
#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// A condition at its value of the number on the x axis.
struct DrawnThreshold {
  double x;
  const ThresholdBands* found;
};

/// Conditions with the same values of all but the number on the x axis.
struct ThresholdPanel {
  std::vector<Parameter> others;
  std::vector<DrawnThreshold> conditions;
};

/// The place of the other swept number with the most values; absent where none has several.
std::optional<std::size_t> place_of_axis(const std::vector<ThresholdOfCondition>& conditions) {
  std::optional<std::size_t> found;
  std::size_t most = 1;
  for (std::size_t k = 0; k < conditions.front().parameters.size(); ++k) {
    std::set<double> values;
    for (const ThresholdOfCondition& condition : conditions) {
      if (const auto value = number_in(condition.parameters[k].value)) values.insert(*value);
    }
    if (values.size() > most && number_in(conditions.front().parameters[k].value)) found = k, most = values.size();
  }
  return found;
}

std::vector<ThresholdPanel> panels_over(std::size_t axis, const std::vector<ThresholdOfCondition>& conditions) {
  std::vector<ThresholdPanel> panels;
  for (const ThresholdOfCondition& condition : conditions) {
    const auto x = number_in(condition.parameters[axis].value);
    if (!x) continue;
    std::vector<Parameter> others = condition.parameters;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(axis));
    auto panel = std::ranges::find(panels, others, &ThresholdPanel::others);
    if (panel == panels.end()) panel = panels.insert(panel, {.others = std::move(others), .conditions = {}});
    panel->conditions.push_back({*x, &condition.found});
  }
  for (ThresholdPanel& panel : panels) std::ranges::stable_sort(panel.conditions, {}, &DrawnThreshold::x);
  return panels;
}

std::vector<SpanAround> spans_of(const std::vector<DrawnThreshold>& conditions) {
  std::vector<double> places;
  for (const DrawnThreshold& condition : conditions) places.push_back(condition.x);
  return spans_around(places);
}

/// Columns: the number on the x axis, low and high of each band, and the ends of the area that is drawn.
Table band_table(const std::vector<DrawnThreshold>& conditions, const Column& x) {
  Table table{.name = "bands",
              .columns = {x,
                          {"low", "smallest value of the band"},
                          {"high", "largest value of the band"},
                          {"x_low", "left end of the area"},
                          {"x_high", "right end of the area"}}};
  const std::vector<SpanAround> spans = spans_of(conditions);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (const auto& [low, high] : conditions[i].found->bands) {
      table.rows.push_back({conditions[i].x, low, high, spans[i].low, spans[i].high});
    }
  }
  return table;
}

/// Without a value where nothing happens, or the range begins within a band.
Table threshold_line(const std::vector<DrawnThreshold>& conditions, const Column& x) {
  Table table{.name = "threshold", .columns = {x, {"threshold", "smallest value with the event"}}};
  for (const DrawnThreshold& condition : conditions) {
    const bool is_known = !condition.found->bands.empty() && !condition.found->begins_inside();
    table.rows.push_back({condition.x, is_known ? Cell(condition.found->bands.front()[0]) : Cell()});
  }
  return table;
}

void add_panel(const ThresholdPanel& panel, const ThresholdQuestion& question, const Axis& x, Figure& figure) {
  Axis y = axis_of_parameter(question.of);
  y.low = question.from;
  y.high = question.to;
  const std::vector<SpanAround> spans = spans_of(panel.conditions);
  figure.panels.push_back({.title = values_in_words(panel.others), .x = x, .y = std::move(y)});
  figure.panels.back().x.low = spans.front().low;
  figure.panels.back().x.high = spans.back().high;
  const Column column{"x", label_of(x)};
  const std::string event = what_happens(question);
  Table bands = band_table(panel.conditions, column);
  if (!bands.rows.empty()) {
    const Style area = ribbon_of(style_of(section::ResponseMode{.kind = section::ResponseKind::overturned}), 0.6);
    draw(std::move(bands), {.kind = LayerKind::boxes, .style = area, .legend = event},
         {"x_low", "x_high", "low", "high"}, figure);
  }
  draw(threshold_line(panel.conditions, column),
       {.kind = LayerKind::line, .style = {.colour = "#000000", .size = 0.0}, .legend = "threshold"}, {}, figure);
}

}  // namespace

std::optional<Figure> threshold_figure(const ThresholdReport& report) {
  const ThresholdStudy& study = report.study;
  const auto axis = place_of_axis(study.conditions);
  if (!axis) return std::nullopt;
  const std::vector<ThresholdPanel> panels = panels_over(*axis, study.conditions);
  const Axis x = axis_of_parameter(study.conditions.front().parameters[*axis].pointer);
  Figure figure;
  figure.name = "threshold";
  figure.title =
      study.question.event.is_overturning() ? "Overturning spectrum" : "Spectrum of " + words_of(study.question.event);
  figure.subtitle = report.input.title();
  for (std::size_t i = 0; i < std::min(panels.size(), most_slices); ++i) {
    add_panel(panels[i], study.question, x, figure);
  }
  figure.caption = "Areas: the block " + what_happens(study.question) +
                   ". Each stands around one computed value of the x axis; its ends were " +
                   (study.question.probability ? "found to within their 95 % intervals" : "bisected") +
                   ". White between areas of one value: the block stands again. A band or a gap narrower than a step "
                   "of the scan may be missing.";
  if (panels.size() > most_slices) {
    figure.caption +=
        " Of " + counted(panels.size(), "combination") + " the first " + std::to_string(most_slices) + " are drawn.";
  }
  return figure;
}

}  // namespace rocking::analysis

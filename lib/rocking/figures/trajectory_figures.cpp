#include "rocking/figures/trajectory_figures.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "rocking/figures/palette.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using dynamics::EventKind;

const Column time_column{"time", "time since the start [excitation periods]"};

std::string described(const TrajectoryFile& file) {
  return file.name + ": condition " + std::to_string(file.condition) + ", realisation " +
         std::to_string(file.realisation);
}

/// `end`: of the longest trajectory; one that ends before the window leaves the first period of the window empty.
Axis time_axis(const Window& window, double end) {
  return {.quantity = "time",
          .unit = "excitation periods",
          .low = window.from,
          .high = window.from < end ? std::min(window.to, end) : std::min(window.to, window.from + 1.0)};
}

std::string described_end(const TrajectoryFile& file) {
  return described(file) + " ends at " + significant(file.history.back().time, 4) + " periods";
}

/// ` a.json: ... ends at 12.3 periods, before the first one shown.`, for each trajectory of which that is true.
std::string words_on_ended(const std::vector<TrajectoryFile>& files, const Window& window) {
  std::string text;
  for (const TrajectoryFile& file : files) {
    if (!file.history.empty() && file.history.back().time < window.from) {
      text += ' ' + described_end(file) + ", before the first one shown.";
    }
  }
  return text;
}

bool is_within(double time, const Window& window) { return window.from <= time && time <= window.to; }

Table history_table(const TrajectoryFile& file, const Window& window) {
  Table table{.name = described(file),
              .columns = {time_column,
                          {"tilt", "Θ = θ/ψ, ψ of its side"},
                          {"tilt_rate", "Θ′ = dΘ/dτ"},
                          {"slip", "X, slip over the half diagonal R"}}};
  for (const HistoryRow& row : file.history) {
    if (is_within(row.time, window)) table.rows.push_back({row.time, row.tilt, row.tilt_rate, row.slip});
  }
  return table;
}

/// The path in the plane (Theta, Theta'), with a row without numbers before each impact, where Theta' jumps.
Table path_table(const TrajectoryFile& file, const Window& window) {
  Table table{.name = "path of " + described(file), .columns = {{"tilt", "Θ"}, {"tilt_rate", "Θ′"}, time_column}};
  auto event = file.events.begin();
  for (const HistoryRow& row : file.history) {
    bool jumps = false;
    for (; event != file.events.end() && event->time <= row.time; ++event) {
      jumps = jumps || event->kind == EventKind::impact_stick || event->kind == EventKind::impact_slip;
    }
    if (!is_within(row.time, window)) continue;
    if (jumps && !table.rows.empty()) table.rows.push_back({Cell(), Cell(), row.time});
    table.rows.push_back({row.tilt, row.tilt_rate, row.time});
  }
  return table;
}

/// Strobe points.
Table strobe_table(const TrajectoryFile& file, const Window& window) {
  Table table{.name = "strobe points of " + described(file),
              .columns = {{"tilt", "Θ"}, {"tilt_rate", "Θ′"}, {"period", "period at whose end the state is taken"}}};
  for (const StrobeRow& row : file.strobe) {
    if (is_within(row.period, window)) table.rows.push_back({row.tilt, row.tilt_rate, row.period});
  }
  return table;
}

double size_of_markers(const TrajectoryFile& file) { return file.strobe.size() > 2000 ? 0.2 : 0.5; }

Table span_table(const TrajectoryFile& file, std::string_view contact, const Window& window) {
  Table table{.name = "stretches of " + std::string(contact),
              .columns = {{"from", time_column.meaning}, {"to", time_column.meaning}}};
  for (const ContactSpan& span : file.contacts) {
    if (to_string(span.contact) != contact || span.to <= window.from || window.to <= span.from) continue;
    table.rows.push_back({std::max(span.from, window.from), std::min(span.to, window.to)});
  }
  return table;
}

Table impact_table(const TrajectoryFile& file, std::string_view kind, const Window& window) {
  Table table{.name = std::string(kind), .columns = {time_column, {"tilt", "Θ"}}};
  for (const EventRow& event : file.events) {
    if (to_string(event.kind) == kind && is_within(event.time, window)) table.rows.push_back({event.time, 0.0});
  }
  return table;
}

/// Adds a table and a layer of it in the first panels, so many, unless the table has no rows.
void add_unless_empty(Table table, Layer layer, std::size_t panels, Figure& figure) {
  if (table.rows.empty()) return;
  layer.table = figure.tables.size();
  figure.tables.push_back(std::move(table));
  for (std::size_t i = 0; i < panels; ++i) draw(layer, {}, figure, i);
}

void shade_contacts(const TrajectoryFile& file, const Window& window, Figure& figure) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> contact_shades{
      {{"rest", "at rest"}, {"slide", "sliding"}, {"rock_slide", "rocking and sliding"}, {"overturned", "overturned"}}};
  for (const auto& [contact, words] : contact_shades) {
    add_unless_empty(span_table(file, contact, window),
                     {.kind = LayerKind::spans, .style = style_of_contact(contact), .legend = std::string(words)}, 2,
                     figure);
  }
}

void mark_impacts(const TrajectoryFile& file, const Window& window, Figure& figure) {
  add_unless_empty(
      impact_table(file, "impact_stick", window),
      {.kind = LayerKind::points, .style = {.marker = 6, .width = 1.2, .size = 0.7}, .legend = "impact that sticks"}, 1,
      figure);
  add_unless_empty(impact_table(file, "impact_slip", window),
                   {.kind = LayerKind::points,
                    .style = {.colour = "#d55e00", .marker = 2, .width = 1.5, .size = 0.8},
                    .legend = "impact that slips"},
                   1, figure);
}

}  // namespace

Figure time_history(const TrajectoryFile& file, const Window& window) {
  Figure figure{.name = "time_history",
                .title = "Tilt and slip against time",
                .subtitle = file.history.back().time < window.from ? described_end(file) : described(file),
                .arrangement = Arrangement::stacked};
  const Axis time = time_axis(window, file.history.back().time);
  figure.panels.push_back({.x = time, .y = {"tilt", "Θ", ""}, .height = 1.2});
  figure.panels.push_back({.x = time, .y = {"slip", "X", ""}});
  figure.tables.push_back(history_table(file, window));
  shade_contacts(file, window, figure);
  const Style curve{.colour = "#000000", .marker = 0, .width = 1.6};
  draw({.kind = LayerKind::line, .style = curve}, {"time", "slip"}, figure);
  draw({.kind = LayerKind::line, .style = curve, .legend = "response"}, {}, figure, 0);
  mark_impacts(file, window, figure);
  figure.caption =
      "Tilt Θ = θ/ψ, over ψ of its side, and slip X (over the half diagonal R) of one realisation. Shaded: any state "
      "other than rocking without slip; white: rocking without slip. Impacts are marked at Θ = 0." +
      words_on_ended({file}, window);
  return figure;
}

Figure responses(const std::vector<TrajectoryFile>& files, const Window& window) {
  Figure figure{.name = "responses", .title = "Responses of several realisations"};
  double end = 0.0;
  for (const TrajectoryFile& file : files) end = std::max(end, file.history.back().time);
  figure.panels.push_back({.x = time_axis(window, end), .y = {"tilt", "Θ", ""}});
  for (std::size_t i = 0; i < files.size(); ++i) {
    Style style = style_of_curve(i);
    style.marker = 0;
    draw(history_table(files[i], window), {.kind = LayerKind::line, .style = style, .legend = described(files[i])}, {},
         figure);
  }
  figure.caption = "Tilt Θ = θ/ψ, over ψ of its side, of " + std::to_string(files.size()) +
                   " realisations against time." + words_on_ended(files, window);
  return figure;
}

Figure phase_portrait(const std::vector<TrajectoryFile>& files, const Window& window) {
  Figure figure{.name = "phase_portrait", .title = "Phase portrait"};
  if (files.size() == 1) figure.subtitle = described(files.front());
  figure.panels.push_back({.x = {"tilt", "Θ", ""}, .y = {"tilt rate", "Θ′", ""}});
  for (std::size_t i = 0; i < files.size(); ++i) {
    Style style = style_of_curve(i);
    style.marker = 0;
    style.dash = 1;
    style.width = 1.0;
    const std::string legend = files.size() > 1 ? described(files[i]) : "";
    draw(path_table(files[i], window), {.kind = LayerKind::line, .style = style, .legend = legend}, {}, figure);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    Style style = files.size() > 1 ? style_of_curve(i) : Style{.colour = "#d55e00"};
    style.size = size_of_markers(files[i]);
    const std::string legend = files.size() > 1 ? "" : "once an excitation period";
    draw(strobe_table(files[i], window), {.kind = LayerKind::points, .style = style, .legend = legend}, {}, figure);
  }
  figure.caption =
      "Path (Θ, Θ′) of each realisation, where Θ = θ/ψ with ψ of its side, interrupted at impacts, where Θ′ jumps; "
      "points: once an excitation period." +
      words_on_ended(files, window);
  return figure;
}

Figure poincare(const std::vector<TrajectoryFile>& files, const Window& window) {
  Figure figure{.name = "poincare", .title = "Poincaré section"};
  figure.panels.push_back({.x = {"tilt", "Θ", ""}, .y = {"tilt rate", "Θ′", ""}});
  for (std::size_t i = 0; i < files.size(); ++i) {
    Style style = style_of_curve(i);
    style.size = size_of_markers(files[i]);
    draw(strobe_table(files[i], window), {.kind = LayerKind::points, .style = style, .legend = described(files[i])}, {},
         figure);
  }
  figure.caption = "States (Θ, Θ′) once an excitation period" +
                   (window.from > 0.0 ? ", from period " + number_text(window.from) + " on." : std::string(".")) +
                   words_on_ended(files, window);
  return figure;
}

}  // namespace rocking::analysis

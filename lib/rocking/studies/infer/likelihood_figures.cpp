#include <algorithm>
#include <limits>
#include <utility>

#include "rocking/figures/shaded_map.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr const char* estimate_colour = "#d55e00";

constexpr std::array<ShadeClass, 7> classes{{{0.5, "0.5 to 1"},
                                             {0.2, "0.2 to 0.5"},
                                             {0.1, "0.1 to 0.2"},
                                             {0.05, "0.05 to 0.1"},
                                             {0.02, "0.02 to 0.05"},
                                             {0.01, "0.01 to 0.02"},
                                             {0.0, "below 0.01"}}};

std::string level_of(const InferReport& report) { return level_text(report.confidence) + " %"; }

std::vector<double> grid_of(const ReportedUnknown& unknown) {
  std::vector<double> grid;
  for (const infer::ProfilePoint& point : unknown.profile) grid.push_back(point.at);
  return grid;
}

Axis axis_of(const ReportedUnknown& unknown) {
  Axis axis = axis_of_parameter(unknown.parameter);
  axis.low = unknown.profile.front().at;
  axis.high = unknown.profile.back().at;
  return axis;
}

/// With the estimate, which may lie between the points.
Table profile_table(const ReportedUnknown& unknown, const Column& value) {
  Table table{.name = "profile likelihood of " + value.meaning,
              .columns = {value, {"likelihood_ratio", "largest likelihood with this value over the largest one"}}};
  const auto rest =
      std::ranges::find_if(unknown.profile, [&](const auto& point) { return point.at >= *unknown.estimate; });
  for (auto point = unknown.profile.begin(); point != rest; ++point) {
    table.rows.push_back({point->at, point->likelihood_ratio});
  }
  if (rest == unknown.profile.end() || rest->at > *unknown.estimate) table.rows.push_back({*unknown.estimate, 1.0});
  for (auto point = rest; point != unknown.profile.end(); ++point) {
    table.rows.push_back({point->at, point->likelihood_ratio});
  }
  return table;
}

/// One row: the estimate with its interval.
Table estimate_table(const InferReport& report, const ReportedUnknown& unknown, const Column& value) {
  const std::string level = level_of(report);
  Table table{.name = value.meaning,
              .columns = {{"estimate", "most likely value", level + " interval"},
                          {"low", "lower end of its " + level + " interval"},
                          {"high", "upper end of its " + level + " interval"}},
              .rows = {{*unknown.estimate, unknown.interval->low, unknown.interval->high}}};
  if (!unknown.posterior) return table;
  const UnknownPosterior& posterior = *unknown.posterior;
  add_estimate(table, {"posterior_mean", "mean with the priors", level + " posterior interval"});
  table.rows.front().insert(table.rows.front().end(),
                            {posterior.mean, posterior.interval.low, posterior.interval.high});
  return table;
}

void add_profile(const InferReport& report, const ReportedUnknown& unknown, Figure& figure) {
  const Axis axis = axis_of(unknown);
  const Column value{last_key(unknown.parameter), label_of(axis)};
  figure.panels.push_back({.x = axis, .y = {.quantity = "likelihood ratio", .low = 0.0, .high = 1.05}});
  draw(estimate_table(report, unknown, value),
       {.kind = LayerKind::spans, .style = {.colour = "#c6dbef"}, .legend = level_of(report) + " interval"},
       {"low", "high"}, figure);
  add_drawn(profile_table(unknown, value),
            {.kind = LayerKind::line,
             .style = {.colour = "#08306b", .marker = 0},
             .legend = "likelihood over the largest one"},
            figure);
  add_drawn({.name = "estimate of " + value.meaning,
             .columns = {value, {"likelihood_ratio", "1, the largest one"}},
             .rows = {{*unknown.estimate, 1.0}}},
            {.kind = LayerKind::points, .style = {.colour = estimate_colour}, .legend = "estimate"}, figure);
}

std::string unknown_in_words(const ReportedUnknown& unknown) {
  const std::string text = answer_in_words(unknown);
  if (!unknown.posterior) return text;
  return text + ", with the priors mean " + significant(unknown.posterior->mean, 3) + ' ' +
         interval_in_words(unknown.posterior->interval);
}

/// Halfway between the points; the first and last cells end at theirs.
std::vector<double> edges_between(const std::vector<double>& grid) {
  std::vector<double> edges{grid.front()};
  for (std::size_t i = 1; i < grid.size(); ++i) edges.push_back(0.5 * (grid[i - 1] + grid[i]));
  edges.push_back(grid.back());
  return edges;
}

/// The largest likelihood ratio of the region at each point of the grid of two unknowns.
ShadedMap map_of(const InferReport& report, std::size_t x, std::size_t y) {
  const std::vector<double> across = grid_of(report.unknowns[x]);
  const std::vector<double> up = grid_of(report.unknowns[y]);
  ShadedMap map{
      .x_edges = edges_between(across),
      .y_edges = edges_between(up),
      .numbers = std::vector(up.size(), std::vector(across.size(), std::numeric_limits<double>::quiet_NaN()))};
  for (const infer::RegionPoint& point : report.region) {
    const auto column = std::ranges::find(across, point.at[x]);
    const auto row = std::ranges::find(up, point.at[y]);
    if (column == across.end() || row == up.end()) continue;  // the estimate may lie between the points
    double& number =
        map.numbers[static_cast<std::size_t>(row - up.begin())][static_cast<std::size_t>(column - across.begin())];
    if (!(number >= point.likelihood_ratio)) number = point.likelihood_ratio;
  }
  return map;
}

void add_pair(const InferReport& report, std::size_t x, std::size_t y, Figure& figure) {
  const Axis across = axis_of(report.unknowns[x]);
  const Axis up = axis_of(report.unknowns[y]);
  figure.panels.push_back({.x = across, .y = up});
  const std::string name = across.quantity + " and " + up.quantity;
  add_shades(map_of(report, x, y),
             {.quantity = "likelihood ratio",
              .columns = {{"x_from", label_of(across) + ", from"},
                          {"x_to", label_of(across) + ", to"},
                          {"y_from", label_of(up) + ", from"},
                          {"y_to", label_of(up) + ", to"}},
              .classes = classes},
             name, figure);
  add_drawn({.name = name + ", estimate",
             .columns = {{"x", label_of(across)}, {"y", label_of(up)}},
             .rows = {{*report.unknowns[x].estimate, *report.unknowns[y].estimate}}},
            {.kind = LayerKind::points, .style = {.colour = estimate_colour}, .legend = "estimate"}, figure);
}

}  // namespace

/// The likelihood over the largest one against each unknown, with the intervals and the estimate; a panel for each
/// unknown. Needs an answer.
static Figure profile_figure(const InferReport& report) {
  Figure figure{
      .name = "infer_profile", .title = "Which values explain the counted tests?", .subtitle = report.input.title()};
  for (const ReportedUnknown& unknown : report.unknowns) {
    add_profile(report, unknown, figure);
    if (explains_counts(report)) figure.subtitle += (figure.subtitle.empty() ? "" : "; ") + answer_in_words(unknown);
    figure.description += (figure.description.empty() ? "Estimates: " : "; ") + unknown_in_words(unknown);
  }
  figure.description += ".\nIdentified: " + identified_in_words(report) + ".\nFit: " + fit_in_words(report) + '.';
  if (const auto too_few = too_few_realisations(report)) figure.description += "\nWarning: " + *too_few + '.';
  figure.caption = "Likelihood of the counts over the largest one";
  if (report.unknowns.size() > 1) figure.caption += ", at each value the largest over the other unknowns";
  figure.caption +=
      "; the " + level_of(report) +
      " interval of the unknown is shaded. Its ends are where tests made up at that value would seldom be so unlikely.";
  return figure;
}

/// The joint region of two or three unknowns as a map of the likelihood over the largest one, with the estimate; a
/// panel for each pair. Needs an answer.
static Figure region_figure(const InferReport& report) {
  Figure figure{.name = "infer_region",
                .title = "Which values together explain the counted tests?",
                .subtitle = report.input.title()};
  for (std::size_t x = 0; x < report.unknowns.size(); ++x) {
    for (std::size_t y = x + 1; y < report.unknowns.size(); ++y) add_pair(report, x, y, figure);
  }
  figure.caption = "Joint region with " + level_of(report) +
                   " confidence: where the likelihood of the counts over the largest one is at least " +
                   significant(*report.region_limit, 2);
  if (report.unknowns.size() > 2) figure.caption += "; of a pair the largest over the third unknown";
  figure.caption += ". Point: estimate.";
  return figure;
}

std::vector<Figure> infer_figures(const InferReport& report) {
  std::vector<Figure> figures;
  if (!report.fit) return figures;
  figures.push_back(profile_figure(report));
  if (report.unknowns.size() > 1) figures.push_back(region_figure(report));
  figures.push_back(fit_figure(report));
  if (auto candidates = candidates_figure(report)) figures.push_back(std::move(*candidates));
  return figures;
}

}  // namespace rocking::analysis

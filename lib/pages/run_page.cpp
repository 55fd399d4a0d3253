#include "pages/run_page.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "analysis/page/words.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/text/files.hpp"

namespace rocking::pages {
namespace {

using section::ResponseMode;

constexpr std::size_t most_motions = 6;
constexpr std::uint64_t most_searched = 50'000;  ///< realisations of a condition in which a mode is looked for
constexpr std::int64_t longest_run = 10'000;     ///< periods that are computed again for a page

/// A realisation to show, and its response.
struct Choice {
  RealisationKey key;
  ResponseMode mode;
};

/// The first realisation with this mode.
std::optional<Choice> first_with(const Store& store, std::size_t condition, std::uint64_t realisations,
                                 const ResponseMode& mode) {
  for (std::uint64_t number = 0; number < std::min(realisations, most_searched); ++number) {
    const RealisationKey key{.condition = condition, .realisation = number};
    const auto row = store.find(key);
    if (!row || row->mode != mode) continue;
    return Choice{.key = key, .mode = mode};
  }
  return std::nullopt;
}

/// Of each mode of a condition.
std::vector<Choice> choices_within(const Store& store, const Report& report, std::size_t condition) {
  std::vector<Choice> choices;
  for (const auto& [mode, probability] : report.conditions[condition].result.modes) {
    if (probability.counts.successes == 0 || choices.size() == most_motions) continue;
    if (auto choice = first_with(store, condition, report.conditions[condition].result.realisations, mode)) {
      choices.push_back(std::move(*choice));
    }
  }
  return choices;
}

/// Of each mode of the run, where it is most frequent; of equal conditions the last one, which is usually shaken most.
std::vector<Choice> choices_across(const Store& store, const Report& report) {
  std::vector<Choice> choices;
  for (const auto& [mode, count] : report.occurring()) {
    std::size_t where = 0;
    for (std::size_t i = 0; i < report.conditions.size(); ++i) {
      const double best = share_of(report.conditions[where], mode).estimate;
      if (share_of(report.conditions[i], mode).estimate >= best) where = i;
    }
    if (choices.size() == most_motions) break;
    if (auto choice = first_with(store, where, report.conditions[where].result.realisations, mode)) {
      choices.push_back(std::move(*choice));
    }
  }
  return choices;
}

}  // namespace

std::optional<std::string> animation_page_of(const Experiment& experiment, const RealisationKey& key,
                                             const TrajectoryExtent& extent) {
  const int samples = extent.samples_per_period;
  auto motion = animation_of(experiment, key,
                             {.periods = extent.periods,
                              .shown_periods = extent.periods,
                              .most_samples = analysis::most_samples_alone,
                              .samples_per_period = samples > 0 ? std::optional(samples) : std::nullopt,
                              .stop = extent.stop});
  if (!motion) return std::nullopt;
  motion->name = "condition " + std::to_string(key.condition) + ", " + motion->name;
  return analysis::animation_page_text(experiment.title, *motion);
}

analysis::ShownAnimations no_animations(const std::string& reason) {
  return {.explanation = "No realisation is shown: " + reason + '.', .motions = {}};
}

analysis::ShownAnimations animations_of(const Experiment& experiment, const Store& store, const Report& report) {
  analysis::ShownAnimations shown;
  const auto least = repeatability_of(report).least;
  const bool divided = least && report.conditions[*least].result.non_recurrence->differ > 0.0;
  const std::vector<Choice> choices = divided ? choices_within(store, report, *least) : choices_across(store, report);
  for (const Choice& choice : choices) {
    const std::int64_t periods = experiment.conditions.at(choice.key.condition).horizon.periods();
    if (periods > longest_run) continue;
    auto motion = animation_of(experiment, choice.key,
                               {.periods = periods,
                                .shown_periods = shown_periods(choice.mode),
                                .most_samples = analysis::most_samples_of_a_run,
                                .samples_per_period = {}});
    if (!motion) continue;
    motion->name = fmt::format(
        "{}: {}{}", to_string(choice.mode),
        divided || report.conditions.size() == 1 ? "" : analysis::condition_name(report, choice.key.condition) + ", ",
        motion->name);
    shown.motions.push_back(std::move(*motion));
  }
  if (shown.motions.empty()) return no_animations("a realisation is too long, or this program does not give its bits");
  const std::string what = "computed again from the seed.";
  shown.explanation =
      divided
          ? fmt::format(
                "Here the realisations differ most: {}. One realisation of each response mode that occurs there, {}",
                analysis::condition_name(report, *least), what)
          : "One realisation of each response mode, " + what;
  return shown;
}

std::vector<analysis::Drawing> write_page(const std::filesystem::path& file, const Report& report,
                                          std::vector<analysis::Figure> figures,
                                          const analysis::ShownAnimations& motions, base::StopRequest stop) {
  std::vector<analysis::DrawnFigure> drawn;
  std::vector<analysis::Drawing> failures;
  for (analysis::Figure& figure : figures) {
    analysis::Drawing drawing;
    std::string svg = analysis::picture_of(figure, "svg", drawing, stop);
    analysis::note_failure(drawing, failures);
    drawn.push_back({.figure = std::move(figure), .svg = std::move(svg)});
  }
  write_atomically(file, analysis::page_text(report, drawn, motions));
  return failures;
}

}  // namespace rocking::pages

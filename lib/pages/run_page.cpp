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
constexpr int smooth_samples = 48;               ///< samples per excitation period that look smooth
constexpr int most_samples_per_period = 400;     ///< where a period only counts time

std::int64_t horizon_of(const Condition& condition) {
  return std::int64_t{condition.horizon.transient_periods} + condition.horizon.sampled_periods;
}

int samples_per_period(bool periodic, const AnimationExtent& extent) {
  if (extent.samples_per_period) return *extent.samples_per_period;
  if (periodic) return smooth_samples;
  const auto affordable = static_cast<std::int64_t>(extent.most_samples) / extent.periods;
  return static_cast<int>(std::clamp<std::int64_t>(affordable, 1, most_samples_per_period));
}

/// The samples, and the end of an overturning. Times in seconds: tau/p.
std::vector<analysis::MotionSample> samples_of(const Trajectory& trajectory, double frequency_parameter) {
  std::vector<analysis::MotionSample> samples;
  for (const HistorySample& sample : trajectory.history) {
    samples.push_back({.time = sample.tau / frequency_parameter,
                       .tilt = sample.tilt,
                       .tilt_rate = sample.tilt_rate,
                       .slip = sample.slip,
                       .base_acceleration = sample.base_acceleration,
                       .contact = std::string(to_string(sample.contact))});
  }
  if (samples.empty() || trajectory.events.empty()) return samples;
  const TrajectoryEvent& last = trajectory.events.back();
  if (last.kind == dynamics::EventKind::overturn && last.tau / frequency_parameter > samples.back().time) {
    samples.push_back({.time = last.tau / frequency_parameter,
                       .tilt = last.tilt,
                       .tilt_rate = last.tilt_rate,
                       .slip = last.slip,
                       .base_acceleration = samples.back().base_acceleration,
                       .contact = std::string(to_string(dynamics::ContactState::overturned))});
  }
  return samples;
}

/// Drops the end of a motion where block and base are at rest, but for a twentieth of the rest.
void cut_rest(std::vector<analysis::MotionSample>& samples) {
  const auto moves = [](const analysis::MotionSample& sample) {
    return sample.contact != "rest" || sample.base_acceleration != 0.0;
  };
  const auto last = std::find_if(samples.rbegin(), samples.rend(), moves);
  const auto kept = static_cast<std::size_t>(samples.rend() - last);
  samples.resize(std::min(samples.size(), std::max<std::size_t>(kept + samples.size() / 20, 2)));
}

void keep_last(std::size_t number, std::vector<analysis::MotionSample>& samples) {
  if (samples.size() > number) samples.erase(samples.begin(), samples.end() - static_cast<std::ptrdiff_t>(number));
}

/// Periods to show of a response: a few of its own periods.
std::int64_t shown_periods(const ResponseMode& mode) {
  constexpr std::int64_t usual = 12;
  return std::max<std::int64_t>(usual, 3 * std::int64_t{mode.periods});
}

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

std::optional<analysis::Animation> animation_of(const Experiment& experiment, const RealisationKey& key,
                                                const AnimationExtent& extent) {
  const Condition& condition = experiment.conditions.at(key.condition);
  const bool periodic = is_periodic(condition.scene.excitation);
  const int samples = samples_per_period(periodic, extent);
  const Trajectory trajectory = trajectory_of(condition, experiment.seed, key.realisation,
                                              TrajectoryExtent(extent.periods, samples, extent.stop));
  if (trajectory.history.size() < 2) return std::nullopt;
  const dynamics::Geometry geometry = dynamics::geometry_of(trajectory.block);
  const double p = geometry.frequency_parameter;
  const double period = trajectory.history[1].tau * samples / p;
  analysis::Animation motion{
      .name = fmt::format("realisation {}", key.realisation),
      .command = fmt::format("rocking trajectory EXPERIMENT.json --condition {} --realisation {} --samples {}",
                             key.condition, key.realisation, samples),
      .block = trajectory.outline,
      .shape_angles = {geometry.edges[0].shape_angle, geometry.edges[1].shape_angle},
      .half_diagonal = geometry.half_diagonal,
      .period = periodic ? period : 0.0,
      .length = 0.0,
      .samples = samples_of(trajectory, p)};
  motion.length = motion.samples.back().time;
  if (periodic) {
    keep_last(static_cast<std::size_t>(extent.shown_periods) * static_cast<std::size_t>(samples) + 1, motion.samples);
  } else {
    cut_rest(motion.samples);
  }
  keep_last(extent.most_samples + 1, motion.samples);
  return motion;
}

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
    const std::int64_t periods = horizon_of(experiment.conditions.at(choice.key.condition));
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

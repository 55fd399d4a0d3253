// Error rate of the rule by which a response has settled: each realisation is run on to at_most_periods, whatever its
// response, and its settled mode is compared with the mode of most windows in the second half. The table is for
// reports/evidence/settling.md.
//
//     settling_evidence EXPERIMENT.json REALISATIONS

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rocking/input/read_experiment.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/realisation/horizon_run.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::evidence {
namespace {

using section::ResponseKind;
using section::ResponseMode;

bool is_classified(const ResponseMode& mode) { return mode.kind != ResponseKind::unresolved; }

/// Modes of the windows of a realisation, one after another, up to the limit or to overturning.
std::vector<ResponseMode> modes_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation) {
  const random::Draws draws(seed, realisation);
  const Start start = start_of(condition.scene, draws);
  const auto beginning = begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_window(condition));
  HorizonRun run(condition, draws, beginning,
                 [&](dynamics::Observer& observer) { return motion_of(condition.scene, beginning, observer); });
  run.observe_long_run();
  std::vector<ResponseMode> modes;
  for (bool goes_on = true; goes_on; modes.push_back(run.newest_mode())) {
    while (!run.motion().ended() || run.go_on()) integrate::step(run.motion(), run.counts());
    if (TangentRun* tangents = run.classify()) run_alone(*tangents, run.pending());
    goes_on = run.begin_next_window();
  }
  return modes;
}

/// The first of the `held` successive windows that give one mode; absent if there are none.
std::optional<std::size_t> settled_in(const std::vector<ResponseMode>& modes, std::size_t held) {
  for (std::size_t first = 0; first < modes.size(); ++first) {
    std::size_t same = first;
    while (same < modes.size() && same < first + held && modes[same] == modes[first]) ++same;
    const bool is_overturned = modes[first].kind == ResponseKind::overturned;
    if (is_classified(modes[first]) && (is_overturned || same == first + held)) return first;
  }
  return std::nullopt;
}

/// The mode of most classified windows in the second half, if it has at least nine tenths of them.
std::optional<ResponseMode> mode_in_the_end(const std::vector<ResponseMode>& modes, std::size_t all) {
  if (modes.back().kind == ResponseKind::overturned) return modes.back();
  std::map<ResponseMode, std::size_t> counts;
  std::size_t classified = 0;
  for (std::size_t i = all / 2; i < modes.size(); ++i) {
    if (!is_classified(modes[i])) continue;
    ++counts[modes[i]];
    ++classified;
  }
  for (const auto& [mode, count] : counts) {
    if (10 * count >= 9 * classified && 2 * classified >= all - all / 2) return mode;
  }
  return std::nullopt;
}

std::string share_of(std::uint64_t count, std::uint64_t of) {
  const auto interval = stats::clopper_pearson({count, of}, 0.95);
  char text[64];
  std::snprintf(text, sizeof text, "%llu of %llu [%.2f, %.2f %%]", static_cast<unsigned long long>(count),
                static_cast<unsigned long long>(of), 100.0 * interval.low, 100.0 * interval.high);
  return text;
}

void add_row(const Condition& condition, std::uint64_t seed, std::uint64_t realisations) {
  const Horizon& horizon = condition.horizon;
  const std::size_t all = static_cast<std::size_t>(
      1 + (horizon.until_classified->at_most_periods - horizon.transient_periods - horizon.sampled_periods) /
              horizon.sampled_periods);
  std::vector<std::vector<ResponseMode>> runs;
  for (std::uint64_t number = 0; number < realisations; ++number) runs.push_back(modes_of(condition, seed, number));
  std::string name;
  for (const auto& parameter : condition.parameters) name += (name.empty() ? "" : ", ") + short_value(parameter);
  for (std::size_t held = 1; held <= 3; ++held) {
    std::uint64_t settled = 0;
    std::uint64_t known = 0;
    std::uint64_t wrong = 0;
    std::uint64_t early = 0;
    std::uint64_t watched = 0;
    double periods = 0.0;
    for (const auto& modes : runs) {
      const auto first = settled_in(modes, held);
      const std::size_t used =
          first ? (modes[*first].kind == ResponseKind::overturned ? *first + 1 : *first + held) : modes.size();
      periods += static_cast<double>(horizon.transient_periods) +
                 static_cast<double>(used) * static_cast<double>(horizon.sampled_periods);
      if (!first) continue;
      ++settled;
      if (const auto end = mode_in_the_end(modes, all)) {
        ++known;
        wrong += *end == modes[*first] ? 0 : 1;
      }
      if (used + 5 > modes.size()) continue;
      ++watched;
      bool is_left = false;
      for (std::size_t i = used; i < used + 5; ++i)
        is_left = is_left || (is_classified(modes[i]) && modes[i] != modes[*first]);
      early += is_left ? 1 : 0;
    }
    std::printf("| %s | %zu | %llu of %llu | %s | %s | %.0f |\n", name.c_str(), held,
                static_cast<unsigned long long>(settled), static_cast<unsigned long long>(realisations),
                share_of(wrong, known).c_str(), share_of(early, watched).c_str(),
                periods / static_cast<double>(realisations));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace rocking::evidence

int main(int count, char** arguments) {
  using namespace rocking;
  if (count != 3) {
    std::fprintf(stderr, "usage: settling_evidence EXPERIMENT.json REALISATIONS\n");
    return 64;
  }
  try {
    const Experiment experiment = read_experiment_file(arguments[1]);
    std::printf("| condition | held_windows | settled | not the mode in the end | left within 5 windows | periods |\n");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    for (const Condition& condition : experiment.conditions) {
      if (!condition.horizon.until_classified)
        throw std::runtime_error("the experiment needs horizon.until_classified");
      evidence::add_row(condition, experiment.seed, std::strtoull(arguments[2], nullptr, 10));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 65;
  }
  return 0;
}

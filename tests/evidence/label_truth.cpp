// Labels of random scenes in which nothing is random along the way, beside where the motion goes in 20 000 periods and more.
// The table is in reports/evidence/classification-evidence.md.
//
//     label_truth SEED SCENES [FIRST]
//
// The truth does not share the classifier: the smallest number of periods after which all of the last points repeat to 1e-9,
// after 20 000, 40 000 or 80 000 periods; chaotic, quasi-periodic and longer periods are "no period up to 12".

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <optional>
#include <string>

#include "rocking/api/experiment.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/strobe_recorder.hpp"
#include "rocking/text/json.hpp"
#include "support/split_mix.hpp"

namespace rocking::evidence {
namespace {

using section::ResponseKind;
using support::SplitMix;

Json block_of(SplitMix& draw) {
  const double height = draw.uniform(2.0, 12.0);
  if (draw.below(4) != 0) return {{"width_m", 1.0}, {"height_m", height}};
  const double left = draw.uniform(0.35, 0.65);
  return {{"edges_m", {left, 1.0 - left}}, {"centre_height_m", 0.5 * height}, {"radius_of_gyration_m", 0.32 * height}};
}

/// Half of the scenes lose energy as Housner's block does, half less, down to a ratio of the rates of 0.995.
std::string scene_of(SplitMix& draw) {
  Json scene{{"format", "rocking.experiment/1"}, {"title", "a random scene"}, {"realisations", 1}};
  scene["block"] = block_of(draw);
  const double amplitude = std::exp(draw.uniform(0.0, 2.2));
  scene["excitation"] = {{"kind", "harmonic"}, {"amplitude", amplitude}, {"frequency_ratio", draw.uniform(3.0, 20.0)}};
  scene["accuracy"] = {{"tolerance", 1e-12}};
  scene["initial"] = {{"tilt", draw.uniform(-0.6, 0.6)}, {"tilt_rate", draw.uniform(-0.5, 0.5)}};
  const double height = scene["block"].value("height_m", 6.0);
  const double of_housner = 1.0 - 1.5 / (1.0 + height * height);
  if (draw.below(2) == 0) scene["restitution"] = {{"rate_ratio", draw.uniform(std::min(of_housner, 0.98), 0.995)}};
  const double friction = draw.uniform(0.15, 0.6);
  if (draw.below(3) == 0) scene["friction"] = {{"static", friction}, {"kinetic", 0.85 * friction}};
  return scene.dump();
}

/// Where a motion is after so many periods: the smallest n after which its last points repeat; 0: none up to 12.
struct End {
  int period = 0;
  int impacts = 0;  ///< in n periods
  bool moved = false;
  bool overturned = false;
};

End end_of(const Condition& condition) {
  const random::Draws draws(1, 0);
  const Start start = start_of(condition.scene, draws);
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, 1);
  StrobeRecorder recorder(beginning.setting.block, 20'000);
  Motion motion = motion_of(condition.scene, beginning, recorder);
  End end;
  for (const int periods : {20'000, 20'000, 40'000}) {
    recorder.forget();
    motion.extend(periods);
    integrate::advance(motion);
    if (motion.termination() != dynamics::Termination::reached_horizon) {
      end.overturned = motion.termination() == dynamics::Termination::overturned;
      return end;
    }
    const auto& all = recorder.periods();
    for (std::size_t n = 1; n <= 12; ++n) {
      double largest = 0.0;
      for (std::size_t k = all.size() - 60; k < all.size(); ++k) {
        largest = std::max(largest, section::distance(all[k].point, all[k - n].point));
      }
      if (largest > 1e-9) continue;
      end.period = static_cast<int>(n);
      for (std::size_t k = all.size() - n; k < all.size(); ++k) {
        end.impacts += all[k].impacts;
        end.moved = end.moved || all[k].moved;
      }
      return end;
    }
  }
  return end;
}

std::string name_of(const End& end) {
  if (end.overturned) return "overturned";
  if (end.period == 0) return "none";
  if (!end.moved) return "rest";
  return to_string(section::periodic((end.impacts + 1) / 2, end.period));
}

/// Whether a label and the truth agree; absent where the motion has no period up to 12, or the label is none.
std::string verdict(const section::ResponseMode& label, const std::string& truth) {
  if (label.kind == ResponseKind::unresolved) return "unresolved";
  const bool is_aperiodic = label.kind == ResponseKind::chaotic || label.kind == ResponseKind::quasi_periodic;
  if (is_aperiodic) return truth == "none" ? "right" : "wrong: " + to_string(label) + ", truth " + truth;
  return to_string(label) == truth ? "right" : "wrong: " + to_string(label) + ", truth " + truth;
}

void run(std::uint64_t seed, int scenes, int first) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (int i = first; i < first + scenes; ++i) {
    SplitMix draw(seed * 1'000'003ULL + static_cast<std::uint64_t>(i));
    const std::string text = scene_of(draw);
    std::optional<Experiment> experiment;
    try {
      experiment = parse_experiment(text);
    } catch (const std::exception& error) {
      ++counts["refused"]["all"];
      if (counts["refused"]["all"] == 1) std::fprintf(stderr, "%s\n%s\n", text.c_str(), error.what());
      continue;
    }
    Condition condition = experiment->conditions.front();
    const std::string truth = name_of(end_of(condition));
    const auto at_horizon = realise(condition, experiment->seed, 0).classification;
    condition.horizon.until_classified = UntilClassified{.at_most_periods = 20'000};
    const auto until = realise(condition, experiment->seed, 0).classification;
    const std::string kind = truth.front() == '(' ? "periodic" : truth;
    for (const auto& [name, label] : {std::pair{"default", at_horizon}, std::pair{"until", until}}) {
      const std::string found = verdict(label.mode, truth);
      ++counts[std::string(name) + " " + kind][found.substr(0, found.find(':'))];
      const auto reason = label.reason ? section::to_string(*label.reason) : "";
      if (found != "right") {
        std::printf("%d %s %s %.*s\n", i, name, found.c_str(), static_cast<int>(reason.size()), reason.data());
        if (found.starts_with("wrong")) std::printf("    %s\n", text.c_str());
      }
    }
  }
  for (const auto& [name, verdicts] : counts) {
    std::printf("%-24s", name.c_str());
    for (const auto& [verdict, count] : verdicts) std::printf(" %s %d", verdict.c_str(), count);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace rocking::evidence

int main(int argc, char** argv) {
  if (argc < 3) return 64;
  rocking::evidence::run(std::strtoull(argv[1], nullptr, 0), std::atoi(argv[2]), argc > 3 ? std::atoi(argv[3]) : 0);
}

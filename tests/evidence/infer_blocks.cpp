// How often intervals inferred from simulated blocks cover the truth, and whether it is said where nothing can be told:
// the second table of reports/evidence/infer.md. Each data set is counted with random numbers of its own; those of the
// inference are the same for a quarter of the data sets.
//
//     infer_blocks [data sets]

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/studies/infer/infer.hpp"

namespace {

using namespace rocking;

constexpr std::size_t tests = 10;  ///< under each condition
constexpr std::uint64_t seed_of_tests = 1'000'000;

struct Case {
  const char* name;
  std::string keys;  ///< of the experiment, without block and excitation
  std::vector<double> amplitudes;
  std::vector<double> truth;
};

const std::string mixed_friction =
    R"("friction": {"static": {"normal": {"mean": 0.35, "sigma": 0.02, "between": [0.05, 1.0]}},
                    "kinetic": {"ratio": 0.857}},)";
const std::string mean = R"({"parameter": "/friction/static/normal/mean", "from": 0.3, "to": 0.45})";
const std::string sigma = R"({"parameter": "/friction/static/normal/sigma", "from": 0.001, "to": 0.08})";

std::vector<Case> cases() {
  return {{"mean, no sliding",
           R"("friction": {"static": 0.7, "kinetic": {"ratio": 0.857}}, "fluctuation": {"restitution": {"sigma": 0.05}},
              "unknown": [{"parameter": "/friction/static", "from": 0.55, "to": 1.0}])",
           {5.0, 5.5, 6.5},
           {0.7}},
          {"mean", mixed_friction + "\"unknown\": [" + mean + "]", {4.5, 5.5, 6.5}, {0.35}},
          {"mean, sigma", mixed_friction + "\"unknown\": [" + mean + ", " + sigma + "]", {4.5, 5.5, 6.5}, {0.36, 0.03}},
          {"mean", mixed_friction + "\"unknown\": [" + mean + "]", {4.5, 5.5, 6.5}, {0.38}}};
}

std::string text_with(const std::string& keys) {
  return R"({"format": "rocking.experiment/1", "block": {"width_m": 1.0, "height_m": 4.0},
             "excitation": {"amplitude": 4.5, "frequency_ratio": 10.0},
             "horizon": {"transient_periods": 100, "sampled_periods": 60}, "realisations": 200, )" +
         keys + "}";
}

/// A block whose response modes are counted.
class Block {
 public:
  explicit Block(const Case& scene)
      : scene_(&scene),
        experiment_(experiment_in(std::string_view(text_with(scene.keys)))),
        condition_at_(ConditionMaker(experiment_)) {
    for (const char* name : {"(1,1)", "(1,3)", "(3,3)", "other"}) {
      groups_.push_back({.name = name, .modes = modes_in_group(name, "")});
    }
  }

  [[nodiscard]] const std::vector<Unknown>& unknowns() const { return experiment_.unknowns; }

  /// `tests` of each condition at the truth, with a seed each.
  [[nodiscard]] CountedTests made_up_tests(std::uint64_t set) const {
    CountedTests made_up{.groups = groups_, .conditions = {}};
    const std::size_t conditions = scene_->amplitudes.size();
    for (std::size_t c = 0; c < conditions; ++c) {
      made_up.conditions.push_back(
          {.parameters = {},
           .counts =
               counts(scene_->truth, {scene_->amplitudes[c]}, tests, seed_of_tests + set * conditions + c).front()});
    }
    return made_up;
  }

  /// Points that were simulated with this seed before are taken from there.
  [[nodiscard]] CountsAtPoints simulated(const std::vector<std::vector<double>>& points, std::uint64_t seed) {
    CountsAtPoints all;
    for (const std::vector<double>& at : points) {
      const auto [place, is_new] = known_.try_emplace({seed, at});
      if (is_new) {
        place->second = counts(at, scene_->amplitudes, experiment_.conditions.front().realisations, seed);
      }
      all.push_back(place->second);
    }
    return all;
  }

 private:
  [[nodiscard]] std::vector<std::vector<std::uint64_t>> counts(const std::vector<double>& at,
                                                               const std::vector<double>& amplitudes,
                                                               std::uint64_t realisations, std::uint64_t seed) const {
    Experiment batch{.title = "", .seed = seed, .conditions = {}, .canonical_text = "null"};
    for (const double amplitude : amplitudes) {
      std::vector<Parameter> values{{"/excitation/amplitude", amplitude}};
      for (std::size_t k = 0; k < at.size(); ++k) values.push_back({unknowns()[k].pointer, base::shortest(at[k])});
      batch.conditions.push_back(condition_at_(values));
      batch.conditions.back().realisations = realisations;
      batch.conditions.back().rerun_every = 0;
    }
    std::vector<std::vector<std::uint64_t>> counts;
    for (const auto& by_mode : run(batch).counts) {
      counts.emplace_back(groups_.size());
      for (const auto& [mode, count] : by_mode) counts.back()[group_of(groups_, mode)] += count;
    }
    return counts;
  }

  const Case* scene_;
  Experiment experiment_;
  std::function<Condition(const std::vector<Parameter>&)> condition_at_;
  std::vector<ModeGroup> groups_;
  std::map<std::pair<std::uint64_t, std::vector<double>>, std::vector<std::vector<std::uint64_t>>> known_;
};

void print(const Case& scene, std::size_t sets) {
  Block block(scene);
  const std::size_t unknowns = scene.truth.size();
  std::vector<std::size_t> covered(unknowns);
  std::vector<double> widths(unknowns);
  std::vector<double> errors(unknowns);
  std::size_t both = 0;
  std::size_t bad_fits = 0;
  double points = 0.0;
  for (std::size_t set = 0; set < sets; ++set) {
    const std::uint64_t seed = 1 + 4 * set / sets;
    const InferenceSetting question{
        .unknowns = block.unknowns(), .tests = block.made_up_tests(set), .seed = seed, .simulate = [&](const auto& at) {
          return block.simulated(at, seed);
        }};
    const Inference found = infer_unknowns(question, {});
    points += static_cast<double>(found.design.size());
    const InferenceAnswer& answer = found.answer.value();
    bad_fits += answer.fit.p_value <= 0.05;
    for (std::size_t k = 0; k < unknowns; ++k) {
      const UnknownAnswer& unknown = answer.unknowns[k];
      covered[k] += unknown.interval.low <= scene.truth[k] && scene.truth[k] <= unknown.interval.high;
      widths[k] += unknown.interval.high - unknown.interval.low;
      errors[k] += unknown.estimate - scene.truth[k];
      both += unknown.reaches == ReachedBound::both;
    }
  }
  const auto n = static_cast<double>(sets);
  std::printf("| %s |", scene.name);
  for (const double truth : scene.truth) std::printf(" %.2f", truth);
  std::printf(" |");
  for (const std::size_t count : covered) std::printf(" %zu/%zu", count, sets);
  std::printf(" |");
  for (const double error : errors) std::printf(" %+.4f", error / n);
  std::printf(" |");
  for (const double width : widths) std::printf(" %.3f", width / n);
  std::printf(" | %zu/%zu | %zu/%zu | %.0f |\n", both, sets * unknowns, bad_fits, sets, points / n);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t sets = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  std::printf("| unknown | truth | covered | bias | width | reaches both ends | p <= 0.05 | points |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Case& scene : cases()) print(scene, sets / scene.truth.size());
}

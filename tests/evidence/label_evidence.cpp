// Reliability of the classification of noisy responses: each is compared with the one at a horizon 20 times longer, and
// with those at other horizons and thresholds. The tables are for reports/evidence/classification-evidence.md.
//
//     label_evidence EXPERIMENT.json REALISATIONS

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "evidence/long_run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::evidence {
namespace {

using section::Classification;
using section::ResponseMode;
using section::Thresholds;

constexpr int times_longer = 20;

struct Variant {
  std::string name;
  Window window;
  Thresholds thresholds;
};

std::vector<Variant> variants_of(const Condition& condition) {
  const int transient = condition.horizon.transient_periods;
  const int sampled = condition.horizon.sampled_periods;
  std::vector<Variant> variants{{"as it is", {transient, sampled}, {}}};
  for (const int other : {transient / 4, transient / 2, transient * 2})
    variants.push_back({"transient of " + std::to_string(other), {other, sampled}, {}});
  for (const int other : {sampled / 2, sampled * 2, sampled * 5})
    variants.push_back({"horizon of " + std::to_string(other), {transient, other}, {}});
  const auto both_ways = [&](const char* name, double Thresholds::*threshold, double from = 0.0) {
    for (const double factor : {0.5, 2.0}) {
      Thresholds other;
      other.*threshold = from + factor * (other.*threshold - from);
      variants.push_back({name + std::string(factor < 1.0 ? ", half" : ", twice"), {transient, sampled}, other});
    }
  };
  both_ways("clear_standard_errors", &Thresholds::clear_standard_errors);
  both_ways("clear_growth", &Thresholds::clear_growth);
  both_ways("line_chance", &Thresholds::line_chance);
  both_ways("least_separation", &Thresholds::least_separation);
  both_ways("separation_growth", &Thresholds::separation_growth);
  both_ways("stray_distance", &Thresholds::stray_distance);
  both_ways("largest_stray_share", &Thresholds::largest_stray_share);
  both_ways("tiny_share", &Thresholds::tiny_share);
  both_ways("chance_per_cut", &Thresholds::chance_per_cut);
  both_ways("1 - longest_memory", &Thresholds::longest_memory, 1.0);
  both_ways("1 - least_regular_share", &Thresholds::least_regular_share, 1.0);
  both_ways("least_held", &Thresholds::least_held);
  return variants;
}

bool is_classified(const ResponseMode& mode) { return mode.kind != section::ResponseKind::unresolved; }

std::string description_of(const Condition& condition) {
  std::string text;
  for (const auto& parameter : condition.parameters) text += (text.empty() ? "" : ", ") + short_value(parameter);
  return text;
}

using Tally = std::map<ResponseMode, std::uint64_t>;

/// Effect of another horizon or threshold.
struct Effect {
  int renamed = 0;       ///< realisations with another class
  int lost = 0;          ///< classified before, unresolved now
  int found = 0;         ///< unresolved before, classified now
  double largest = 0.0;  ///< largest change of a probability
  std::string where;
  int outside = 0;  ///< probabilities before and after that lie outside each other's simultaneous interval

  void compare(const std::string& condition, const Tally& before, const Tally& after, std::uint64_t trials) {
    std::set<ResponseMode> modes;
    for (const Tally* tally : {&before, &after}) {
      for (const auto& [mode, count] : *tally) modes.insert(mode);
    }
    for (const ResponseMode& mode : modes) {
      const std::uint64_t old_count = before.contains(mode) ? before.at(mode) : 0;
      const std::uint64_t new_count = after.contains(mode) ? after.at(mode) : 0;
      const double change =
          (static_cast<double>(new_count) - static_cast<double>(old_count)) / static_cast<double>(trials);
      const auto holds = [&](std::uint64_t count, std::uint64_t other) {
        const auto interval = stats::bonferroni_clopper_pearson({count, trials}, 0.95, modes.size());
        const double value = static_cast<double>(other) / static_cast<double>(trials);
        return interval.low <= value && value <= interval.high;
      };
      if (!holds(old_count, new_count) && !holds(new_count, old_count)) ++outside;
      if (std::abs(change) <= std::abs(largest)) continue;
      largest = change;
      where = to_string(mode) + " at " + condition;
    }
  }
};

class Evidence {
 public:
  void add(const Condition& condition, std::uint64_t seed, std::uint64_t realisations) {
    const std::vector<Variant> variants = variants_of(condition);
    effects_.resize(variants.size());
    std::vector<Tally> tallies(variants.size());
    std::set<ResponseMode> in_the_long_run;
    std::uint64_t open = 0;
    for (std::uint64_t number = 0; number < realisations; ++number) {
      const int sampled = condition.horizon.sampled_periods;
      const int transient = condition.horizon.transient_periods;
      LongRun run(condition, random::Draws(seed, number), transient + times_longer * sampled);
      std::vector<ResponseMode> names;
      for (const Variant& variant : variants)
        names.push_back(run.name(variant.window, sampled, variant.thresholds).mode);
      const Classification truth = run.name({transient, times_longer * sampled}, times_longer * sampled / 8);
      const ResponseMode next = run.name({transient + sampled, sampled}, sampled).mode;
      confront(description_of(condition), number, names[0], next, truth);
      in_the_long_run.insert(truth.mode);
      open += is_classified(names[0]) ? 0 : 1;
      for (std::size_t v = 0; v < variants.size(); ++v) {
        ++tallies[v][names[v]];
        effects_[v].renamed += is_classified(names[0]) && is_classified(names[v]) && names[v] != names[0] ? 1 : 0;
        effects_[v].lost += is_classified(names[0]) && !is_classified(names[v]) ? 1 : 0;
        effects_[v].found += !is_classified(names[0]) && is_classified(names[v]) ? 1 : 0;
      }
    }
    const bool one_response = in_the_long_run.size() == 1 && is_classified(*in_the_long_run.begin());
    (one_response ? away_ : near_).add(realisations, open);
    for (std::size_t v = 0; v < variants.size(); ++v) {
      effects_[v].compare(description_of(condition), tallies[0], tallies[v], realisations);
      if (names_.size() < variants.size()) names_.push_back(variants[v].name);
    }
  }

  void print() const {
    std::printf("| name | by %d times the horizon | realisations |\n| --- | --- | --- |\n", times_longer);
    for (const auto& [names, count] : confusion_)
      std::printf("| %s | %s | %d |\n", to_string(names.first).c_str(), to_string(names.second).c_str(), count);
    std::printf("\nnamed by both: %d; by another name: %d, of which %d kept the first one for a second window\n",
                named_, wrong_, changed_later_);
    std::printf("unresolved, of realisations of conditions with one response in the long run: %llu of %llu\n",
                static_cast<unsigned long long>(away_.open), static_cast<unsigned long long>(away_.all));
    std::printf("unresolved, of the others: %llu of %llu\n\n", static_cast<unsigned long long>(near_.open),
                static_cast<unsigned long long>(near_.all));
    for (const std::string& line : disagreements_) std::printf("%s\n", line.c_str());
    std::printf("\n| what | renamed | lost | found | outside | largest change, per cent | where |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t v = 1; v < effects_.size(); ++v) {
      const Effect& e = effects_[v];
      std::printf("| %s | %d | %d | %d | %d | %.1f | %s |\n", names_[v].c_str(), e.renamed, e.lost, e.found, e.outside,
                  100.0 * e.largest, e.where.c_str());
    }
  }

 private:
  struct Share {
    std::uint64_t all = 0;
    std::uint64_t open = 0;
    void add(std::uint64_t more, std::uint64_t more_open) {
      all += more;
      open += more_open;
    }
  };

  void confront(const std::string& condition, std::uint64_t number, const ResponseMode& name, const ResponseMode& next,
                const Classification& truth) {
    ++confusion_[{name, truth.mode}];
    if (!is_classified(name) || !is_classified(truth.mode)) return;
    ++named_;
    if (name == truth.mode) return;
    ++wrong_;
    changed_later_ += next == name ? 1 : 0;
    disagreements_.push_back(condition + ", realisation " + std::to_string(number) + ": " + to_string(name) +
                             ", then " + to_string(next) + "; in the long run " + to_string(truth.mode) + ", held " +
                             std::to_string(truth.held));
  }

  std::map<std::pair<ResponseMode, ResponseMode>, int> confusion_;
  int named_ = 0;
  int wrong_ = 0;
  int changed_later_ = 0;
  Share away_;
  Share near_;
  std::vector<std::string> disagreements_;
  std::vector<std::string> names_;
  std::vector<Effect> effects_;
};

}  // namespace
}  // namespace rocking::evidence

int main(int count, char** arguments) {
  using namespace rocking;
  if (count != 3) {
    std::fprintf(stderr, "usage: label_evidence EXPERIMENT.json REALISATIONS\n");
    return 64;
  }
  try {
    const Experiment experiment = read_experiment_file(arguments[1]);
    evidence::Evidence evidence;
    for (const auto& condition : experiment.conditions) {
      evidence.add(condition, experiment.seed, std::strtoull(arguments[2], nullptr, 10));
    }
    evidence.print();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 65;
  }
  return 0;
}

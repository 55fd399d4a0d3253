// Labels of random scenes in which nothing is random along the way, beside where the motion goes. The table is in
// reports/evidence/classification-evidence.md; tests/reference/labels.csv keeps the truth of some.
//
//     label_truth SEED SCENES [FIRST] [--list]
//
// The truth does not share the classifier. Without sliding it is that of a program in long double which shares nothing with
// the library (support/long_double_motion.hpp), from the last point of the labelled window. With sliding it is the
// smallest number of periods after which the last points repeat to 1e-9, and after none of its divisors to 1e-6, after 20 000,
// 40 000 or 80 000 periods.
// --list: prints the truth of each scene alone.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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
#include "support/labelled_scenes.hpp"
#include "support/long_double_motion.hpp"

namespace rocking::evidence {
namespace {

using support::LongDoubleMotion;
using support::OrbitInTheEnd;

constexpr int longest_period = 12;

/// The block of a scene by model.md, 1 and 11, from the numbers of its file.
struct Shape {
  std::array<long double, 2> psi;  ///< of the left and the right edge
  LongDoubleMotion motion;
};

Shape shape_of(const Json& scene) {
  const Json& block = scene["block"];
  std::array<long double, 2> b{};
  long double h = 0.0L, k2 = 0.0L;
  if (block.contains("edges_m")) {
    b = {block["edges_m"][0].get<double>(), block["edges_m"][1].get<double>()};
    h = block["centre_height_m"].get<double>();
    k2 = static_cast<long double>(block["radius_of_gyration_m"].get<double>());
    k2 *= k2;
  } else {
    b.fill(0.5L * block["width_m"].get<double>());
    h = 0.5L * block["height_m"].get<double>();
    k2 = (b[0] * b[0] + h * h) / 3.0L;
  }
  const long double mean = 0.5L * (b[0] + b[1]);
  const long double r2 = mean * mean + h * h;
  const long double inertia = k2 / r2;
  std::array<LongDoubleMotion::Edge, 2> edges{};
  for (std::size_t i = 0; i < 2; ++i) {
    const long double lever2 = (b[i] * b[i] + h * h) / r2;
    edges[i].psi = std::atan(b[i] / h);
    edges[i].factor = (1.0L + inertia) / (inertia + lever2) * std::sqrt(lever2);
    edges[i].ratio = scene.contains("restitution")
                         ? static_cast<long double>(scene["restitution"]["rate_ratio"].get<double>())
                         : (inertia + (h * h - b[0] * b[1]) / r2) / (inertia + lever2);
  }
  const long double peak = scene["excitation"]["amplitude"].get<double>() * std::min(edges[0].psi, edges[1].psi);
  const long double frequency = scene["excitation"]["frequency_ratio"].get<double>();
  return {{edges[0].psi, edges[1].psi}, LongDoubleMotion(edges[0], edges[1], peak, frequency)};
}

/// The motion of the library, from its start on.
class LongRun {
 public:
  explicit LongRun(const Condition& condition)
      : draws_(1, 0),
        beginning_(begin_realisation(condition, draws_, start_of(condition.scene, draws_), Strobe::poincare, 1)),
        recorder_(beginning_.setting.block, 20'000),
        motion_(motion_of(condition.scene, beginning_, recorder_)) {}

  /// So many periods more; false if it ended before.
  bool extend(std::int64_t periods) {
    recorder_.forget();
    motion_.extend(periods);
    integrate::advance(motion_);
    return motion_.termination() == dynamics::Termination::reached_horizon;
  }
  [[nodiscard]] bool overturned() const { return motion_.termination() == dynamics::Termination::overturned; }
  [[nodiscard]] const auto& periods() const { return recorder_.periods(); }

 private:
  random::Draws draws_;
  Beginning beginning_;
  StrobeRecorder recorder_;
  Motion motion_;
};

OrbitInTheEnd end_with_sliding(const Condition& condition) {
  LongRun run(condition);
  for (const int periods : {20'000, 20'000, 40'000}) {
    if (!run.extend(periods)) return {.overturned = run.overturned()};
    const auto& all = run.periods();
    const auto difference = [&all](std::size_t n) {
      double largest = 0.0;
      for (std::size_t k = all.size() - 60; k < all.size(); ++k) {
        largest = std::max(largest, section::distance(all[k].point, all[k - n].point));
      }
      return largest;
    };
    for (std::size_t n = 1; n <= 5 * longest_period; ++n) {
      bool is_none = difference(n) > 1e-9;
      for (std::size_t divisor = 1; divisor < n; ++divisor) {
        is_none = is_none || (n % divisor == 0 && difference(divisor) < 1e-6);
      }
      if (is_none) continue;
      OrbitInTheEnd end{.period = static_cast<int>(n)};
      for (std::size_t k = all.size() - n; k < all.size(); ++k) {
        end.impacts += all[k].impacts;
        end.moved = end.moved || all[k].moved;
      }
      return end;
    }
  }
  return {};
}

/// Where the motion goes that the library followed for so many periods.
OrbitInTheEnd end_without_sliding(const Json& scene, const Condition& condition, std::int64_t periods) {
  LongRun run(condition);
  if (!run.extend(periods)) return {.overturned = run.overturned()};
  const section::StrobePoint last = run.periods().back().point;
  const Shape shape = shape_of(scene);
  const bool left = last.tilt > 0.0 || (last.tilt == 0.0 && last.tilt_rate > 0.0);
  const long double psi = shape.psi[left ? 0 : 1];
  return support::EndOfMotion(shape.motion, {last.tilt * psi, last.tilt_rate * psi}).found(20'000, longest_period);
}

/// `label` gives the impacts of an orbit that rests in between: the chatter before has any number of them.
std::string name_of(const OrbitInTheEnd& end, const section::ResponseMode& label) {
  if (end.overturned) return "overturned";
  if (end.period == 0) return "none";
  if (!end.moved) return "rest";
  if (end.rests && label.kind == section::ResponseKind::periodic && label.periods == end.period)
    return to_string(label);
  return to_string(section::periodic((end.impacts + 1) / 2, end.period));
}

struct Answer {
  section::Classification found;
  std::string truth;
  int period;  ///< of the truth
};

Answer answer_to(const Json& scene, const Condition& condition, std::uint64_t seed) {
  const RealisationResult result = realise(condition, seed, 0);
  const std::int64_t periods = result.settling
                                   ? result.settling->observed_periods
                                   : condition.horizon.transient_periods + condition.horizon.sampled_periods;
  const OrbitInTheEnd end =
      condition.scene.friction ? end_with_sliding(condition) : end_without_sliding(scene, condition, periods);
  return {result.classification, name_of(end, result.classification.mode), end.period};
}

void run(std::uint64_t seed, int scenes, int first, bool lists) {
  std::map<std::string, std::map<std::string, int>> counts;
  if (lists) std::printf("scene;truth at the default horizon;truth until classified\n");
  for (int i = first; i < first + scenes; ++i) {
    const Json scene = support::labelled_scene(seed, i);
    std::optional<Experiment> experiment;
    try {
      experiment = parse_experiment(scene.dump());
    } catch (const std::exception& error) {
      ++counts["refused"]["all"];
      continue;
    }
    Condition condition = experiment->conditions.front();
    for (const bool until : {false, true}) {
      if (until) condition.horizon.until_classified = UntilClassified{.at_most_periods = 20'000};
      const Answer answer = answer_to(scene, condition, experiment->seed);
      if (lists) {
        if (!until) std::printf("%d", i);
        std::printf(";%s%s", answer.truth.c_str(), until ? "\n" : "");
        continue;
      }
      const std::string verdict = support::verdict_on(answer.found.mode, answer.truth);
      const std::string kind = answer.period > longest_period ? "longer period"
                               : answer.truth.front() == '('  ? "periodic"
                                                              : answer.truth;
      ++counts[std::string(until ? "until " : "default ") + kind][verdict.substr(0, verdict.find(':'))];
      if (verdict == "right") continue;
      const std::string reason(answer.found.reason ? section::to_string(*answer.found.reason) : "");
      std::printf("%d %s %s %s, truth %s\n", i, until ? "until" : "default", verdict.c_str(), reason.c_str(),
                  answer.truth.c_str());
      if (verdict.starts_with("wrong")) std::printf("    %s\n", scene.dump().c_str());
      std::fflush(stdout);
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
  const bool lists = argc > 3 && std::strcmp(argv[argc - 1], "--list") == 0;
  if (lists) --argc;
  if (argc < 3) return 64;
  rocking::evidence::run(std::strtoull(argv[1], nullptr, 0), std::atoi(argv[2]), argc > 3 ? std::atoi(argv[3]) : 0,
                         lists);
}

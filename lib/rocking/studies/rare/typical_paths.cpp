#include "rocking/studies/rare/typical_paths.hpp"

#include <cmath>
#include <iterator>

#include "rocking/integrate/hybrid.hpp"
#include "rocking/realisation/forwarded_motion.hpp"
#include "rocking/studies/rare/twisted_run.hpp"

namespace rocking::rare {
namespace {

/// How many paths are taken from each of two repetitions.
constexpr std::array<std::size_t, 2> shares{3, 2};

/// A motion with the same bits that samples the tilt at even distances in time, from tau = 0 on.
class TiltSampler : public ForwardedMotion<Motion> {
 public:
  TiltSampler(Motion& motion, double distance) : ForwardedMotion(motion), distance_(distance) {}

  void move(double x) {
    const double tau = motion().clock().tau();
    for (;;) {
      const double instant = static_cast<double>(tilts_.size()) * distance_ - tau;
      if (!(instant < x)) break;
      tilts_.push_back(motion().state_at(std::max(0.0, instant)).tilt);
    }
    motion().move(x);
  }

  [[nodiscard]] const std::vector<double>& tilts() const { return tilts_; }

 private:
  double distance_;
  std::vector<double> tilts_;
};

/// Keeps the points of the Poincare section.
class SectionKeeper final : public dynamics::Observer {
 public:
  explicit SectionKeeper(const dynamics::Geometry& block) : block_(block) {}
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State& state) override {
    const double psi = block_.tilt_unit(state.tilt, state.tilt_rate);
    points_.push_back({state.tilt / psi, state.tilt_rate / psi});
  }
  [[nodiscard]] const std::vector<StrobeState>& points() const { return points_; }

 private:
  dynamics::Geometry block_;
  std::vector<StrobeState> points_;
};

/// A smooth curve, and of a long horizon no more than a figure can show.
int samples_per_period(std::int64_t periods) {
  constexpr std::int64_t most = 1000;  // of a path
  return static_cast<int>(std::clamp<std::int64_t>(most / std::max<std::int64_t>(1, periods), 4, 20));
}

std::vector<double> estimates_of(const std::vector<Repetition>& repetitions) {
  std::vector<double> estimates;
  for (const Repetition& repetition : repetitions) estimates.push_back(repetition.estimate);
  return estimates;
}

constexpr double middle = 0.5;

}  // namespace

std::vector<Path> typical_paths(const BlockPaths& paths, const Estimator& estimator,
                                const std::vector<Repetition>& repetitions) {
  const std::vector<double> estimates = estimates_of(repetitions);
  if (!std::ranges::any_of(estimates, [](double estimate) { return estimate > 0.0; })) return {};
  const auto chosen = systematic_offspring(estimates, shares.size(), middle);
  std::vector<Path> all;
  std::size_t next = 0;
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    if (chosen[r] == 0) continue;
    std::size_t wanted = 0;
    for (std::uint32_t copy = 0; copy < chosen[r]; ++copy) wanted += shares.at(next++);
    const std::vector<KeptPath> kept = estimator.paths_of(r + 1);
    if (kept.empty()) {
      throw base::InputError({"earlier", "repetition " + std::to_string(r + 1),
                              "had the event in the earlier study, and has not when it is made again",
                              "start without the earlier repetitions"});
    }
    std::vector<double> weights;
    for (const KeptPath& path : kept) weights.push_back(path.weight);
    const auto copies = systematic_offspring(weights, wanted, middle);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      // One of a large weight is shown once.
      if (copies[i] > 0) all.push_back(path_of(paths, kept[i].number, kept[i].draws));
    }
  }
  return all;
}

Path path_of(const BlockPaths& paths, std::uint64_t number, const random::DrawHistory& history) {
  const Condition& condition = *paths.condition;
  Path path;
  path.number = number;
  for (const random::GivenDraw& draw : history.given) {
    path.given.push_back({std::string(to_string(draw.source)), draw.number, draw.index});
  }
  for (const random::Branch& branch : history.branches) {
    path.branches.push_back({.number = branch.number, .from = {branch.from.begin(), branch.from.end()}});
  }
  const random::BranchedDraws draws(random::Draws(paths.seed, number), &history);
  const Start start = start_of(condition.scene, draws);
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, paths.periods());
  SectionKeeper section(start.geometry);
  const dynamics::Excitation shaking = excitation_of(condition.scene, beginning);
  Motion motion = motion_of(beginning, section, shaking);
  path.samples_per_period = samples_per_period(paths.periods());
  TiltSampler sampler(motion, beginning.clock.period_length() / path.samples_per_period);
  for (integrate::LoopCounts counts; !sampler.ended(); integrate::step(sampler, counts)) {
    paths.halt.check();
    const bool is_at_end = paths.event.name == EventName::displacement;
    if (!is_at_end && paths.event.is_exceeded(peaks_of(motion, start.geometry))) break;
  }
  for (const double tilt : sampler.tilts()) {
    const bool is_full = path.tilts.empty() || std::ssize(path.tilts.back()) == path.samples_per_period;
    if (is_full) path.tilts.emplace_back();
    path.tilts.back().push_back(tilt / start.geometry.tilt_unit(tilt, 0.0));
  }
  path.strobe = section.points();
  return path;
}

CommittorMap map_of(const Committor& committor) {
  constexpr std::size_t half = 30;  // cells on each side of 0
  constexpr double beyond = 1.15;   // what is nearly sure to have the event
  constexpr double farthest = 1.3;  // beyond it a block seldom comes back
  constexpr double sure = 0.5;
  const auto at = [](std::size_t i) { return static_cast<double>(i) / static_cast<double>(half) - 1.0; };
  const SectionGrid& grid = committor.grid();
  CommittorMap map{.tilt = std::min(farthest, beyond * grid.tilt().inner), .tilt_rate = 0.0, .rows = {}};
  const auto value = [&](double tilt_rate, std::size_t column) {
    return committor(1, {.tilt = map.tilt * at(column), .tilt_rate = tilt_rate, .slip_rate = 0.0});
  };
  for (std::size_t row = 0; row <= 2 * half; ++row) {
    const double tilt_rate = grid.tilt_rate().inner * at(row);
    for (std::size_t column = 0; column <= 2 * half; ++column) {
      if (value(tilt_rate, column) < sure) map.tilt_rate = std::max(map.tilt_rate, beyond * std::abs(tilt_rate));
    }
  }
  if (map.tilt_rate == 0.0) map.tilt_rate = grid.tilt_rate().inner;
  for (std::size_t row = 0; row <= 2 * half; ++row) {
    map.rows.emplace_back();
    for (std::size_t column = 0; column <= 2 * half; ++column) {
      map.rows.back().push_back(value(map.tilt_rate * at(row), column));
    }
  }
  return map;
}

}  // namespace rocking::rare

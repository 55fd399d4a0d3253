#include "differential/compare.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "differential/account.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking::differential {
namespace {

constexpr double useless = 1e-3;  ///< displacements that have grown to this size allow no comparison

double period_of(const Question& question) {
  return 2.0 * std::numbers::pi / support::mean_frequency_ratio(question.condition.scene);
}

Account our_account(const Question& question) {
  return account_of(trajectory_of(question.condition, question.seed, question.realisation, question.periods),
                    period_of(question));
}

/// Every number of the scene slightly increased or decreased, as given by one bit of `signs` each. A value of 0 stays
/// 0, so that a block at rest stays at rest; mu_s = mu_k stays so too.
Question displaced(const Question& question, std::uint64_t signs, double size) {
  Question other = question;
  Scene& scene = other.condition.scene;
  const auto nudge = [&signs, size](double value) {
    const double factor = 1.0 + ((signs & 1U) != 0 ? size : -size);
    signs >>= 1U;
    return value * factor;
  };
  if (auto* mass = std::get_if<GivenEdges>(&scene.block.mass)) {
    mass->centre_height = nudge(mean_of(mass->centre_height));
  } else {
    scene.block.height = nudge(mean_block(scene).height);
  }
  amplitude_of(scene) = nudge(mean_of(amplitude_of(scene)));
  if (auto* harmonic = std::get_if<Harmonic>(&scene.excitation)) {
    harmonic->phase = nudge(std::get<double>(harmonic->phase));
  }
  if (auto* wall = std::get_if<WallRatio>(&scene.restitution)) {
    wall->value = nudge(mean_of(wall->value));
  } else {
    scene.restitution = nudge(mean_of(std::get<Quantity>(scene.restitution)));
  }
  if (scene.friction) {
    Friction& friction = *scene.friction;
    const bool equal = mean_static(friction) == mean_kinetic(friction);
    friction.static_coefficient = nudge(mean_static(friction));
    friction.kinetic_coefficient = equal ? mean_static(friction) : nudge(mean_kinetic(friction));
  }
  for (Quantity* start : {&scene.initial.tilt, &scene.initial.tilt_rate, &scene.initial.slip_rate}) {
    *start = nudge(std::get<double>(*start));
  }
  return other;
}

/// Pairs of opposite displacements in random directions, and the same scene at other tolerances: the end of a chatter
/// between sticking and slipping depends on where it is cut off.
std::vector<Account> displaced_accounts(const Question& question) {
  constexpr int pairs = 4;
  support::SplitMix random(question.realisation);
  std::vector<Account> accounts;
  for (int pair = 0; pair < pairs; ++pair) {
    const std::uint64_t signs = random.bits();
    accounts.push_back(our_account(displaced(question, signs, displacement)));
    accounts.push_back(our_account(displaced(question, ~signs, displacement)));
  }
  for (const double coarser : {3.0, 10.0, 30.0}) {
    Question other = question;
    other.condition.tolerance *= coarser;
    accounts.push_back(our_account(other));
  }
  return accounts;
}

bool same_kind(const Account& a, const Account& b, std::size_t index) {
  return index < a.size() && index < b.size() && a[index].what == b[index].what;
}

/// Our account and those of the displaced scenes.
struct Evidence {
  Account ours;
  std::vector<Account> displaced;
};

double unexplained(const Entry& ours, const Entry& theirs) {
  return distance(ours, theirs) - (ends_chatter(ours) ? chatter_error : local_error);
}

Comparison compare(const Evidence& evidence, const Account& theirs, double share_allowed) {
  const Account& ours = evidence.ours;
  std::vector<Account> displaced = evidence.displaced;
  Comparison result;
  const auto ends_as = [&result](Outcome outcome) {
    result.outcome = outcome;
    return result;
  };
  double growth = 0.0;  // growth of the displacements so far
  for (; result.entries < ours.size(); ++result.entries) {
    const std::size_t i = result.entries;
    std::erase_if(displaced, [&](const Account& other) { return !same_kind(ours, other, i); });
    if (!same_kind(ours, theirs, i)) {
      return ends_as(displaced.size() < evidence.displaced.size() ? Outcome::split : Outcome::disagreed);
    }
    for (const Account& other : displaced) growth = std::max(growth, distance(ours[i], other[i]));
    if (displaced.empty() || growth > useless) return ends_as(Outcome::grown);
    result.difference = std::max(result.difference, distance(ours[i], theirs[i]));
    result.share = std::max(result.share, unexplained(ours[i], theirs[i]) / growth);
    if (result.share > share_allowed) return ends_as(Outcome::disagreed);
  }
  return ends_as(theirs.size() > ours.size() ? Outcome::disagreed : Outcome::agreed);
}

}  // namespace

Comparison compare(const Question& asked, const Question& peer_asked, double share_allowed) {
  const Evidence evidence{our_account(asked), displaced_accounts(asked)};
  const auto told_with = [&](const peer::Care& care) {
    const peer::Story story = peer::story_of(peer_scene(peer_asked), peer_asked.periods, care);
    return compare(evidence, account_of(story, period_of(peer_asked)), share_allowed);
  };
  const Comparison first = told_with({});
  if (first.outcome != Outcome::disagreed) return first;
  Comparison second = told_with({.steps_per_period = 4096.0});
  second.looked_closer = true;
  return second;
}

}  // namespace rocking::differential

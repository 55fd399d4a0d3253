#include <algorithm>
#include <cmath>
#include <filesystem>

#include "rocking/api/refuse.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// Trials of all blocks together under one motion at one level, about as many at most.
constexpr std::size_t most_trials = 2000;

double stands(double rate, double years) { return std::exp(-rate * years); }

std::optional<stats::Interval> stands(const std::optional<stats::Interval>& rate, double years) {
  if (!rate) return std::nullopt;
  return stats::Interval{.low = stands(rate->high, years), .high = stands(rate->low, years)};
}

SurvivingBlock survivor(std::string name, const AnnualRate& rate, double years) {
  return {.name = std::move(name),
          .rate = rate.value,
          .rate_interval = rate.interval,
          .probability = stands(rate.value, years),
          .interval = stands(rate.interval, years)};
}

/// Which realisation of each block makes up trial `trial` of all together: given the motion the random numbers of the blocks
/// are independent, so that realisations of different numbers are combined. All combinations, if they are few; else in turn.
class Combinations {
 public:
  explicit Combinations(const std::vector<std::size_t>& realisations) : realisations_(realisations) {
    double all = 1.0;
    for (const std::size_t n : realisations_) all *= static_cast<double>(n);
    are_all_ = all <= static_cast<double>(most_trials);
    trials_ = are_all_ ? static_cast<std::size_t>(all) : std::max(most_trials, std::ranges::max(realisations_));
  }

  [[nodiscard]] std::size_t trials() const { return trials_; }
  [[nodiscard]] std::vector<std::size_t> of(std::size_t trial) const {
    std::vector<std::size_t> places;
    std::size_t rest = trial;
    for (std::size_t b = 0; b < realisations_.size(); ++b) {
      const std::size_t n = realisations_[b];
      // In turn, each round with another distance between the numbers of neighbouring blocks.
      places.push_back(are_all_ ? rest % n : (trial + b * (1 + trial / realisations_.front())) % n);
      rest /= n;
    }
    return places;
  }

 private:
  std::vector<std::size_t> realisations_;
  std::size_t trials_ = 1;
  bool are_all_ = true;
};

/// The stripe of the same motion at the same level; throws where there is none.
const Stripe& same_stripe(const Stripe& stripe, const BlockCurve& of) {
  const auto found = std::ranges::find_if(of.group->stripes, [&stripe](const Stripe& other) {
    return other.record == stripe.record && other.intensity == stripe.intensity;
  });
  if (found == of.group->stripes.end()) {
    refuse("survived", of.name,
           "lacks level " + base::shortest(stripe.intensity) + (stripe.record.empty() ? "" : " of " + stripe.record) +
               "; blocks that survived the same earthquakes need the same levels of the same motions");
  }
  constexpr double rounding = 1e-9;
  const std::optional<double> own = stripe.measure(IntensityMeasure::pga),
                              other = found->measure(IntensityMeasure::pga);
  if (own && other && std::abs(*own - *other) > rounding * *own) {
    refuse("survived", of.name,
           "has another PGA at level " + base::shortest(stripe.intensity) + " of " + stripe.record +
               "; blocks that survived the same earthquakes need the same motions: sweep pga_g, or another measure "
               "that does not follow from the block");
  }
  return *found;
}

/// What happened at one level under one motion: whether any block had the event.
Stripe any_of(const Stripe& first, const std::vector<BlockCurve>& blocks, const ResponseEvent& event) {
  Stripe joint{.record = first.record, .intensity = first.intensity, .measures = {}, .overturned = {}, .peaks = {}};
  std::vector<std::vector<bool>> happened;
  std::vector<const Stripe*> stripes;
  std::vector<std::size_t> realisations;
  joint.uplift = HUGE_VAL;
  for (const BlockCurve& block : blocks) {
    const Stripe& own = *stripes.emplace_back(&same_stripe(first, block));
    happened.push_back(level_of(own, event).happened);
    realisations.push_back(own.overturned.size());
    const std::optional<double>& least = event.is_of_slip() ? own.sliding : own.uplift;
    joint.uplift = joint.uplift && least ? std::optional(std::min(*joint.uplift, *least)) : std::nullopt;
  }
  const Combinations combinations(realisations);
  for (std::size_t trial = 0; trial < combinations.trials(); ++trial) {
    const std::vector<std::size_t> places = combinations.of(trial);
    bool has_event = false, is_unknown = false;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      has_event = has_event || happened[b][places[b]];
      is_unknown = is_unknown || stripes[b]->has_no_answer(places[b]);
    }
    joint.overturned.push_back(has_event);
    joint.without_answer.push_back(is_unknown && !has_event);
  }
  return joint;
}

/// Stripes of all blocks together, in which what any of them does counts as overturned.
StripeGroup joint_group(const std::vector<BlockCurve>& blocks, const ResponseEvent& event) {
  const StripeGroup& first = *blocks.front().group;
  StripeGroup joint{.parameter = first.parameter, .others = {}, .confidence = first.confidence, .stripes = {}};
  for (const BlockCurve& block : blocks) {
    if (block.group->parameter == first.parameter && block.group->stripes.size() == first.stripes.size()) continue;
    refuse("survived", block.name,
           "has other levels or motions than " + blocks.front().name +
               "; blocks that survived the same earthquakes need the same levels of the same motions");
  }
  for (const Stripe& stripe : first.stripes) joint.stripes.push_back(any_of(stripe, blocks, event));
  return joint;
}

using AnyCurve = decltype(BlockCurve::curve);

AnnualRate rate_by(const FragilityCurve* curve, const HazardCurve& hazard, RateSource) {
  return annual_rate(*curve, hazard);
}
AnnualRate rate_by(const SuiteCurve* curve, const HazardCurve& hazard, RateSource source) {
  return annual_rate(*curve, hazard, source).chosen;
}

AnnualRate rate_of(const AnyCurve& curve, const HazardCurve& hazard, RateSource source) {
  return std::visit([&](const auto* one) { return rate_by(one, hazard, source); }, curve);
}

/// Of the rate at which any has the event, from the intervals of each: at least the largest, at most the sum. Under one
/// motion the combinations share their realisations, and are no sample.
std::optional<stats::Interval> bounds_of_any(const std::vector<SurvivingBlock>& blocks) {
  stats::Interval bounds{.low = 0.0, .high = 0.0};
  for (const SurvivingBlock& block : blocks) {
    if (!block.rate_interval) return std::nullopt;
    bounds.low = std::max(bounds.low, block.rate_interval->low);
    bounds.high += block.rate_interval->high;
  }
  return bounds;
}

void set_weights(std::vector<SurvivalBranch>& branches) {
  double sum = 0.0;
  for (const SurvivalBranch& branch : branches) sum += branch.all.probability;
  for (SurvivalBranch& branch : branches) branch.weight = sum > 0.0 ? branch.all.probability / sum : 0.0;
}

}  // namespace

std::vector<RateInYears> in_years(const AnnualRate& rate, const std::vector<double>& years) {
  std::vector<RateInYears> found;
  for (const double each : years) {
    const auto within = [each](double value) { return -std::expm1(-value * each); };
    RateInYears& in = found.emplace_back(RateInYears{.years = each, .probability = within(rate.value), .interval = {}});
    if (rate.interval) in.interval = {.low = within(rate.interval->low), .high = within(rate.interval->high)};
  }
  return found;
}

Survival survival(const std::vector<BlockCurve>& blocks, double years, const std::vector<HazardCurve>& hazards,
                  std::uint64_t seed, const base::ManyParts& how) {
  const ResponseEvent event = std::visit([](const auto* curve) { return curve->subject.event; }, blocks.front().curve);
  AnyCurve all = blocks.front().curve;
  std::optional<FragilityCurve> joint_of_motion;
  std::optional<SuiteCurve> joint_of_suite;
  if (blocks.size() > 1) {
    const StripeGroup joint = joint_group(blocks, event);
    if (joint.is_suite()) {
      all = &joint_of_suite.emplace(suite_curve(joint, {}, seed, how));
    } else {
      all = &joint_of_motion.emplace(fragility(joint, {}, seed, how));
    }
  }
  const auto holds = [](const AnyCurve& curve) {
    return std::visit([](const auto* one) { return one->has_law(); }, curve);
  };
  const bool is_by_law = holds(all) && std::ranges::all_of(blocks, holds, &BlockCurve::curve);
  const RateSource source = is_by_law ? RateSource::law : RateSource::isotonic;
  Survival found{.event = event, .years = years, .source = RateSource::law, .branches = {}};
  for (const HazardCurve& hazard : hazards) {
    SurvivalBranch& branch = found.branches.emplace_back();
    branch.hazard = hazard.name;
    branch.independent = 1.0;
    for (const BlockCurve& block : blocks) {
      branch.blocks.push_back(survivor(block.name, rate_of(block.curve, hazard, source), years));
      branch.independent *= branch.blocks.back().probability;
    }
    AnnualRate rate = rate_of(all, hazard, source);
    if (joint_of_motion) rate.interval = bounds_of_any(branch.blocks);
    branch.all = survivor("", rate, years);
    found.source = rate.source;
  }
  set_weights(found.branches);
  return found;
}

namespace {

/// The last part of the name of its file; the whole where another branch has the same.
std::string hazard_name(const Survival& survival, const SurvivalBranch& branch) {
  const auto last = [](const SurvivalBranch& each) { return std::filesystem::path(each.hazard).filename().string(); };
  const std::string name = last(branch);
  return std::ranges::count(survival.branches, name, last) == 1 ? name : branch.hazard;
}

std::string with_interval(const SurvivingBlock& block) {
  return plain_text(estimate_cell(block.probability, block.interval));
}

void add_row(const std::string& hazard, const SurvivingBlock& block, const look::Cell& last, look::Table& table) {
  table.rows.push_back({hazard, block.name, look::number(block.rate, look::rate_form()),
                        look::interval(block.rate_interval, look::rate_form()), look::number(block.probability, 3),
                        look::interval(block.interval, 3), last});
}

}  // namespace

std::string survival_in_words(const Survival& survival) {
  const SurvivalBranch& first = survival.branches.front();
  const std::size_t blocks = first.blocks.size();
  std::string text = "probability that ";
  text += blocks == 1 ? "the block has not " : "none of " + std::to_string(blocks) + " blocks has ";
  text += did(survival.event) + " in " + base::shortest(survival.years) + " years";
  if (survival.branches.size() > 1) text += " under " + hazard_name(survival, first);
  text += ": " + with_interval(first.all);
  if (survival.branches.size() < 2) return text;
  const auto best = std::ranges::max_element(survival.branches, {}, &SurvivalBranch::weight);
  return text + "; of " + std::to_string(survival.branches.size()) + " hazard curves " + hazard_name(survival, *best) +
         " makes it likeliest, with the weight " + rate_text(best->weight);
}

std::string survival_table(const Survival& survival) {
  const SurvivalBranch& first = survival.branches.front();
  const bool has_branches = survival.branches.size() > 1, has_blocks = first.blocks.size() > 1;
  std::string text = survival_in_words(survival) + '\n';
  if (!has_branches && !has_blocks) return text;
  look::Table table{.title = ""};
  add_columns(table, {"hazard", "block", "per year", "interval", "survival", "interval", "weight"});
  for (const SurvivalBranch& branch : survival.branches) {
    if (has_blocks) {
      for (const SurvivingBlock& block : branch.blocks)
        add_row(hazard_name(survival, branch), block, look::Cell(), table);
    }
    SurvivingBlock all = branch.all;
    all.name = has_blocks ? "all" : "";
    add_row(hazard_name(survival, branch), all,
            has_branches ? look::number(branch.weight, look::rate_form()) : look::Cell(), table);
  }
  text += to_terminal(table);
  if (has_blocks) {
    text += "rates by " + source_in_words(survival.source) + "; all: the rate at which any block " +
            does(survival.event) + ", record by record; without shared earthquakes the survival would be " +
            significant(first.independent, 3) + (has_branches ? " under the first hazard curve" : "") + '\n';
  }
  if (has_branches)
    text += "weight: survival of all over the sum over the hazard curves, which are equally likely before\n";
  return text;
}

}  // namespace rocking

#include "rocking/studies/fragility/suite_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

constexpr double beyond_every_tilt = std::numeric_limits<double>::infinity();
/// A realisation without an answer: its tilt may be any.
constexpr double not_known = std::numeric_limits<double>::max();

std::vector<double> tilts_of(const Stripe& stripe) {
  std::vector<double> tilts;
  for (std::size_t j = 0; j < stripe.overturned.size(); ++j) {
    tilts.push_back(stripe.overturned[j]      ? beyond_every_tilt
                    : stripe.has_no_answer(j) ? not_known
                                              : stripe.peaks[j].tilt);
  }
  return tilts;
}

PeakTiltLevel tilt_level(double intensity, std::vector<double> tilts) {
  std::sort(tilts.begin(), tilts.end());
  PeakTiltLevel level{.intensity = intensity, .trials = tilts.size(), .overturned = 0, .quantiles = {}};
  level.overturned = static_cast<std::size_t>(std::count(tilts.begin(), tilts.end(), beyond_every_tilt));
  for (std::size_t i = 0; i < peak_tilt_shares.size(); ++i) {
    const double place = std::ceil(peak_tilt_shares[i] * static_cast<double>(tilts.size()));
    const double tilt = tilts[static_cast<std::size_t>(std::max(1.0, place)) - 1];
    if (tilt < not_known) level.quantiles[i] = tilt;
  }
  return level;
}

/// Of the stripes of one record, by growing intensity.
Resurrections resurrections_in(std::span<const Stripe> stripes) {
  Resurrections found;
  std::size_t realisations = 0;
  for (const Stripe& stripe : stripes) realisations = std::max(realisations, stripe.overturned.size());
  for (std::size_t j = 0; j < realisations; ++j) {
    bool has_overturned = false;
    bool stands_again = false;
    for (const Stripe& stripe : stripes) {
      if (j >= stripe.overturned.size()) continue;
      if (stripe.overturned[j]) has_overturned = true;
      if (!stripe.overturned[j] && !stripe.has_no_answer(j) && has_overturned) stands_again = true;
    }
    found.of += has_overturned ? 1 : 0;
    found.trials += stands_again ? 1 : 0;
  }
  return found;
}

}  // namespace

IncrementalAnalysis incremental_analysis(const StripeGroup& group) {
  IncrementalAnalysis analysis;
  analysis.parameter = group.parameter;
  analysis.others = group.others;
  std::map<double, std::vector<double>> together;
  for (const std::span<const Stripe> stripes : group.by_record()) {
    PeakTiltCurve curve{.record = stripes.front().record, .levels = {}, .resurrections = {}};
    for (const Stripe& stripe : stripes) {
      const std::vector<double> tilts = tilts_of(stripe);
      curve.levels.push_back(tilt_level(stripe.intensity, tilts));
      std::vector<double>& all = together[stripe.intensity];
      all.insert(all.end(), tilts.begin(), tilts.end());
    }
    curve.resurrections = resurrections_in(stripes);
    analysis.resurrections.trials += curve.resurrections.trials;
    analysis.resurrections.of += curve.resurrections.of;
    analysis.records.push_back(std::move(curve));
  }
  for (auto& [intensity, tilts] : together) analysis.all.push_back(tilt_level(intensity, std::move(tilts)));
  return analysis;
}

}  // namespace rocking

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/curves/look.hpp"
#include "rocking/studies/incremental/look.hpp"
#include "rocking/text/json.hpp"

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

std::string resurrections_in_words(const Resurrections& found) {
  return std::to_string(found.trials) + " of " + std::to_string(found.of) +
         " realisations that overturned at some level stood again at a stronger one";
}

std::string incremental_table(const IncrementalAnalysis& analysis) {
  look::Table table{.title = "peak tilt, abs(theta)/psi of its side, over all records and realisations",
                    .absent = "overturned"};
  add_columns(table, {last_key(analysis.parameter), "n", "overturned", "16 %", "median", "84 %"});
  for (const PeakTiltLevel& level : analysis.all) {
    look::Row& row = table.rows.emplace_back(
        look::Row{look::number(level.intensity, 6), look::whole(level.trials), look::whole(level.overturned)});
    for (const auto& quantile : level.quantiles) row.push_back(look::number(quantile, 3));
  }
  return to_terminal(table) + resurrections_in_words(analysis.resurrections) + '\n';
}

namespace {

using TiltQuantiles = decltype(PeakTiltLevel::quantiles);
using WrittenTiltQuantiles = std::array<std::array<std::optional<double>, 2>, peak_tilt_shares.size()>;

WrittenTiltQuantiles written_quantiles(const TiltQuantiles& quantiles) {
  WrittenTiltQuantiles list;
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = {peak_tilt_shares[i], quantiles[i]};
  return list;
}

void set_quantiles(const WrittenTiltQuantiles& list, const ReadingPlace& place, TiltQuantiles& quantiles) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i][0] != peak_tilt_shares[i]) {
      place.at(std::to_string(i)).reject(Json(), "must begin with its share: 0.16, 0.5 and 0.84");
    }
    quantiles[i] = list[i][1];
  }
}

using TiltQuantilesType = ConvertedType<TiltQuantiles, WrittenTiltQuantiles, written_quantiles, set_quantiles>;

}  // namespace

static const StructType& fields_of(const PeakTiltLevel*) {
  using Level = PeakTiltLevel;
  static const StructType fields{
      "PeakTiltLevel",
      field<&Level::intensity>("intensity", "of the excitation", rule::not_negative),
      field<&Level::trials>("realisations", "under all records, or under one"),
      field<&Level::overturned>("overturned", "those that overturned"),
      field<&Level::quantiles>("quantiles", "[share, value] of the peak of abs(theta)/psi; null: overturned",
                               the_only<TiltQuantilesType>()),
  };
  return fields;
}

static const StructType& fields_of(const Resurrections*) {
  static const StructType fields{
      "Resurrections",
      field<&Resurrections::trials>("trials", "that stand at a level and overturned at a weaker one"),
      field<&Resurrections::of>("of", "those that overturned at some level"),
  };
  return fields;
}

static const StructType& fields_of(const PeakTiltCurve*) {
  static const StructType fields{
      "PeakTiltCurve",
      field<&PeakTiltCurve::record>("name", "path of the ground motion; empty without a suite"),
      field<&PeakTiltCurve::resurrections>("resurrections", "under this record"),
      field<&PeakTiltCurve::levels>("levels", "by increasing intensity"),
  };
  return fields;
}

static const StructType& fields_of(const IncrementalAnalysis*) {
  using Analysis = IncrementalAnalysis;
  static const StructType fields{
      "IncrementalAnalysis",
      field<&Analysis::parameter>("parameter", "JSON pointer to the intensity"),
      field<&Analysis::others>("others", "values of the other entries of the sweep"),
      field<&Analysis::resurrections>("resurrections", "sum over the records"),
      field<&Analysis::all>("levels", "of all records"),
      field<&Analysis::records>("records", "of each record"),
  };
  return fields;
}

const StructType& fields_of(const ReportedAnalysis*) {
  static const StructType fields{
      "ReportedAnalysis",
      inlined<&ReportedAnalysis::run>(),
      inlined<&ReportedAnalysis::analysis>(),
  };
  return fields;
}

}  // namespace rocking

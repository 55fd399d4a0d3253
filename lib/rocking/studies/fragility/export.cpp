#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "rocking/base/number_text.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

using base::shortest;

/// An event: its law, and probabilities at the levels, which do not decrease.
struct LimitState {
  ResponseEvent event;
  std::optional<LognormalCapacity> law;
  std::vector<double> intensities, probabilities;

  [[nodiscard]] std::string name() const {
    std::string text;
    for (const char c : event_text(event)) {
      const bool is_between = c == ' ' || c == '>';
      const bool is_kept = !is_between && c != '.' && c != '-' && c != '+';
      if (!is_between || !text.ends_with('_')) text += is_kept ? c : '_';
    }
    return text;
  }
};

/// A function of one kind of block under one suite or motion; events from the mildest to overturning.
struct ExportedFunction {
  std::string id;
  std::string measure;  ///< HazardCurve::intensity
  std::optional<double> least_uplift;
  std::vector<LimitState> states;
};

/// A measure of intensity in the words of other programs.
struct MeasureElsewhere {
  std::string nrml;
  double factor = 1.0;  ///< between the unit there and here
  std::string pelicun, unit;
};

MeasureElsewhere measure_elsewhere(const std::string& measure) {
  constexpr std::string_view spectral = "sa_g[";
  if (measure == "pga_g") return {.nrml = "PGA", .pelicun = "Peak Ground Acceleration", .unit = "g"};
  if (measure == "pgv_m_s") {
    return {.nrml = "PGV", .factor = 100.0, .pelicun = "Peak Ground Velocity", .unit = "mps"};
  }
  if (measure.starts_with(spectral) && measure.ends_with(']')) {
    const std::string period = measure.substr(spectral.size(), measure.size() - spectral.size() - 1);
    return {.nrml = "SA(" + period + ')', .pelicun = "Spectral Acceleration|" + period, .unit = "g"};
  }
  throw UnfitQuestion("export", "", measure + " is no measure of intensity of this format",
                      "sweep pga_g, pgv_m_s or sa_g, or give csv as `export_as`");
}

/// Letters, digits, points and `_`: pelicun parts an ID at `-`.
std::string id_of(const std::string& title, const std::vector<Parameter>& others) {
  std::string text = title.empty() ? "block" : title;
  for (const Parameter& parameter : others) text += '_' + last_key(parameter.pointer) + '_' + short_value(parameter);
  std::string id;
  for (const char c : text) {
    const bool is_kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (is_kept || !id.ends_with('_')) id += is_kept ? c : '_';
  }
  return id;
}

[[noreturn]] void refuse_curve(const LimitState& state, const std::string& reason) {
  throw UnfitQuestion("export", "", "the curve of " + words_of(state.event) + ' ' + reason);
}

double probability_of(const FragilityLevel& level) {
  return level.fitted.value_or(level.isotonic.value_or(level.estimate));
}

double probability_of(const SuiteLevel& level) { return level.fitted.value_or(level.isotonic); }

template <class Curve, class Law>
LimitState limit_state(const Curve& curve, const Law* law) {
  LimitState state{.event = curve.subject.event, .law = {}, .intensities = {}, .probabilities = {}};
  if (law != nullptr) {
    state.law = LognormalCapacity{.centre = std::log(law->median.value), .dispersion = law->dispersion.value};
  }
  for (auto level : curve.levels) {
    if (level.unresolved > 0) refuse_curve(state, "has realisations without an answer");
    if (law == nullptr) level.fitted.reset();  // that of a law that is rejected
    const bool is_lifted = level.intensity > curve.subject.least_uplift.value_or(0.0);
    state.intensities.push_back(level.intensity);
    state.probabilities.push_back(is_lifted ? probability_of(level) : 0.0);
  }
  if (state.law) return state;
  if (state.intensities.size() < 2) refuse_curve(state, "has fewer than two levels and no law; add levels");
  if (!std::ranges::is_sorted(state.probabilities)) {
    refuse_curve(state, "has no law, and shares that decrease: no fragility function describes it");
  }
  return state;
}

LimitState limit_state(const FragilityCurve& curve) { return limit_state(curve, curve.law ? &*curve.law : nullptr); }

LimitState limit_state(const SuiteCurve& curve) {
  return limit_state(curve, curve.has_law() ? &*curve.pooled : nullptr);
}

/// The functions of a run, each with the place of its values of the rest of the sweep.
template <class Shown>
void add_functions(const RunFragility& run, const std::vector<Shown>& curves,
                   std::vector<ExportedFunction>& functions) {
  std::vector<std::pair<const std::vector<Parameter>*, std::size_t>> known;
  for (const Shown& shown : curves) {
    const CurveSubject& subject = shown.curve.subject;
    auto place =
        std::ranges::find_if(known, [&](const auto& each) { return have_equal_values(*each.first, subject.others); });
    if (place == known.end()) {
      place = known.insert(place, {&subject.others, functions.size()});
      functions.push_back({.id = id_of(run.experiment.title, subject.others),
                           .measure = swept_measure(run.experiment),
                           .least_uplift = subject.least_uplift,
                           .states = {}});
    }
    functions[place->second].states.push_back(limit_state(shown.curve));
  }
}

std::vector<ExportedFunction> functions_of(const std::vector<RunFragility>& runs) {
  std::vector<ExportedFunction> functions;
  for (const RunFragility& run : runs) {
    add_functions(run, run.curves, functions);
    add_functions(run, run.suites, functions);
  }
  std::set<std::string> ids;
  for (ExportedFunction& function : functions) {
    const std::string id = function.id;
    for (int i = 2; !ids.insert(function.id).second; ++i) function.id = id + '_' + std::to_string(i);
    std::ranges::stable_sort(function.states, {}, [](const LimitState& state) {
      // Sliding, tilting, overturning: each from the smallest threshold on.
      const ResponseEvent& event = state.event;
      return std::tuple(event.is_overturning(), !event.is_of_slip(), event.name, event.threshold);
    });
  }
  return functions;
}

std::string list_of(const std::vector<double>& numbers, std::string_view separator, double factor = 1.0) {
  std::string text;
  for (const double number : numbers) text += std::string(text.empty() ? "" : separator) + shortest(number * factor);
  return text;
}

/// As NRML takes it: mean and standard deviation of the capacity, not of its logarithm.
std::string continuous_nrml(const ExportedFunction& function, const MeasureElsewhere& measure,
                            const std::string& limit) {
  constexpr double reach = 6.0;  // standard deviations: beyond it lies less than 1e-9
  std::string params;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const LimitState& state : function.states) {
    const auto [centre, dispersion] = *state.law;
    const double variance = dispersion * dispersion;
    const double mean = measure.factor * std::exp(centre + 0.5 * variance);
    params += "      <params ls=\"" + state.name() + "\" mean=\"" + shortest(mean) + "\" stddev=\"" +
              shortest(mean * std::sqrt(std::expm1(variance))) + "\"/>\n";
    least = std::min(least, measure.factor * std::exp(centre - reach * dispersion));
    most = std::max(most, measure.factor * std::exp(centre + reach * dispersion));
  }
  // Engines before 3.13 raise intensities to minIML before they compare them with noDamageLimit, which must lie above it.
  if (function.least_uplift) least = 0.5 * measure.factor * *function.least_uplift;
  return "    <fragilityFunction id=\"" + function.id +
         "\" format=\"continuous\" shape=\"logncdf\">\n      <imls imt=\"" + measure.nrml + '"' + limit + " minIML=\"" +
         shortest(least) + "\" maxIML=\"" + shortest(std::max(most, 2.0 * least)) + "\"/>\n" + params;
}

std::string discrete_nrml(const ExportedFunction& function, const MeasureElsewhere& measure, const std::string& limit) {
  std::string text = "    <fragilityFunction id=\"" + function.id + "\" format=\"discrete\">\n      <imls imt=\"" +
                     measure.nrml + '"' + limit + '>' +
                     list_of(function.states.front().intensities, " ", measure.factor) + "</imls>\n";
  for (const LimitState& state : function.states) {
    text += "      <poes ls=\"" + state.name() + "\">" + list_of(state.probabilities, " ") + "</poes>\n";
  }
  return text;
}

std::string nrml_of(const std::vector<ExportedFunction>& functions, const std::string& title) {
  std::string states;
  for (const LimitState& state : functions.front().states) states += (states.empty() ? "" : " ") + state.name();
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n"
      "  <fragilityModel id=\"rocking\" assetCategory=\"contents\" lossCategory=\"contents\">\n    <description>" +
      look::escaped(title.empty() ? "rocking block" : title) + "</description>\n    <limitStates>" + states +
      "</limitStates>\n";
  for (const ExportedFunction& function : functions) {
    const MeasureElsewhere measure = measure_elsewhere(function.measure);
    const std::string limit =
        function.least_uplift ? " noDamageLimit=\"" + shortest(measure.factor * *function.least_uplift) + '"' : "";
    const bool has_laws =
        std::ranges::all_of(function.states, [](const LimitState& state) { return state.law.has_value(); });
    text += has_laws ? continuous_nrml(function, measure, limit) : discrete_nrml(function, measure, limit);
    text += "    </fragilityFunction>\n";
  }
  return text + "  </fragilityModel>\n</nrml>\n";
}

/// Points of pelicun's multilinear distribution: from 0 to 1, and rising everywhere.
class MultilinearPoints {
 public:
  MultilinearPoints(const LimitState& state, std::optional<double> least_uplift, std::vector<std::string>& notices) {
    add(least_uplift.value_or(0.0), 0.0);
    for (std::size_t i = 0; i < state.intensities.size(); ++i) add(state.intensities[i], state.probabilities[i]);
    const double last = probabilities_.back();
    if (last == 1.0) return;
    const double end = state.intensities.back() * far;
    notices.push_back("pelicun needs a probability that reaches 1: that of " + words_of(state.event) + " is " +
                      base::significant(last, 3) + " at the highest level, " + shortest(state.intensities.back()) +
                      ", and reaches 1 at " + shortest(end) + "; add stronger levels");
    add(end, 1.0);
  }

  [[nodiscard]] std::string text() const { return list_of(intensities_, ",") + '|' + list_of(probabilities_, ","); }

 private:
  static constexpr double far = 1000.0;
  static constexpr double least_rise = 1e-6;  // pelicun refuses a flat part, by a tolerance of 1e-8

  void add(double intensity, double probability) {
    const bool is_first = intensities_.empty();
    if (!is_first && probabilities_.back() == 1.0) return;
    if (!is_first && probability == 0.0) {
      intensities_.back() = std::max(intensities_.back(), intensity);  // the last one without the event
      return;
    }
    intensities_.push_back(intensity);
    probabilities_.push_back(is_first ? probability
                                      : std::min(1.0, std::max(probability, probabilities_.back() + least_rise)));
  }

  std::vector<double> intensities_, probabilities_;
};

std::string pelicun_of(const std::vector<ExportedFunction>& functions, std::vector<std::string>& notices) {
  std::string head = "ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional";
  for (std::size_t i = 1; i <= functions.front().states.size(); ++i) {
    const std::string state = ",LS" + std::to_string(i);
    head += state + "-Family" + state + "-Theta_0" + state + "-Theta_1";
  }
  std::string text = head + '\n';
  for (const ExportedFunction& function : functions) {
    const MeasureElsewhere measure = measure_elsewhere(function.measure);
    text += function.id + ",0," + measure.pelicun + ',' + measure.unit + ",0,1";
    for (const LimitState& state : function.states) {
      if (state.law) {
        text += ",lognormal," + shortest(std::exp(state.law->centre)) + ',' + shortest(state.law->dispersion);
      } else {
        text += ",multilinear_CDF,\"" + MultilinearPoints(state, function.least_uplift, notices).text() + "\",";
      }
    }
    text += '\n';
  }
  return text;
}

std::string csv_of(const std::vector<ExportedFunction>& functions) {
  std::string text = "id,limit_state,measure,least_uplift,median,dispersion,intensity,probability\n";
  for (const ExportedFunction& function : functions) {
    const std::string uplift = function.least_uplift ? shortest(*function.least_uplift) : "";
    for (const LimitState& state : function.states) {
      const std::string law =
          state.law ? shortest(std::exp(state.law->centre)) + ',' + shortest(state.law->dispersion) : ",";
      for (std::size_t i = 0; i < state.intensities.size(); ++i) {
        text += function.id + ',' + state.name() + ',' + function.measure + ',' + uplift + ',' + law + ',' +
                shortest(state.intensities[i]) + ',' + shortest(state.probabilities[i]) + '\n';
      }
    }
  }
  return text;
}

}  // namespace

ExportedFragility exported(const std::vector<RunFragility>& runs, ExportFormat format) {
  const std::vector<ExportedFunction> functions = functions_of(runs);
  ExportedFragility found;
  if (functions.empty()) throw UnfitQuestion("export", "", "there is no curve");
  switch (format) {
    case ExportFormat::nrml: found.text = nrml_of(functions, runs.front().experiment.title); break;
    case ExportFormat::pelicun: found.text = pelicun_of(functions, found.notices); break;
    case ExportFormat::csv: found.text = csv_of(functions); break;
  }
  return found;
}

}  // namespace rocking

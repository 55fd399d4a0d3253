#include <algorithm>
#include <utility>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/orbits/study.hpp"

namespace rocking {
namespace {

using dynamics::ContactState;

constexpr Rule at_least_one{.least = 1.0};
constexpr std::array<std::string_view, 4> contacts_of_an_orbit{"rest", "slide", "rock", "rock_slide"};

using Coordinates = std::array<double, 3>;

/// `[tilt, tilt_rate, slip_rate]` of each state. The contact of the first one stands elsewhere, that of the others
/// nowhere.
class PointsType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    Json list = Json::array();
    for (const auto& [point, contact] : states(value)) {
      list.push_back({point.tilt, point.tilt_rate, point.slip_rate});
    }
    return list;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::vector<Coordinates> read;
    type_of<std::vector<Coordinates>>().read(json, place, &read);
    if (read.empty()) return place.reject(json, "must be a list of at least one state");
    auto& states = *static_cast<std::vector<SectionState>*>(value);
    states.resize(read.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      states[i].point = {.tilt = read[i][0], .tilt_rate = read[i][1], .slip_rate = read[i][2]};
    }
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = type_of<std::vector<Coordinates>>().schema(rule);
    schema["minItems"] = 1;
    return schema;
  }

 private:
  static const std::vector<SectionState>& states(const void* value) {
    return *static_cast<const std::vector<SectionState>*>(value);
  }
};

ContactState contact_of(const Orbit& orbit) { return orbit.points.front().contact; }

void set_contact(const ContactState& read, const ReadingPlace&, Orbit& orbit) {
  if (orbit.points.empty()) orbit.points.emplace_back();
  orbit.points.front().contact = read;
}

using RealAndImaginary = std::array<double, 2>;

RealAndImaginary parts_of(const std::complex<double>& number) { return {number.real(), number.imag()}; }

void set_parts(const RealAndImaginary& read, const ReadingPlace&, std::complex<double>& number) {
  number = {read[0], read[1]};
}

class ComplexType final : public ConvertedType<std::complex<double>, RealAndImaginary, parts_of, set_parts> {
 public:
  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = ConvertedType::schema(rule);
    schema["title"] = "Complex";
    return schema;
  }
};

using Ends = std::array<double, 2>;

Ends ends_of(const ParameterRange& range) { return {range.low, range.high}; }

void set_ends(const Ends& read, const ReadingPlace& place, ParameterRange& range) {
  if (!(read[0] < read[1])) return place.at("1").reject(Json(read[1]), "must be greater than the lower end");
  range = {.low = read[0], .high = read[1]};
}

}  // namespace

template <>
struct TypeOf<ContactState> : OnlyType<NamedType<ContactState, contacts_of_an_orbit>> {};
template <>
struct TypeOf<BifurcationKind> : OnlyType<NamedType<BifurcationKind, bifurcation_kind_names>> {};
template <>
struct TypeOf<BranchEnd> : OnlyType<NamedType<BranchEnd, branch_end_names>> {};
template <>
struct TypeOf<std::complex<double>> : OnlyType<ComplexType> {};
template <>
struct TypeOf<ParameterRange> : OnlyType<ConvertedType<ParameterRange, Ends, ends_of, set_ends>> {};

static const StructType& state_fields() {
  using Point = section::StrobePoint;
  static const StructType fields{
      "State",
      field<&Point::tilt>("tilt", "Theta"),
      field<&Point::tilt_rate>("tilt_rate", "Theta'"),
      field<&Point::slip_rate>("slip_rate", "V"),
  };
  return fields;
}

template <>
struct TypeOf<section::StrobePoint> {
  static const ValueType& get() { return state_fields(); }
};

static const StructType& fields_of(const Orbit*) {
  static const StructType fields{
      "Orbit",
      field<&Orbit::period>("period", "n: excitation periods until it repeats", at_least_one),
      field<&Orbit::cycles>("cycles", "m: pairs of impacts in them, rounded up", rule::not_negative),
      derived<[](const Orbit& orbit) { return orbit.points.front().point; }>(
          "state",
          "at an instant at which the argument of the excitation is a multiple of 2 pi. With `phase_rad` 0, a run of "
          "`rocking trajectory` from this initial state stays on the orbit"),
      of_owner<Orbit>("contact", "contact state there",
                      the_only<ConvertedType<Orbit, ContactState, contact_of, set_contact>>()),
      field<&Orbit::residual>(
          "residual",
          "largest difference between `state` and its image after n periods, of symmetric orbits on a branch after "
          "n/2; at most 1e-13, on a branch also 1e-13 times the largest entry of the map's derivative",
          rule::not_negative),
      field<&Orbit::stability, &Stability::multipliers>(
          "multipliers",
          "[re, im] of each multiplier of the map over n periods within the contact state, by falling modulus"),
      derived<[](const Orbit& orbit) {
        const bool is_known = orbit.stability.kind != OrbitKind::not_differentiable;
        return is_known ? std::optional(orbit.stability.is_stable()) : std::nullopt;
      }>("stable", "whether all are inside the unit circle; null: there is no derivative"),
      field<&Orbit::stability, &Stability::kind>("kind", "how motions nearby approach or leave it",
                                                 the_only<NamedType<OrbitKind, orbit_kind_names>>()),
      field<&Orbit::is_symmetric>("symmetric", "whether it is its own mirror image"),
      field<&Orbit::mirror>("mirror", "place of its mirror image in the list; absent on branches", rule::none,
                            WithoutValue::omitted),
      field<&Orbit::found_by>("found_by",
                              "what the search started from: the `run`, a start of the `grid`, the `mirror` image of "
                              "another orbit, or by `continuation` a branch that passes the condition",
                              the_only<NamedType<FoundBy, found_by_names>>()),
      field<&Orbit::points>("points", "[tilt, tilt_rate, slip_rate] at the n instants, from `state` on",
                            the_only<PointsType>()),
  };
  return fields;
}

static const StructType& run_fields() {
  using Found = OrbitsOfCondition;
  static const StructType fields{
      "OrbitRun",
      field<&Found::termination>("termination", "why it ended",
                                 the_only<NamedType<dynamics::Termination, dynamics::termination_names>>()),
      field<&Found::mode>("mode", "response mode"),
      field<&Found::run_on>(
          "orbit", "place of the stable orbit on which it ended; null: none is within 1e-6 of its last strobe point"),
      derived<[](const Found& found) { return found.is_certified(); }>(
          "certified",
          "whether it ended on a stable orbit of the m and n of its response, or on the way to one that Newton's "
          "method found from "
          "there; null: the response is not (m,n)"),
  };
  return fields;
}

static const StructType& fields_of(const OrbitsOfCondition*) {
  using Found = OrbitsOfCondition;
  static const StructType fields{
      "OrbitsOfCondition",
      field<&Found::parameters>("parameters", "JSON pointer to value, for each entry of the sweep"),
      of_owner<Found>("run", "from the initial state of the file", run_fields()),
      field<&Found::searches>("searches", "Newton iterations that were started"),
      field<&Found::converged>("converged", "of these, to an orbit, new or not"),
      field<&Found::orbits>("orbits", "in the order in which they were found",
                            the_only<LinesType<std::vector<Orbit>>>()),
  };
  return fields;
}

static const StructType& fields_of(const BranchPoint*) {
  static const StructType fields{
      "BranchPoint",
      field<&BranchPoint::value>("value", "of the parameter"),
      inlined<&BranchPoint::orbit>(),
  };
  return fields;
}

static const StructType& fields_of(const OrbitBranch*) {
  using Found = OrbitBranch;
  static const StructType fields{
      "Branch",
      field<&Found::period>("period", "of its orbits", at_least_one),
      derived<[](const OrbitBranch& branch) { return cycles_of(branch); }>(
          "cycles", "m of most of its orbits, which with the period names the branch"),
      field<&Found::is_symmetric>("symmetric",
                                  "whether its orbits are; the mirror image of a branch that is not is not listed"),
      field<&Found::from>(
          "from", "place of the bifurcation at which it begins; null: it was followed from an orbit of a condition"),
      field<&Found::ends>(
          "ends",
          "why it ends before the first and behind the last point: `joins`: it branches off there from orbits of half "
          "the period, or from symmetric ones; `last_point`: no further orbit was found, and why was not located; "
          "`known`: it has come to a branch that is listed; `points`: their largest number"),
      field<&Found::points>("points", "orbits by arclength", the_only<LinesType<std::vector<BranchPoint>>>()),
  };
  return fields;
}

namespace {

using OrbitThere = std::optional<BranchPoint>;

OrbitThere orbit_of(const Bifurcation& found) {
  if (!found.orbit) return std::nullopt;
  return BranchPoint{.value = found.value, .orbit = *found.orbit};
}

void set_orbit(const OrbitThere& read, const ReadingPlace&, Bifurcation& found) {
  found.orbit = read ? std::optional(read->orbit) : std::nullopt;
}

}  // namespace

static const StructType& fields_of(const Bifurcation*) {
  using Found = Bifurcation;
  static const StructType fields{
      "Bifurcation",
      field<&Found::kind>("kind", "what happens to the orbits"),
      field<&Found::value>("value", "of the parameter"),
      field<&Found::error>("error", "largest error of the value", rule::positive),
      field<&Found::branch>("branch", "place of the branch on which it was located"),
      of_owner<Found>("orbit", "there; of a grazing, one beside it (branches.md); null: not known",
                      the_only<ConvertedType<Found, OrbitThere, orbit_of, set_orbit>>()),
  };
  return fields;
}

static const StructType& fields_of(const FoundBranches*) {
  using Found = FoundBranches;
  static const StructType fields{
      "FoundBranches",
      field<&Found::pointer>("parameter", "JSON pointer of the swept number over which branches were followed"),
      field<&Found::range>("range", "its smallest and largest value on branches"),
      field<&Found::most_points>("most_points", "largest number of points of a branch in each direction", at_least_one),
      field<&Found::study, &BranchStudy::is_complete>("complete", "whether every orbit that was found was followed"),
      field<&Found::study, &BranchStudy::branches>("branches", "orbits that are connected over the parameter"),
      field<&Found::study, &BranchStudy::bifurcations>("bifurcations", "of the branches",
                                                       the_only<LinesType<std::vector<Bifurcation>>>()),
  };
  return fields;
}

static const StructType& fields_of(const OrbitLabels*) {
  static const StructType fields{
      "OrbitLabels",
      field<&OrbitLabels::periodic>("periodic", "runs with a response (m,n)"),
      field<&OrbitLabels::certified>("certified", "of these, those that a stable orbit of this m and n backs"),
      field<&OrbitLabels::not_certified>("not_certified", "places of the other conditions"),
  };
  return fields;
}

static const StructType& fields_of(const OrbitStudy*) {
  static const StructType fields{
      "OrbitStudy",
      field<&OrbitStudy::longest>(
          "longest_period", "longest period that was searched from the grid, in excitation periods", at_least_one),
      derived<[](const OrbitStudy& study) { return labels_of(study); }>(
          "labels", "which responses (m,n) of the runs an orbit backs"),
      field<&OrbitStudy::conditions>("conditions", "of the experiment"),
      inlined<&OrbitStudy::branches>(),
  };
  return fields;
}

const StructType& fields_of(const OrbitsReport*) {
  static const StructType fields{
      "Orbits",
      field<&OrbitsReport::input>("input", "what was asked"),
      inlined<&OrbitsReport::study>(),
  };
  return fields;
}

const DocumentOf<OrbitsReport>& orbits_document() {
  static const DocumentOf<OrbitsReport> document(
      "rocking.orbits/1",
      "Periodic orbits of the conditions of an experiment with harmonic excitation in which nothing is random.",
      check_orbits_report);
  return document;
}

std::optional<double> swept_number(const OrbitsOfCondition& condition, const std::string& pointer) {
  const auto found = std::ranges::find(condition.parameters, pointer, &Parameter::pointer);
  if (found == condition.parameters.end()) return std::nullopt;
  return number_in(found->value);
}

OrbitsReport orbits_report(const Experiment& experiment, OrbitStudy study) {
  return {.input = input_of(experiment), .study = std::move(study)};
}

}  // namespace rocking

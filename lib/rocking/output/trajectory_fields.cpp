#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/output/validity_fields.hpp"

namespace rocking {
namespace {

using dynamics::ContactState;
using dynamics::EventKind;

constexpr const char* words_on_tilt =
    "Theta = theta/psi, psi of the side on which the block is (model.md, 11), or theta [rad]";
constexpr const char* words_on_tilt_rate = "Theta' = dTheta/dtau, or dtheta/dt [rad/s]";
constexpr const char* words_on_time = "tau = p t, or t [s]";

const ValueType& contact_type() { return the_only<NamedType<ContactState, dynamics::contact_names>>(); }

template <TrajectoryUnits units>
constexpr bool is_si = units == TrajectoryUnits::si;
template <TrajectoryUnits units>
constexpr const char* time_key = is_si<units> ? "time_s" : "tau";

template <TrajectoryUnits units>
const StructType& fields_in(const ReportedState*) {
  using State = ReportedState;
  static const StructType fields{
      is_si<units> ? "StateSi" : "State",
      field<&State::tilt>(is_si<units> ? "tilt_rad" : "tilt", words_on_tilt),
      field<&State::tilt_rate>(is_si<units> ? "tilt_rate_rad_s" : "tilt_rate", words_on_tilt_rate),
      field<&State::slip>(is_si<units> ? "slip_m" : "slip", "X over R, or in [m]"),
      field<&State::slip_rate>(is_si<units> ? "slip_rate_m_s" : "slip_rate", "V over R p, or in [m/s]"),
  };
  return fields;
}

/// The fields of a state stand among those of what has it.
template <TrajectoryUnits units, auto member>
Field state_in() {
  return inlined<member>(fields_in<units>(static_cast<const ReportedState*>(nullptr)));
}

template <TrajectoryUnits units>
const StructType& fields_in(const ReportedStrobe*) {
  using Strobe = ReportedStrobe;
  const Field period = field<&Strobe::period>("period", "excitation periods, from 1", Rule{.least = 1.0});
  const Field contact = field<&Strobe::contact>("contact", "contact state", contact_type());
  if constexpr (is_si<units>) {
    static const StructType fields{"StrobeSi", period, field<&Strobe::time>("time_s", "t [s]"),
                                   state_in<units, &Strobe::state>(), contact};
    return fields;
  } else {
    static const StructType fields{"Strobe", period, state_in<units, &Strobe::state>(), contact};
    return fields;
  }
}

template <TrajectoryUnits units>
const StructType& fields_in(const ReportedEvent*) {
  using Event = ReportedEvent;
  static const StructType fields{
      is_si<units> ? "EventSi" : "Event",
      field<&Event::time>(time_key<units>, words_on_time),
      field<&Event::kind>("kind", "what happens", the_only<NamedType<EventKind, dynamics::event_names>>()),
      state_in<units, &Event::state>(),
  };
  return fields;
}

template <TrajectoryUnits units>
const StructType& fields_in(const ReportedSample*) {
  using Sample = ReportedSample;
  static const StructType fields{
      is_si<units> ? "SampleSi" : "Sample",
      field<&Sample::time>(time_key<units>, words_on_time),
      state_in<units, &Sample::state>(),
      field<&Sample::contact>("contact", "contact state", contact_type()),
  };
  return fields;
}

template <TrajectoryUnits units>
const StructType& fields_in(const PeakValues*) {
  using Peaks = PeakValues;
  static const StructType fields{
      is_si<units> ? "PeaksSi" : "Peaks",
      field<&Peaks::tilt>(is_si<units> ? "tilt_rad" : "tilt", words_on_tilt, rule::not_negative),
      field<&Peaks::tilt_rate>(is_si<units> ? "tilt_rate_rad_s" : "tilt_rate", words_on_tilt_rate, rule::not_negative),
      field<&Peaks::slip>("slip", "X over R", rule::not_negative),
      field<&Peaks::slip_m>("slip_m", "X [m]", rule::not_negative),
      field<&Peaks::final_slip>("final_slip", "X at the end over R, > 0 to the right"),
      field<&Peaks::final_slip_m>("final_slip_m", "the same [m]"),
  };
  return fields;
}

template <TrajectoryUnits units>
const StructType& fields_in(const TrajectoryValidity*) {
  using Found = TrajectoryValidity;
  static const StructType fields{
      is_si<units> ? "TrajectoryValiditySi" : "TrajectoryValidity",
      field<&Found::losses_of_contact>("losses_of_contact", "downward crossings of N = 0"),
      field<&Found::first_loss_of_contact>(is_si<units> ? "first_loss_of_contact_s" : "first_loss_of_contact",
                                           "time of the first one, tau or [s]; null: there is none",
                                           rule::not_negative),
      field<&Found::losses_before_fall>("losses_before_fall", "losses of contact but for those of the final fall"),
      field<&Found::contradictions>("contradictions",
                                    "instants at which neither sticking nor slipping agrees with the equations"),
  };
  return fields;
}

template <class Item, TrajectoryUnits units>
const ValueType& item_in() {
  return fields_in<units>(static_cast<const Item*>(nullptr));
}

template <class Part, TrajectoryUnits units>
const ValueType& type_in() {
  if constexpr (detail::is_list<Part>) {
    return the_only<LinesType<Part, item_in<typename Part::value_type, units>>>();
  } else {
    return item_in<Part, units>();
  }
}

/// A part of a trajectory whose keys have the units of the file, which are read before.
template <auto part>
class PartType final : public ValueType {
  using Part = std::remove_cvref_t<decltype(std::declval<TrajectoryReport>().*part)>;

 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& report = *static_cast<const TrajectoryReport*>(value);
    return type(report.units).json(&(report.*part));
  }
  void write(const void* value, std::string_view key, JsonWriter& out) const override {
    const auto& report = *static_cast<const TrajectoryReport*>(value);
    type(report.units).write(&(report.*part), key, out);
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& report = *static_cast<TrajectoryReport*>(value);
    type(report.units).read(json, place, &(report.*part));
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    return {{"anyOf", {type(TrajectoryUnits::normalised).schema(rule), type(TrajectoryUnits::si).schema(rule)}}};
  }
  void describe(const std::string& prefix, std::vector<KeyRow>& rows) const override {
    type(TrajectoryUnits::normalised).describe(prefix, rows);
  }

 private:
  static const ValueType& type(TrajectoryUnits units) {
    return units == TrajectoryUnits::si ? type_in<Part, TrajectoryUnits::si>()
                                        : type_in<Part, TrajectoryUnits::normalised>();
  }
};

template <auto part>
Field part_in_units(std::string_view key, std::string_view sentence) {
  return of_owner<TrajectoryReport>(key, sentence, the_only<PartType<part>>());
}

Field history_field() {
  return only_where<[](const TrajectoryReport& report) { return !report.history.empty(); }>(
      part_in_units<&TrajectoryReport::history>(
          "history", "states evenly spaced in time from tau = 0 on, with `--samples`; they change no other value"));
}

const StructType& energy_fields() {
  using Account = EnergyAccount;
  static const StructType fields{
      "EnergyBalance",
      field<&Account::at_start>("at_start", "kinetic and potential energy, relative to the base"),
      field<&Account::at_end>("at_end", "the same at the end"),
      field<&Account::base_work>("base_work", "of the base on the block"),
      field<&Account::friction_work>("friction_work", "of kinetic friction; 0 or less while N > 0"),
      field<&Account::lost_in_impacts>("lost_in_impacts", "energy"),
      field<&Account::gained_in_impacts>("gained_in_impacts", "energy; 0 except for squat blocks with e > 1/3"),
      derived<[](const Account& account) { return account.unaccounted(); }>(
          "unaccounted",
          "the remaining difference: 0 to rounding and tolerance in correct mechanics, but not with `slide_inertia` "
          "`edge`"),
  };
  return fields;
}

}  // namespace

namespace {

using Pair = std::array<double, 2>;

Pair edges_of(const dynamics::MassLayout& mass) { return {mass.left_edge, mass.right_edge}; }
void set_edges(const Pair& read, const ReadingPlace&, dynamics::MassLayout& mass) {
  mass.left_edge = read[0];
  mass.right_edge = read[1];
}
using EdgesType = ConvertedType<dynamics::MassLayout, Pair, edges_of, set_edges>;

const StructType& mass_fields() {
  using Mass = dynamics::MassLayout;
  static const StructType fields{
      "MassLayout",
      of_owner<Mass>("edges_m",
                     "distances of the left and the right edge from the centre of mass [m]; only of a block that the "
                     "file gives with more than width and height, as the next ones",
                     the_only<EdgesType>(), rule::positive),
      field<&Mass::centre_height>("centre_height_m", "of the centre of mass above the base [m]", rule::positive),
      field<&Mass::radius_of_gyration>("radius_of_gyration_m", "sqrt(I/m) about the centre of mass [m]",
                                       rule::positive),
  };
  return fields;
}

Field shape_angles_field() {
  using dynamics::Block;
  return only_where<[](const Block& block) { return block.mass.has_value(); }>(derived<[](const Block& block) {
    const dynamics::Geometry geometry = geometry_of(block);
    return Pair{geometry.edges[0].shape_angle, geometry.edges[1].shape_angle};
  }>("shape_angles_rad", "psi of the left and of the right edge [rad]"));
}

}  // namespace

const StructType& block_fields() {
  using dynamics::Block;
  using dynamics::geometry_of;
  static const StructType fields{
      "Block",
      field<&Block::width>("width_m", "B [m]", rule::positive),
      field<&Block::height>("height_m", "H [m]", rule::positive),
      field<&Block::gravity>("gravity_m_s2", "g [m/s^2]", rule::positive),
      derived<[](const Block& block) { return geometry_of(block).shape_angle; }>(
          "shape_angle_rad", "psi [rad]; of unlike edges the smaller one"),
      derived<[](const Block& block) { return geometry_of(block).half_diagonal; }>("half_diagonal_m",
                                                                                   "R [m] (model.md, 1 and 11)"),
      derived<[](const Block& block) { return geometry_of(block).frequency_parameter; }>("frequency_parameter_rad_s",
                                                                                         "p [rad/s]"),
      shape_angles_field(),
      inlined<&Block::mass>(mass_fields()),
  };
  return fields;
}

template <>
struct TypeOf<TrajectoryUnits> : OnlyType<NamedType<TrajectoryUnits, trajectory_unit_names>> {};

namespace {

Field backing_field() {
  return only_where<[](const TrajectoryReport& report) { return backing_of(report).has_value(); }>(
      derived<[](const TrajectoryReport& report) { return *backing_of(report); }>(
          "backed_by", "what backs a label (m,n): a stable orbit, points that repeat, or clouds"));
}

}  // namespace

const StructType& fields_of(const TrajectoryReport*) {
  using File = TrajectoryReport;
  static const StructType fields{
      "TrajectoryReport",
      field<&File::key, &RealisationKey::condition>("condition", "its number, from 0"),
      field<&File::key, &RealisationKey::realisation>("realisation", "its number, from 0"),
      field<&File::units>("units", "`si` with `--units si`"),
      field<&File::block>("block", "of this realisation, and the scales that follow from it", block_fields()),
      part_in_units<&File::strobe>("strobe", "states at tau = 2 pi period/Omega_h, after the events of that instant"),
      part_in_units<&File::events>("events", "with the state after each"),
      field<&File::samples_per_period>("samples_per_period", "of the history, with `--samples`", Rule{.least = 1.0},
                                       WithoutValue::omitted),
      history_field(),
      part_in_units<&File::peaks>("peaks", "largest absolute values of the motion until it ended, from tau = 0 on"),
      part_in_units<&File::validity>("validity", "departures from the model (model.md, 7)"),
      field<&File::energy>("energy", "over m R^2 p^2, since the mass of the block is not known", energy_fields()),
      field<&File::termination>("termination", "why it ended",
                                the_only<NamedType<dynamics::Termination, dynamics::termination_names>>()),
      field<&File::mode>("mode", "response mode that a run gives this realisation; not with `--periods`", {},
                         WithoutValue::omitted),
      field<&File::reason>("reason", "the rule that gave it, or why it is unresolved", {}, WithoutValue::omitted),
      backing_field(),
  };
  return fields;
}

namespace {

void check_report(const TrajectoryReport& report, const ReadingPlace& place) {
  if (report.samples_per_period.has_value() == report.history.empty()) {
    return place.at("history").reject(Json(), "and samples_per_period must both be given or both be absent");
  }
  for (std::size_t i = 1; i < report.history.size(); ++i) {
    if (report.history[i].time > report.history[i - 1].time) continue;
    return place.at("history")
        .at(std::to_string(i))
        .reject(Json(report.history[i].time), "is not later than the previous sample");
  }
}

}  // namespace

const DocumentOf<TrajectoryReport>& trajectory_document() {
  static const DocumentOf<TrajectoryReport> document("rocking.trajectory/1", "The motion of one realisation.",
                                                     check_report);
  return document;
}

}  // namespace rocking

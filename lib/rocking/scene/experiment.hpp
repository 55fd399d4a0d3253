#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/excitation.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking {

/// Bounds of a width and of a height [m].
inline constexpr double least_length = 1e-6;
inline constexpr double largest_length = 1e6;

/// A rectangle of uniform density.
struct UniformMass {
  friend bool operator==(const UniformMass&, const UniformMass&) = default;
};

/// Numbers beside a width and a height; what is absent is that of a uniform rectangle.
struct GivenCentre {
  std::optional<Quantity> height = std::nullopt;              ///< of the centre of mass above the base [m]
  std::optional<Quantity> offset = std::nullopt;              ///< to the right of the middle of the base [m]
  std::optional<Quantity> radius_of_gyration = std::nullopt;  ///< about the centre of mass [m]
  friend bool operator==(const GivenCentre&, const GivenCentre&) = default;
};

/// Numbers of a body whose outline is not given.
struct GivenEdges {
  std::array<Quantity, 2> edges{0.5, 0.5};  ///< distances of the left and the right edge from the centre of mass [m]
  Quantity centre_height = 2.0;             ///< of the centre of mass above the base [m]
  Quantity radius_of_gyration = 1.0;        ///< about the centre of mass [m]
  friend bool operator==(const GivenEdges&, const GivenEdges&) = default;
};

/// A rectangle of uniform density, one of those that make a body.
struct BlockPart {
  Quantity width = 1.0;   ///< [m]
  Quantity height = 1.0;  ///< [m]
  Quantity mass = 1.0;    ///< [kg]
  Quantity x = 0.0;       ///< of its middle [m]
  Quantity bottom = 0.0;  ///< above the floor [m]
  friend bool operator==(const BlockPart&, const BlockPart&) = default;
};
inline constexpr std::size_t most_parts = 32;

struct GivenParts {
  std::vector<BlockPart> parts;
  /// x of the left and the right end of the base [m]; absent: those of the parts that stand on the floor.
  std::optional<std::array<Quantity, 2>> base = std::nullopt;
  friend bool operator==(const GivenParts&, const GivenParts&) = default;
};

/// A rectangle of uniform density by the two numbers of its equations.
struct GivenSlenderness {
  double frequency_parameter = 1.0;  ///< p [rad/s]: R = 3 g/(4 p^2)
  double slenderness = 0.25;         ///< psi [rad]: B = 2 R sin(psi), H = 2 R cos(psi)
  friend bool operator==(const GivenSlenderness&, const GivenSlenderness&) = default;
};

/// Where the mass of a block is, in one of the forms of a file.
using SceneMass = std::variant<UniformMass, GivenCentre, GivenEdges, GivenParts, GivenSlenderness>;

/// Asked for: a rigid block, rectangular and of uniform density unless its mass is laid out otherwise. Each realisation
/// draws the numbers that have laws, and truncates lengths to the bounds.
struct SceneBlock {
  Quantity width = 1.0;   ///< B [m]; not used with edges, parts or slenderness
  Quantity height = 4.0;  ///< H [m]; likewise
  double gravity = 9.81;  ///< g [m/s^2]
  SceneMass mass = {};
  /// At which a wall stands, so that the block turns to the other one only. What an impact there leaves is a WallRatio.
  std::optional<dynamics::Side> wall = std::nullopt;
  friend bool operator==(const SceneBlock&, const SceneBlock&) = default;
};

/// Two shapes between which every block of a scene lies.
struct ShapeRange {
  dynamics::Geometry most_slender;         ///< smallest tan(psi) of an edge
  dynamics::Geometry squattest;            ///< largest tan(psi) of an edge
  std::array<double, 2> least_tangents{};  ///< smallest tan(psi) of the left and of the right edge, each of any block
};

/// Two sizes between which every block of a scene lies.
struct SizeRange {
  dynamics::Geometry smallest;  ///< smallest R
  dynamics::Geometry largest;   ///< largest R
};

/// The block with the mean of each number. Its width and height are those of an outline to draw: of given edges a rectangle
/// between them with the centre of mass at half its height, of parts their extent.
[[nodiscard]] dynamics::Block mean_of(const SceneBlock& block);

/// A block to draw, in metres from the left end of its base.
struct BlockOutline {
  struct Rectangle {
    double left, right, bottom, top;
  };
  std::vector<Rectangle> rectangles;  ///< one, or the parts
  double base = 0.0;                  ///< distance of the edges
  double centre_x = 0.0;              ///< of the centre of mass
  double centre_height = 0.0;         ///< likewise, above the base
  bool is_given = true;               ///< otherwise it is only known where the edges and the centre of mass are
  double open_side = 0.0;             ///< dynamics::Block::open_side: a wall stands at the other one

  [[nodiscard]] double left() const;
  [[nodiscard]] double right() const;
  [[nodiscard]] double top() const;
  /// A rectangle on its whole base.
  [[nodiscard]] bool is_plain() const { return rectangles.size() == 1 && left() == 0.0 && right() == base; }
};

/// Of the block with the mean of each number; of given edges a rectangle between them, twice as high as the centre of mass.
[[nodiscard]] BlockOutline outline_of(const SceneBlock& block);

/// Over the corners of the box in which the drawn numbers lie.
[[nodiscard]] ShapeRange shapes_of(const SceneBlock& block);
[[nodiscard]] SizeRange sizes_of(const SceneBlock& block);

/// Whether any number of the block has a law.
[[nodiscard]] bool is_drawn(const SceneBlock& block);

/// e is dynamics::inelastic_rate_ratio of each block. Source: Jeong & Yang (2012) Eq. 25.
struct Jy25Restitution {
  friend bool operator==(const Jy25Restitution&, const Jy25Restitution&) = default;
};

/// The ratio abs(w2/w1) of the tilt rates across an impact without slip, as it is measured on a block that goes on over
/// its other edge [-]. e follows from each block: dynamics::restitution_of_rate_ratio.
struct RateRatio {
  Quantity value = 1.0;                          ///< of both edges, or where the left edge lands
  std::optional<Quantity> right = std::nullopt;  ///< where the right edge lands
  friend bool operator==(const RateRatio&, const RateRatio&) = default;
};

/// The ratio abs(w2/w1) of the tilt rates across an impact on floor and wall at once, after which the block turns away from
/// the wall again [-]. e follows from the edge that lands: dynamics::restitution_of_rate_ratio of its negative.
struct WallRatio {
  Quantity value = 0.5;
  friend bool operator==(const WallRatio&, const WallRatio&) = default;
};

/// The vertical restitution e of an impact [-], or what it follows from. What each law gives: scene/restitution.cpp.
using Restitution = std::variant<Quantity, Jy25Restitution, RateRatio, WallRatio>;

struct Friction {
  Quantity static_coefficient = 0.0;                   ///< mu_s [-]
  Quantity kinetic_coefficient = 0.0;                  ///< mu_k [-]; not used with a ratio
  std::optional<double> kinetic_ratio = std::nullopt;  ///< mu_k over the mu_s that was drawn
  friend bool operator==(const Friction&, const Friction&) = default;
};

/// Means of the coefficients, or the numbers themselves.
[[nodiscard]] double mean_static(const Friction& friction);
[[nodiscard]] double mean_kinetic(const Friction& friction);

/// Law of a number that is drawn again along the way. All are functions of a normal number z: mean + sigma z;
/// lognormal; uniform, from mean - sqrt(3) sigma to mean + sqrt(3) sigma at the probability Phi(z).
enum class FluctuationLaw : std::uint8_t { normal, lognormal, uniform };
inline constexpr std::array<std::string_view, 3> fluctuation_law_names{"normal", "lognormal", "uniform"};

struct FluctuationLaws {
  FluctuationLaw static_friction = FluctuationLaw::normal;
  FluctuationLaw kinetic_friction = FluctuationLaw::normal;
  FluctuationLaw restitution = FluctuationLaw::normal;
  FluctuationLaw amplitude = FluctuationLaw::normal;
  friend bool operator==(const FluctuationLaws&, const FluctuationLaws&) = default;
};

/// The law with this mean and standard deviation as a quantity; without a deviation the number.
[[nodiscard]] RedrawnQuantity law_along_the_way(FluctuationLaw law, double mean, double sigma);

/// Standard deviations, in the unit in which the mean is given: that of `amplitude` in g where the amplitude is, that
/// of `restitution` as a rate ratio where the restitution is (`jy25`: of e). If one is 0, its source is off and no
/// number is drawn for it.
struct Fluctuation {
  double static_friction = 0.0;
  double kinetic_friction = 0.0;
  int refreshes_per_period = 200;  ///< intervals of constant kinetic friction per excitation period
  /// Length of the cells of the base, each with its own static and kinetic friction [m]. Absent: kinetic friction is
  /// drawn again in time, and static friction at each stop.
  std::optional<double> refresh_slip_m = {};
  double restitution = 0.0;
  double amplitude = 0.0;
  FluctuationLaws laws = {};
  /// Of the normal numbers from which static and kinetic friction in force follow, from -1 to 1.
  double friction_correlation = 0.0;
  friend bool operator==(const Fluctuation&, const Fluctuation&) = default;
};

/// Whether a number of a state is normalised by the block of the realisation, or given in rad, m and s; a tilt also in degrees.
enum class StateUnit : std::uint8_t { normalised, si, degrees };

struct InitialUnits {
  StateUnit tilt = StateUnit::normalised;
  StateUnit tilt_rate = StateUnit::normalised;
  StateUnit slip = StateUnit::normalised;
  StateUnit slip_rate = StateUnit::normalised;
  friend bool operator==(const InitialUnits&, const InitialUnits&) = default;
};

struct InitialState {
  Quantity tilt = 0.0;       ///< Theta = theta/psi [-], or theta [rad] or [degrees]
  Quantity tilt_rate = 0.0;  ///< Theta' = w/psi [-], or p w [rad/s]
  Quantity slip = 0.0;       ///< X [-], or X R [m]
  Quantity slip_rate = 0.0;  ///< V [-], or V p R [m/s]
  InitialUnits units = {};
  friend bool operator==(const InitialState&, const InitialState&) = default;
};

/// [rad], of a number of a tilt beside the shape angle psi.
[[nodiscard]] constexpr double tilt_unit(StateUnit unit, double psi) {
  constexpr double degree = 0x1.1df46a2529d39p-6;
  return unit == StateUnit::normalised ? psi : unit == StateUnit::degrees ? degree : 1.0;
}

/// One block on one shaken base: everything that determines the motion of a realisation, except its random numbers.
struct Scene {
  SceneBlock block;
  dynamics::SlideInertia slide_inertia = dynamics::SlideInertia::centroidal;
  dynamics::ImpactSlipRule impact_slip_rule = dynamics::ImpactSlipRule::absolute;
  Restitution restitution = 0.0;
  Excitation excitation;
  std::optional<Friction> friction;  ///< absent: the block cannot slide
  Fluctuation fluctuation;
  InitialState initial;
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// A realisation whose response is not classified by its sampled periods goes on, window by window, each as long as
/// these.
struct UntilClassified {
  std::int64_t at_most_periods = 20'000;  ///< from the start on; a window that would end later is not begun
  int held_windows = 1;                   ///< the response has settled if so many successive windows give one mode
  int watch_windows = 0;                  ///< windows that a settled response is observed for, until it is left
  std::uint64_t long_run_every = 0;       ///< every N-th realisation has a long run up to the limit; 0: none
  int exponent_pause = 0;                 ///< windows without exponent after one whose exponent stayed unclear
  friend bool operator==(const UntilClassified&, const UntilClassified&) = default;
};

/// The tilt at which a motion ends as overturned: pi/2, or psi.
enum class MotionEnd : std::uint8_t { overturned, balance };

struct Horizon {
  int transient_periods = 500;  ///< excitation periods that are not used for the classification
  int sampled_periods = 120;    ///< excitation periods whose strobe points are classified
  std::optional<UntilClassified> until_classified = std::nullopt;  ///< absent: every realisation ends there
  MotionEnd until = MotionEnd::overturned;

  [[nodiscard]] std::int64_t periods() const { return std::int64_t{transient_periods} + sampled_periods; }
  friend bool operator==(const Horizon&, const Horizon&) = default;
};

/// A part of an experiment file as JSON text.
struct WrittenPart {
  std::string text;
  friend auto operator<=>(const WrittenPart&, const WrittenPart&) = default;
};

/// A value that the sweep sets: a number, a whole number, a word, or any other part, such as a law.
using SweptValue = std::variant<double, std::int64_t, std::string, WrittenPart>;

/// The number; absent of a value that is none.
[[nodiscard]] std::optional<double> number_in(const SweptValue& value);

/// What the sweep sets for a condition, with its JSON pointer into the experiment file.
struct Parameter {
  std::string pointer;
  SweptValue value;
  std::string name =
      {};  ///< of the value, for readers; empty: it has none. Two parameters may differ in it and be equal
  friend auto operator<=>(const Parameter& a, const Parameter& b) {
    return std::tie(a.pointer, a.value) <=> std::tie(b.pointer, b.value);
  }
  friend bool operator==(const Parameter& a, const Parameter& b) { return (a <=> b) == 0; }
};

/// Sampling continues until the interval of every mode, or that of one, is narrow enough. Exactly one of the two
/// half-widths is given; the relative one needs a mode.
struct Until {
  std::optional<double> half_width = std::nullopt;           ///< in (0, 1/2)
  std::optional<double> relative_half_width = std::nullopt;  ///< relative to the estimate k/n, in (0, 1)
  std::optional<section::ResponseMode> mode = std::nullopt;  ///< whose interval is looked at; absent: every one
  friend bool operator==(const Until&, const Until&) = default;
};

/// One point of the sweep.
struct Condition {
  std::vector<Parameter> parameters;
  Scene scene;
  Horizon horizon;
  double tolerance = 1e-13;        ///< largest last Taylor term of a step, in units of Theta, Theta'; > 0
  std::uint64_t rerun_every = 10;  ///< every N-th realisation is rerun at a tighter tolerance; 0: none
  std::uint64_t realisations = 1;  ///< > 0; with `until` the largest number
  std::optional<Until> until;
  double confidence = 0.95;
  /// The first 64 bits of the SHA-256 of the record, where it is of a suite: records have independent random numbers.
  std::uint64_t record_stream = 0;
  friend bool operator==(const Condition&, const Condition&) = default;
};

/// The seed under which the realisations of a condition are drawn (lib/docs/draws.md).
[[nodiscard]] inline std::uint64_t seed_of(const Condition& condition, std::uint64_t seed_of_experiment) {
  return seed_of_experiment ^ condition.record_stream;
}

/// Most unknowns of an experiment.
inline constexpr std::size_t most_unknowns = 3;

/// A number of the experiment that counted tests are to determine.
struct Unknown {
  std::string pointer;                           ///< JSON pointer to it
  double from = 0.0;                             ///< smallest value, in the unit of the number
  double to = 1.0;                               ///< largest value, above `from`
  std::optional<Quantity> prior = std::nullopt;  ///< a law with a density; absent: none, or uniform beside others
};

/// The input that a user declared.
struct Experiment {
  std::string title;
  std::uint64_t seed = 0;
  std::vector<Condition> conditions;          ///< grid of the sweep; its last entry varies fastest
  std::string canonical_text;                 ///< the file with all defaults, as JSON text: equal for equal experiments
  std::vector<std::size_t> sweep_sizes = {};  ///< number of values of each entry of the sweep
  std::vector<Unknown> unknowns = {};         ///< of `rocking infer`; no run looks at them
  std::vector<std::string> left_out = {};     ///< names of records of its suite that could not be read
};

/// The block that stands for all blocks of a scene where only one can: in tables and sketches, in the horizon and the
/// strobe under a ground motion.
[[nodiscard]] inline dynamics::Block mean_block(const Scene& scene) { return mean_of(scene.block); }

/// Mean A_h for a block; under a ground motion the scale [-].
[[nodiscard]] double amplitude_for(const Scene& scene, const dynamics::Geometry& block);

/// psi g of a block in the unit in which the amplitude is given; 1 for A_h and for the scale of a ground motion.
[[nodiscard]] double amplitude_unit(const Scene& scene, const dynamics::Geometry& block);

/// Omega_h of the clock and the strobe for a block. Physical motions and their strobe do not change with the block: a
/// ground motion's ratio is given in units of p of the mean block, and a physical frequency in Hz or by its period.
[[nodiscard]] double frequency_ratio_for(const Scene& scene, const dynamics::Geometry& block);

/// After so many excitation periods the base motion repeats, in every realisation; absent: never, or not in all. 1 for a
/// harmonic motion without a vertical part or with one of a whole multiple of its frequency.
[[nodiscard]] std::optional<std::int64_t> periods_of_base(const Scene& scene);

/// Whether the mirror image of a motion is a motion half a period later: both edges are alike, and the base moves vertically
/// then as before.
[[nodiscard]] bool has_mirror_symmetry(const Scene& scene);

/// Whether anything is drawn while a realisation moves. What is drawn once, at its start, makes nothing random within it.
[[nodiscard]] bool is_random_along_the_way(const Scene& scene);

/// The numbers that each realisation draws once.
[[nodiscard]] std::vector<NamedPlace> drawn_once(const Scene& scene);

/// Whether any quantity of the scene is random. If not, all realisations are equal and one suffices.
[[nodiscard]] bool is_random(const Scene& scene);

/// Largest number of realisations that a condition runs: one if nothing is random.
[[nodiscard]] std::uint64_t effective_realisations(const Condition& condition);

/// The confidence of all conditions; absent if a sweep varies it.
[[nodiscard]] std::optional<double> common_confidence(const Experiment& experiment);

/// Confidence of an interval over all conditions together: the highest one of the conditions.
[[nodiscard]] double highest_confidence(const Experiment& experiment);

/// Values that replace those of an experiment file. Checked as if they stood there.
struct Overrides {
  std::optional<std::string> seed = {};          ///< `--seed`
  std::optional<std::string> realisations = {};  ///< `--realisations`
  std::vector<double> levels = {};               ///< `--levels`: intensities that the sweep has as well
  bool skips_unreadable = false;                 ///< `--skip-unreadable`: goes on without such records of a suite
};

/// Place of the level of a record that a table selects for it.
inline constexpr std::string_view level_pointer = "/excitation/level";

/// JSON pointers to numbers that are intensities of the excitation.
inline constexpr std::array<std::string_view, 11> all_intensity_pointers{"/excitation/amplitude",
                                                                         "/excitation/amplitude_g",
                                                                         "/excitation/amplitude_m_s2",
                                                                         "/excitation/scale",
                                                                         "/excitation/pga_g",
                                                                         "/excitation/pgv_m_s",
                                                                         "/excitation/sa_g",
                                                                         "/excitation/sa_p_g",
                                                                         "/excitation/avgsa_g",
                                                                         "/excitation/sa_absolute_g",
                                                                         level_pointer};

}  // namespace rocking

#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "rocking/input/read_experiment.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "support/ordinary_steps.hpp"

/// The fuzzed code, as functions of bytes. A fuzzer calls them with generated input, replay_test with the corpus.
namespace rocking::fuzz {

/// A result that no input may cause.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// Contents of every file that an experiment names: the same few lines, valid as a ground motion with times and as one
/// with even spacing. No file of the machine is opened.
inline std::string made_up_file(const std::string& name, std::size_t) {
  if (name.find("absent") != std::string::npos) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory), name);
  }
  if (name.find("at2") != std::string::npos) return "a\nb\nUNITS OF G\nNPTS= 3, DT= .1 SEC\n .5 -.7\n .4\n";
  if (name.find("vertical") != std::string::npos) return "0 0.5 0\n0.1 6 -3\n0.1 -7 2\n0.5 4 1\n";
  return name.find("bad") != std::string::npos ? "0 x\n" : "0 0.5\n0.1 6\n0.2 -7\n0.3 4\n";
}

/// Files that a pattern fits: two, unless it is about an absent one.
inline std::vector<std::string> made_up_matches(const std::string& pattern) {
  if (pattern.find("absent") != std::string::npos) return {};
  return {"one.at2", "two.txt"};
}

/// Reads an experiment with few conditions. Throws base::InputError if it is not valid.
inline Experiment read_small_experiment(std::string_view text) {
  return experiment_in(text, {}, {.files = made_up_file, .matches = made_up_matches, .most_conditions = 32});
}

/// A text is refused with its problems, or its canonical text reproduces itself and has the same number of conditions.
inline void try_experiment(std::string_view text) {
  try {
    const Experiment read = read_small_experiment(text);
    demand(!read.conditions.empty(), "an experiment has a condition");
    try {
      const Experiment again = read_small_experiment(read.canonical_text);
      demand(again.canonical_text == read.canonical_text, "the canonical text is its own: " + read.canonical_text);
      demand(again.conditions.size() == read.conditions.size(), "it has the same conditions");
    } catch (const base::InputError& error) {
      throw Finding("the canonical text is refused: " + std::string(error.what()) + "\n" + read.canonical_text);
    }
  } catch (const base::InputError& error) {
    demand(!error.problems().empty(), "a refusal has a reason");
    for (const base::Problem& problem : error.problems()) {
      demand(!problem.place.empty() && !problem.reason.empty(), "a problem has a place and a reason");
    }
  } catch (const std::system_error&) {  // the file does not exist
  }
}

/// A ground motion in any format is refused with its problems, or it is valid. The first byte selects whether a time
/// step, and whether a format, a unit, columns or a component are given.
inline void try_record(std::string_view text) {
  if (text.empty()) return;
  GroundMotionReading how{.name = "record.txt", .time_step = {}, .gravity = 9.81};
  const auto choice = static_cast<unsigned char>(text.front());
  if (choice % 2 == 0) how.time_step = 0.01;
  const std::size_t place = choice / 2;
  if (choice >= 128) {
    how.unit = static_cast<RecordUnit>(place % record_unit_names.size());
  } else if (place % 4 != 0) {
    how.format = static_cast<RecordFormat>(place / 4 % record_readers.size());
  }
  if (choice >= 'A' && choice <= 'Z') {
    how.columns = {how.time_step ? RecordColumn::other : RecordColumn::time, RecordColumn::horizontal,
                   RecordColumn::vertical};
  }
  if (choice >= '0' && choice <= '4') how.component = "channel 1";
  how.takes_vertical = choice >= '5' && choice <= '9';
  Problems problems;
  const auto motion = read_ground_motion(text.substr(1), how, problems);
  demand(motion.has_value() == problems.empty(), "a ground motion is read, or its problems are reported");
  if (!motion) return;
  demand(motion->samples.size() >= 2, "a ground motion has samples");
  demand(!motion->format.empty() && !motion->unit.empty(), "its format and unit are known");
  const std::size_t declared = motion->declared.value_or(motion->samples.size());
  demand(motion->samples.size() <= declared + 1 && declared <= motion->samples.size() + 1, "it has what it declares");
  demand(!motion->warnings.empty() || declared == motion->samples.size(), "a difference is told");
  double before = 0.0;
  for (const auto& sample : motion->samples) {
    demand(sample.time >= before, "times do not fall");
    demand(std::isfinite(sample.horizontal) && std::isfinite(sample.vertical), "accelerations are finite");
    demand(motion->has_vertical || sample.vertical == 0.0, "what is not recorded is 0");
    before = sample.time;
  }
}

/// A hazard curve is refused with its problems, or it does not rise, and the rate of any block's overturning is between 0 and
/// that of its first point.
inline void try_hazard_with(std::string_view text, const HazardReading& reading) {
  try {
    const HazardCurve hazard = read_hazard(text, "hazard.csv", reading);
    demand(hazard.points.size() >= 2, "a hazard curve has points");
    for (std::size_t i = 0; i < hazard.points.size(); ++i) {
      const HazardPoint& point = hazard.points[i];
      demand(point.intensity > 0.0 && std::isfinite(point.intensity), "intensities are positive");
      demand(point.rate >= 0.0 && std::isfinite(point.rate), "rates are not negative");
      if (i == 0) continue;
      demand(point.intensity > hazard.points[i - 1].intensity, "intensities rise");
      demand(point.rate <= hazard.points[i - 1].rate, "rates do not rise");
    }
    const std::vector<HazardPiece> pieces = pieces_between(hazard, hazard.points.front().intensity);
    for (const HazardPoint& median : {hazard.points.front(), hazard.points.back()}) {
      for (const double dispersion : {1e-3, 0.4, 2.0}) {
        const double rate = rate_of({.centre = std::log(median.intensity), .dispersion = dispersion}, pieces);
        demand(rate >= 0.0 && rate <= hazard.points.front().rate * (1.0 + 1e-9),
               "a rate is that of a part of the events");
      }
    }
  } catch (const base::InputError& error) {
    demand(!error.problems().empty(), "a refusal has a reason");
    for (const base::Problem& problem : error.problems()) demand(!problem.reason.empty(), "a problem has a reason");
  }
}

inline void try_hazard(std::string_view text) {
  for (const std::optional<double>& years : {std::optional<double>(), std::optional(50.0)}) {
    try_hazard_with(text, {.years = years});
    try_hazard_with(text, {.years = years, .measure = "scale"});
  }
}

/// A motion that is stopped after some steps.
template <class Motion>
struct Limited : support::OrdinarySteps<Motion> {
  int steps_left;

  [[nodiscard]] bool ended() const { return steps_left <= 0 || this->motion.ended(); }
  [[nodiscard]] double expand(double reach) {
    --steps_left;
    return this->motion.expand(reach);
  }
};

/// Checks that states are valid.
class Watch final : public dynamics::Observer {
 public:
  void event(dynamics::EventKind, double tau, const dynamics::State& state) override {
    demand(std::isfinite(tau), "events have a time");
    demand(tau >= last_, "time does not fall");
    last_ = tau;
    strobe(state);
  }
  void strobe(const dynamics::State& state) override {
    demand(std::isfinite(state.tilt) && std::isfinite(state.tilt_rate), "the block stands somewhere");
    demand(std::isfinite(state.slip) && std::isfinite(state.slip_rate), "the block slides somewhere");
  }

 private:
  double last_ = 0.0;
};

/// Any experiment that the reader accepts can be run: two periods of its first condition, at most 2000 steps.
inline void try_scene(std::string_view text) {
  try {
    const Experiment read = read_small_experiment(text);
    const Condition& condition = read.conditions.front();
    const random::Draws draws(read.seed, 0);
    const Start start = start_of(condition.scene, draws);
    Watch watch;
    const auto beginning = begin_realisation(condition, draws, start, Strobe::start, 2);
    Motion motion = motion_of(condition.scene, beginning, watch);
    Limited<Motion> limited{{motion}, 2000};
    static_cast<void>(integrate::advance(limited));
    watch.strobe(motion.state());
  } catch (const base::InputError&) {
  } catch (const std::system_error&) {
  }
}

}  // namespace rocking::fuzz

#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "rocking/experiment/realisation.hpp"
#include "rocking/report/read_experiment.hpp"
#include "rocking/report/read_record.hpp"

/// What is fuzzed, as functions from bytes to nothing. A fuzzer calls them with what it makes up; replay_test calls them
/// with what was worth keeping.
namespace rocking::fuzz {

/// Something that must not happen, whatever the input.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// What an experiment finds where it names a file: the same few lines, which are a record with times and one with even
/// spacing. No file of the machine is opened.
inline std::string made_up_file(const std::string& name, std::size_t) {
  if (name.find("absent") != std::string::npos) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory), name);
  }
  if (name.find("vertical") != std::string::npos) return "0 0.5 0\n0.1 6 -3\n0.1 -7 2\n0.5 4 1\n";
  return name.find("bad") != std::string::npos ? "0 x\n" : "0 0.5\n0.1 6\n0.1 -7\n0.5 4\n";
}

/// An experiment of few conditions. Throws base::InputError where it is none.
inline experiment::Experiment read_small_experiment(std::string_view text) {
  return report::read_experiment(text, {}, {.files = made_up_file, .most_conditions = 32});
}

/// A text is refused with its problems, or its canonical text is its own and means the same number of conditions.
inline void try_experiment(std::string_view text) {
  try {
    const experiment::Experiment read = read_small_experiment(text);
    demand(!read.conditions.empty(), "an experiment has a condition");
    try {
      const experiment::Experiment again = read_small_experiment(read.canonical_text);
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
  } catch (const std::system_error&) {  // a file that is not there
  }
}

/// A record is refused with its problems, or it is one. The first byte chooses whether it has times of its own.
inline void try_record(std::string_view text) {
  if (text.empty()) return;
  report::RecordReading how{.name = "record.txt", .time_step = {}, .gravity = 9.81};
  if (text.front() % 2 == 0) how.time_step = 0.01;
  report::Problems problems;
  const auto motion = report::read_record(text.substr(1), how, problems);
  demand(motion.has_value() == problems.empty(), "a record is read, or told why not");
  if (!motion) return;
  demand(motion->samples.size() >= 2, "a record has samples");
  double before = 0.0;
  for (const auto& sample : motion->samples) {
    demand(sample.time >= before, "times do not fall");
    demand(std::isfinite(sample.horizontal) && std::isfinite(sample.vertical), "accelerations are finite");
    demand(motion->has_vertical || sample.vertical == 0.0, "what is not recorded is 0");
    before = sample.time;
  }
}

/// A motion that is stopped after some steps, whatever it is about to do.
template <class Motion>
struct Limited {
  Motion& motion;
  int steps_left;

  [[nodiscard]] bool ended() const { return steps_left <= 0 || motion.ended(); }
  [[nodiscard]] double time_resolution() const { return motion.time_resolution(); }
  [[nodiscard]] double time_to_breakpoint() const { return motion.time_to_breakpoint(); }
  [[nodiscard]] double time_to_strobe() const { return motion.time_to_strobe(); }
  [[nodiscard]] double expand(double reach) {
    --steps_left;
    return motion.expand(reach);
  }
  template <class Visitor>
  void for_each_guard(const integrate::FiredGuards& wanted, Visitor&& visit) const {
    motion.for_each_guard(wanted, visit);
  }
  void strobe(double x) { motion.strobe(x); }
  void move(double x) { motion.move(x); }
  void reset(const integrate::FiredGuards& fired, bool at_breakpoint) { motion.reset(fired, at_breakpoint); }
};

/// Watches that a state is one.
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

/// Whatever the reader lets through can be run: two periods of its first condition, at most 2000 steps.
inline void try_scene(std::string_view text) {
  try {
    const experiment::Experiment read = read_small_experiment(text);
    const experiment::Condition& condition = read.conditions.front();
    const random::Draws draws(read.seed, 0);
    const experiment::Start start = experiment::start_of(condition.scene, draws);
    Watch watch;
    const auto beginning = experiment::begin_realisation(condition, draws, start, experiment::Strobe::start, 2);
    experiment::Motion motion = experiment::motion_of(condition.scene, beginning, watch);
    Limited<experiment::Motion> limited{motion, 2000};
    static_cast<void>(integrate::advance(limited));
    watch.strobe(motion.state());
  } catch (const base::InputError&) {
  } catch (const std::system_error&) {
  }
}

}  // namespace rocking::fuzz

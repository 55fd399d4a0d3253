// The hybrid loop, with invented systems whose events are known exactly.

#include "rocking/integrate/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocking::integrate {
namespace {

using ::testing::ElementsAre;

/// Guards that fire at given instants, breakpoints and strobes at others. All are dyadic, so that times are exact.
/// Writes down the calls of the loop.
struct Timetable {
  std::vector<double> instants{};     ///< of guard 0, 1, ...; each fires once
  std::vector<double> breakpoints{};  ///< in order
  double strobe_period = 1e9;
  double step = 0.75;
  double last = 10.0;  ///< the system ends at the first reset or strobe at or after it
  double resolution = 0x1p-40;

  double now = 0.0;
  double next_strobe = strobe_period;
  bool over = false;
  std::vector<std::string> log{};
  std::vector<double> step_ends{};

  [[nodiscard]] bool ended() const { return over; }
  [[nodiscard]] double time_resolution() const { return resolution; }
  [[nodiscard]] double time_to_breakpoint() const {
    return breakpoints.empty() ? std::numeric_limits<double>::infinity() : breakpoints.front() - now;
  }
  [[nodiscard]] double time_to_strobe() const { return next_strobe - now; }
  double expand(double reach) { return std::min(reach, step); }

  template <class Visitor>
  void for_each_guard(const FiredGuards& wanted, Visitor&& visit) const {
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const double line[2] = {instants[i] - now, -1.0};
      if (wanted[i] && std::isfinite(instants[i])) visit(i, std::span<const double>(line));
    }
  }

  void strobe(double x) {
    note("strobe", now + x);
    next_strobe += strobe_period;
  }
  void move(double x) {
    now += x;
    step_ends.push_back(now);
  }
  void reset(const FiredGuards& fired, bool at_breakpoint) {
    std::string what;
    for (std::size_t i = 0; i < instants.size(); ++i) {
      if (!fired[i]) continue;
      what += "guard" + std::to_string(i) + "+";
      instants[i] = std::numeric_limits<double>::infinity();
    }
    if (at_breakpoint) {
      what += "breakpoint+";
      breakpoints.erase(breakpoints.begin());
    }
    if (!what.empty()) note(what.substr(0, what.size() - 1), now);
  }

 private:
  void note(const std::string& what, double time) {
    log.push_back(what + "@" + testing::PrintToString(time));
    over = over || time >= last;
  }
};

static_assert(HybridSystem<Timetable>);

TEST(Advance, MeetsEventsInTheirOrderWhateverTheirNumbers) {
  Timetable system{.instants = {2.5, 0.25, 1.0, 0.5}, .breakpoints = {1.25, 10.0}};
  advance(system);
  EXPECT_THAT(system.log,
              ElementsAre("guard1@0.25", "guard3@0.5", "guard2@1", "breakpoint@1.25", "guard0@2.5", "breakpoint@10"));
}

TEST(Advance, ReportsSimultaneousGuardsTogether) {
  Timetable system{.instants = {0.5, 0.5 + 0x1p-41, 0.5 + 0x1p-39}, .breakpoints = {10.0}};
  advance(system);
  EXPECT_EQ(system.log.at(0), "guard0+guard1@0.5") << "within the resolution of the earliest";
  EXPECT_EQ(system.log.at(1).substr(0, 6), "guard2") << "beyond it";
}

TEST(Advance, CountsResolutionFromTheEarliestNotFromTheFirstNumber) {
  Timetable system{.instants = {0.5 + 0x1p-41, 0.5 + 0x1.8p-40, 0.5}, .breakpoints = {10.0}};
  advance(system);
  EXPECT_EQ(system.log.at(0), "guard0+guard2@0.5");
}

TEST(Advance, ReportsAGuardAndABreakpointOfOneInstantTogether) {
  Timetable system{.instants = {0.5}, .breakpoints = {0.5 + 0x1p-42, 10.0}};
  advance(system);
  EXPECT_EQ(system.log.at(0), "guard0+breakpoint@0.5");
}

TEST(Advance, ShowsTheStrobeTheStateAfterTheEventsOfItsInstant) {
  Timetable system{.instants = {2.0}, .breakpoints = {4.0, 10.0}, .strobe_period = 2.0};
  advance(system);
  EXPECT_THAT(system.log,
              ElementsAre("guard0@2", "strobe@2", "breakpoint@4", "strobe@4", "strobe@6", "strobe@8", "breakpoint@10"));
}

TEST(Advance, ShowsTheStrobeTheStateAfterAnEventThatIsAlmostAtItsInstant) {
  for (const double offset : {-0x1p-41, 0x1p-41}) {
    Timetable system{.instants = {2.0 + offset}, .breakpoints = {10.0}, .strobe_period = 2.0};
    advance(system);
    EXPECT_EQ(system.log.at(0).substr(0, 6), "guard0") << offset;
    EXPECT_EQ(system.log.at(1).substr(0, 6), "strobe") << offset;
  }
}

TEST(Advance, SamplesEveryStrobeOfALongStep) {
  Timetable system{.instants = {}, .breakpoints = {4.0}, .strobe_period = 0.75, .step = 100.0, .last = 4.0};
  const LoopCounts counts = advance(system);
  EXPECT_THAT(system.log,
              ElementsAre("strobe@0.75", "strobe@1.5", "strobe@2.25", "strobe@3", "strobe@3.75", "breakpoint@4"));
  EXPECT_EQ(counts.steps, 1U);
}

TEST(Advance, EndsStepsExactlyAtBreakpoints) {
  Timetable system{.instants = {0.3}, .breakpoints = {0.625, 1.0, 1.125, 3.0}, .last = 3.0};
  advance(system);
  for (const double breakpoint : {0.625, 1.0, 1.125, 3.0}) {
    EXPECT_THAT(system.step_ends, testing::Contains(breakpoint));
  }
}

TEST(Advance, DoesNothingMoreOnceTheSystemHasEnded) {
  Timetable ended_before{.instants = {1.0}, .breakpoints = {2.0}, .over = true};
  EXPECT_EQ(advance(ended_before).steps, 0U);
  EXPECT_TRUE(ended_before.log.empty());

  Timetable ended_by_strobe{.instants = {1.0}, .breakpoints = {}, .strobe_period = 0.25, .step = 8.0, .last = 0.5};
  advance(ended_by_strobe);
  EXPECT_THAT(ended_by_strobe.log, ElementsAre("strobe@0.25", "strobe@0.5"));
  EXPECT_TRUE(ended_by_strobe.step_ends.empty()) << "nothing of the step is carried out after the end";
}

TEST(Advance, CountsStepsAndTheGuardsThatTheCheapBoundDidNotClear) {
  Timetable system{.instants = {9.5}, .breakpoints = {10.0}, .step = 1.0};
  const LoopCounts counts = advance(system);
  // Nine steps of 1, one of 0.5 to the guard, one to the end. The bound fails to exclude the guard only in the step in
  // which it fires.
  EXPECT_EQ(counts.steps, 11U);
  EXPECT_EQ(counts.root_isolations, 1U);
}

/// A ball under g = 1 that keeps half of its speed: bounce k is at 2 (1 + 1/2 + ... ) = 4 (1 - 2^-k).
struct Ball {
  double height = 0.0;
  double speed = 1.0;
  double now = 0.0;
  std::vector<double> bounces{};
  std::vector<double> strobes{};  ///< heights at 0.5, 1, 1.5, ...

  [[nodiscard]] bool ended() const { return bounces.size() == 20; }
  [[nodiscard]] double time_resolution() const { return 0x1p-50; }
  [[nodiscard]] double time_to_breakpoint() const { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] double time_to_strobe() const { return 0.5 * static_cast<double>(strobes.size() + 1) - now; }
  [[nodiscard]] static double expand(double) { return 0.75; }
  template <class Visitor>
  void for_each_guard(const FiredGuards& wanted, Visitor&& visit) const {
    const double c[3] = {height, speed, -0.5};
    if (!wanted[3]) return;
    visit(3, height == 0.0 ? std::span<const double>(c + 1, 2) : std::span<const double>(c));
  }
  [[nodiscard]] double height_at(double x) const { return height + x * (speed - 0.5 * x); }
  void strobe(double x) { strobes.push_back(height_at(x)); }
  void move(double x) {
    height = height_at(x);
    speed -= x;
    now += x;
  }
  void reset(const FiredGuards& fired, bool) {
    if (!fired[3]) return;
    height = 0.0;
    speed = -0.5 * speed;
    bounces.push_back(now);
  }
};

TEST(Advance, BouncesABallAtTheInstantsOfTheClosedForm) {
  Ball ball;
  advance(ball);
  for (std::size_t k = 0; k < ball.bounces.size(); ++k) {
    // The error of an instant is the rounding of the height, about 2^-53, over the speed at landing.
    const double speed = std::ldexp(1.0, -static_cast<int>(k));
    EXPECT_NEAR(ball.bounces[k], 4.0 * (1.0 - 0.5 * speed), 16.0 * 0x1p-52 / speed) << "bounce " << k;
  }
}

TEST(Advance, SamplesABallBetweenItsBounces) {
  Ball ball;
  advance(ball);
  ASSERT_EQ(ball.strobes.size(), 7U);          // up to 3.5; the ball is at rest from 4 on
  EXPECT_NEAR(ball.strobes[0], 0.375, 1e-15);  // t - t^2/2
  EXPECT_NEAR(ball.strobes[1], 0.5, 1e-15);
  EXPECT_NEAR(ball.strobes[3], 0.0, 1e-15) << "at the first bounce";
  EXPECT_NEAR(ball.strobes[4], 0.125, 1e-15) << "top of the second hop";
  EXPECT_NEAR(ball.strobes[6], 0.0, 1e-15) << "at the third bounce";
}

}  // namespace
}  // namespace rocking::integrate

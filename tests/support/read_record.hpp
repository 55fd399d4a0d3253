#pragma once

#include <string>

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking::support {

/// The record of a text that must be one.
inline GroundMotion record_of(const std::string& text, const GroundMotionReading& how) {
  Problems problems;
  auto motion = read_ground_motion(text, how, problems);
  if (!motion) ADD_FAILURE() << base::InputError(problems).what();
  return motion.value_or(GroundMotion{});
}

/// The only problem of a text that must be refused.
inline base::Problem problem_of_record(const std::string& text, const GroundMotionReading& how) {
  Problems problems;
  EXPECT_FALSE(read_ground_motion(text, how, problems));
  if (problems.size() == 1) return problems.front();
  ADD_FAILURE() << problems.size() << " problems";
  return {};
}

}  // namespace rocking::support

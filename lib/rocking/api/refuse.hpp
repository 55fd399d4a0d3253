#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/api/trajectory.hpp"
#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking {

/// Refuses an argument of a call, which is not at a place of a file.
[[noreturn]] inline void refuse(std::string_view name, const std::string& value, std::string reason) {
  throw base::InputError({std::string(name), value, std::move(reason), ""});
}

/// Refuses an argument that is not a whole number from `least` to `largest`.
template <class Number>
void expect(std::string_view name, Number value, Number least, Number largest) {
  if (least <= value && value <= largest) return;
  refuse(name, std::to_string(value),
         "must be a whole number from " + std::to_string(least) + " to " + std::to_string(largest));
}

/// The result of `act`, whose errors of a folder that does not fit are errors of the input for callers of the library.
template <class Act>
auto with_input_errors(const Act& act) {
  try {
    return act();
  } catch (const base::FolderError& error) {
    using Kind = base::FolderError::Kind;
    if (error.kind() == Kind::missing || error.kind() == Kind::at_work) throw;
    throw base::InputError(error.problem());
  }
}

/// Throws base::InputError if the shard is no part of a whole, or if the experiment cannot be divided.
void check_shard(const Experiment& experiment, const Shard& shard);

/// Throws base::InputError if the experiment has no such condition, or a number is out of range.
void check_request(const Experiment& experiment, const TrajectoryRequest& request);

/// Excitation periods of a checked request.
[[nodiscard]] std::int64_t periods_of(const Experiment& experiment, const TrajectoryRequest& request);

}  // namespace rocking

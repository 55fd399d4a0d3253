#pragma once

#include "rocking/studies/rare/block_paths.hpp"
#include "rocking/studies/rare/committor.hpp"
#include "rocking/studies/rare/estimator.hpp"

/// How the event happens when it does (lib/docs/rare.md).
namespace rocking::rare {

/// A few trajectories with the event: of two repetitions, which are drawn in proportion to their estimates and made
/// again, by their weights (systematic sampling). Throws as Halt::check, and base::InputError if a repetition has not the
/// event when it is made again.
[[nodiscard]] std::vector<Path> typical_paths(const BlockPaths& paths, const Estimator& estimator,
                                              const std::vector<Repetition>& repetitions);

/// A path of these draws, from the start to the event; if it does not happen, to the horizon.
[[nodiscard]] Path path_of(const BlockPaths& paths, std::uint64_t number, const random::DrawHistory& draws);

/// The committor at strobe point 1, where it is not nearly 1.
[[nodiscard]] CommittorMap map_of(const Committor& committor);

}  // namespace rocking::rare

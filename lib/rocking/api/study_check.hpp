#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rocking/input/read_experiment.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// What an experiment of a folder draws on. Ground motions may be beside the experiment, and that beside the folder:
/// they are looked for in the folder, in the one around it, and in the current one. An experiment has the digests of
/// their contents.
[[nodiscard]] Surroundings seen_near(const std::filesystem::path& folder);

/// The experiment of a study's file; absent if it does not have the digest that the file states, or has no text because
/// it was made in C++.
[[nodiscard]] std::optional<Experiment> stated_experiment(const InputFacts& input, const Surroundings& surroundings);

}  // namespace rocking

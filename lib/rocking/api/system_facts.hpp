#pragma once

#include <filesystem>
#include <optional>

#include "rocking/api/question_check.hpp"
#include "rocking/api/run.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// What a file says of the system. Throws base::InputError for a duration that is none.
[[nodiscard]] inline SystemFacts facts_of(const Provenance& provenance) {
  check_fields(provenance);
  return {.build = base::build_info(),
          .machine = provenance.machine,
          .start = provenance.start,
          .duration_s = provenance.duration_s,
          .threads = provenance.threads};
}

/// The experiment for a writer of JSON, which puts its text into the document: `null` where it was made in C++.
[[nodiscard]] inline Experiment with_text(Experiment experiment) {
  if (experiment.canonical_text.empty()) experiment.canonical_text = "null";
  return experiment;
}

/// What an experiment of a folder draws on. Ground motions may be beside the experiment, and that beside the folder:
/// they are looked for in the folder, in the one around it, and in the current one. An experiment has the digests of
/// their contents.
[[nodiscard]] Surroundings seen_near(const std::filesystem::path& folder);

/// The experiment of a study's file; absent if it does not have the digest that the file states, or has no text because
/// it was made in C++.
[[nodiscard]] std::optional<Experiment> stated_experiment(const InputFacts& input, const Surroundings& surroundings);

}  // namespace rocking

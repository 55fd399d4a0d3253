#pragma once

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The experiment for a writer of JSON, which puts its text into the document: `null` where it was made in C++.
[[nodiscard]] inline Experiment with_text(Experiment experiment) {
  if (experiment.canonical_text.empty()) experiment.canonical_text = "null";
  return experiment;
}

}  // namespace rocking

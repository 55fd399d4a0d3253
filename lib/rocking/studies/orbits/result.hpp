#pragma once

#include <optional>
#include <string>

#include "rocking/fields/document.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/question.hpp"

namespace rocking {

/// The periodic orbits of an experiment.
struct OrbitsReport {
  InputFacts input;
  OrbitStudy study;
};

/// The number that a condition has at this JSON pointer of the sweep; absent if there is none.
[[nodiscard]] std::optional<double> swept_number(const OrbitsOfCondition& condition, const std::string& pointer);

[[nodiscard]] OrbitsReport orbits_report(const Experiment& experiment, OrbitStudy study);

[[nodiscard]] const StructType& fields_of(const OrbitsReport*);

/// `orbits.json`, and the output of `rocking orbits --json`. Equal input gives equal bytes.
[[nodiscard]] const DocumentOf<OrbitsReport>& orbits_document();

}  // namespace rocking

#pragma once

#include "rocking/api/checks.hpp"
#include "rocking/api/infer.hpp"
#include "rocking/api/run.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/fields/struct_type.hpp"

/// What callers in C++ ask: a list of fields a question, with the rule of each (QuestionCheck).
namespace rocking {

[[nodiscard]] const StructType& fields_of(const CostRequest*);
[[nodiscard]] const StructType& fields_of(const Execution*);
[[nodiscard]] const StructType& fields_of(const FragilityQuestion*);
[[nodiscard]] const StructType& fields_of(const GroundMotionRequest*);
[[nodiscard]] const StructType& fields_of(const InferRequest*);
[[nodiscard]] const StructType& fields_of(const OrbitsRequest*);
[[nodiscard]] const StructType& fields_of(const Provenance*);
[[nodiscard]] const StructType& fields_of(const RareRequest*);
[[nodiscard]] const StructType& fields_of(const SamplerQuestion*);
[[nodiscard]] const StructType& fields_of(const TrajectoryRequest*);

}  // namespace rocking

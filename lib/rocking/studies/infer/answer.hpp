#pragma once

#include <cstdint>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/infer/survey.hpp"

namespace rocking::infer {

/// The answer from the models of all conditions, candidates last. A made-up data set is a part of `how`. Throws
/// base::Stopped if it is asked to stop.
[[nodiscard]] InferenceAnswer answer_of(const InferenceQuestion& question, const std::vector<ShareModel>& models,
                                        const Survey& found, const base::ManyParts& how);

/// Data sets that answer_of makes up.
[[nodiscard]] std::uint64_t sets_of_answer(const InferenceQuestion& question);

}  // namespace rocking::infer

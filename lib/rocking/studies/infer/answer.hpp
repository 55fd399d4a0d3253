#pragma once

#include <cstdint>
#include <vector>

#include "rocking/studies/infer/survey.hpp"

namespace rocking::infer {

/// The answer from the models of all conditions, candidates last. Runs on `threads`.
[[nodiscard]] InferenceAnswer answer_of(const InferenceQuestion& question, const std::vector<ShareModel>& models,
                                        const Survey& found, unsigned threads);

}  // namespace rocking::infer

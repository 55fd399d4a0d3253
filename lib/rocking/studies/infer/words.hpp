#pragma once

#include <string>

#include "rocking/studies/infer/result.hpp"

/// Words that the table and the figures of an inference share. All need an answer.
namespace rocking {

/// `deviance 5.7, p = 0.58: the estimate explains the counts`.
[[nodiscard]] std::string fit_in_words(const InferReport& report);

/// Whether the tests can tell the unknowns: `no, these tests cannot tell: ...`.
[[nodiscard]] std::string identified_in_words(const InferReport& report);

}  // namespace rocking

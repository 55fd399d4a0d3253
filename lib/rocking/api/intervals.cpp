#include "rocking/api/checks.hpp"

#include <cstdint>
#include <string>

#include "rocking/api/refuse.hpp"
#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

stats::Proportion checked(std::uint64_t successes, std::uint64_t trials, double confidence) {
  // Boost.Math finds the ends up to here.
  constexpr double least_confidence = 1e-6;
  constexpr std::uint64_t most_trials = 1'000'000'000;
  if (!(confidence >= least_confidence && confidence < 1.0)) {
    refuse("confidence", base::shortest(confidence), "must be at least 1e-6 and below 1");
  }
  if (trials > most_trials) refuse("trials", std::to_string(trials), "must be at most 1000000000");
  if (successes > trials) {
    refuse("successes", std::to_string(successes), "are more than the trials, " + std::to_string(trials));
  }
  return {.successes = successes, .trials = trials};
}

}  // namespace

stats::Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  return stats::clopper_pearson(checked(successes, trials, confidence), confidence);
}

stats::Interval wilson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  return stats::wilson(checked(successes, trials, confidence), confidence);
}

}  // namespace rocking

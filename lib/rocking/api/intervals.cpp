#include "rocking/api/checks.hpp"

#include <string>

#include "rocking/api/refuse.hpp"
#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

stats::Proportion checked(std::uint64_t successes, std::uint64_t trials, double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    refuse("confidence", base::shortest(confidence), "must be between 0 and 1");
  }
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

#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/studies/check_normal/check_sampler.hpp"
#include "rocking/studies/check_normal/result.hpp"
#include "rocking/studies/check_normal/study.hpp"

namespace rocking {

stats::NormalCheck check_normal(const SamplerQuestion& question) {
  check_fields(question);
  if (question.distribution == FluctuationLaw::lognormal &&
      !(question.law.mean >= 1e-12 && question.law.sigma <= 100.0 * question.law.mean)) {
    refuse("mean", base::shortest(question.law.mean),
           "must be at least 1e-12 for a lognormal law, and at least a hundredth of sigma");
  }
  auto found = check_sampler(question);
  if (!found) {
    refuse("sigma", base::shortest(question.law.sigma),
           "is too small compared with the mean to give two different numbers");
  }
  return std::move(*found);
}

std::string check_normal_text(const SamplerQuestion& question, const stats::NormalCheck& found) {
  return check_normal_document().text(sampler_check(question, found));
}

}  // namespace rocking

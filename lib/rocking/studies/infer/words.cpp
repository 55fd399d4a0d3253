#include "rocking/studies/infer/words.hpp"

#include "rocking/text/number_text.hpp"

namespace rocking {

std::string fit_in_words(const InferReport& report) {
  const double p = report.fit->p_value;
  const std::string fit = "deviance " + significant(report.fit->statistic, 3) + ", p = " + significant(p, 2);
  if (p > 1.0 - report.confidence) return fit + ": the estimate explains the counts";
  return fit + ": no value of the unknowns explains the counts; the intervals mean nothing";
}

std::string identified_in_words(const InferReport& report) {
  const std::string& reason = report.identified.reason_why_not;
  if (!reason.empty()) return "no, " + reason;
  return report.unknowns.size() == 1 ? "yes, the interval ends within the range of the unknown"
                                     : "yes, all intervals end within the ranges of the unknowns";
}

}  // namespace rocking

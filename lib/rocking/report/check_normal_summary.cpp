#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "rocking/report/read_quantity.hpp"
#include "rocking/report/text_table.hpp"
#include "rocking/report/write_check_normal.hpp"

namespace rocking::report {
namespace {

TextRow moment_row(const std::string& name, const stats::Moment& moment) {
  return {name, significant(moment.value, 8), significant(moment.standard_error, 3), fixed_point(moment.z, 2)};
}

TextRow test_row(const std::string& name, const stats::TestOfFit& test) {
  return {name, significant(test.statistic, 4), significant(test.p_value, 3)};
}

std::string tail_line(const stats::TailCount& tail) {
  return "beyond " + significant(tail.sigmas, 1) + " sigma: " + std::to_string(tail.beyond.successes) + ", expected " +
         significant(tail.expected, 3) + " (p = " + significant(tail.p_value, 3) + ")\n";
}

// What a small moment is worth: how often an ideal sampler does as well.
std::string frequency_line(const std::string& name, double within, const stats::Moment& moment) {
  const double probability = std::erf(within / moment.standard_error / std::sqrt(2.0));
  return name + " within " + significant(within, 3) + ": expected in " + fixed_point(100.0 * probability, 0) +
         " % of samples of this size\n";
}

std::string bars(const stats::Histogram& histogram) {
  constexpr double longest = 50.0;
  const auto tallest = static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  std::vector<TextRow> rows{{"from", "count", "expected"}};
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    rows.push_back({significant(histogram.edges[k], 4), std::to_string(histogram.counts[k]),
                    fixed_point(histogram.expected[k], 1)});
  }
  const std::string table = aligned(rows);
  std::string text;
  std::size_t start = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t end = table.find('\n', start);
    text += table.substr(start, end - start);
    if (row > 0 && tallest > 0.0) {
      const double length = longest * static_cast<double>(histogram.counts[row - 1]) / tallest;
      if (length >= 0.5) text += "  " + std::string(static_cast<std::size_t>(std::lround(length)), '#');
    }
    text += '\n';
    start = end + 1;
  }
  return text;
}

}  // namespace

std::string check_normal_summary(const NormalCheck& check) {
  std::string text = std::to_string(check.moments.n) + " numbers from N(" + significant(check.law.mean, 6) + ", " +
                     significant(check.law.sigma, 6) + "^2), sampler " + check.sampler + ", seed " +
                     seed_text(check.seed) + "\n\n";
  text += aligned({{"moment", "value", "standard error", "z"},
                   moment_row("mean", check.moments.mean),
                   moment_row("standard deviation", check.moments.standard_deviation),
                   moment_row("skewness (0)", check.moments.skewness),
                   moment_row("kurtosis (3)", check.moments.kurtosis),
                   moment_row("correlation in pairs", check.pair_correlation),
                   moment_row("correlation of neighbours", check.lag_correlation)});
  text += '\n' + frequency_line("skewness", 0.01, check.moments.skewness);
  text += frequency_line("kurtosis - 3", 0.01, check.moments.kurtosis) + '\n';
  text += aligned({{"test of fit", "statistic", "p-value"},
                   test_row("Jarque-Bera", check.jarque_bera),
                   test_row("D'Agostino-Pearson", check.dagostino_pearson),
                   test_row("Anderson-Darling", check.anderson_darling),
                   test_row("Kolmogorov-Smirnov", check.kolmogorov_smirnov)});
  text += '\n';
  for (const stats::TailCount& tail : check.tails) text += tail_line(tail);
  return text + '\n' + bars(check.histogram);
}

}  // namespace rocking::report

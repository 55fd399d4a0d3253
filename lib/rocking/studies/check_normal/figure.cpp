#include "rocking/studies/check_normal/figure.hpp"

#include <cmath>

#include "rocking/look/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

Table count_table(const stats::Histogram& histogram) {
  Table table{.name = "counts",
              .columns = {{"from", "left edge of the bin"},
                          {"to", "its right edge"},
                          {"zero", "bottom of the bar"},
                          {"count", "numbers in the bin"},
                          {"expected", "expected number"}},
              .rows = {}};
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    table.rows.push_back({histogram.edges[i], histogram.edges[i + 1], 0.0, static_cast<double>(histogram.counts[i]),
                          histogram.expected[i]});
  }
  return table;
}

/// The density of the distribution times n times the width of a bin.
Table curve_table(const stats::NormalCheck& check) {
  Table table{.name = "normal curve",
              .columns = {{"x", "value"}, {"expected", "expected numbers in a bin around it"}},
              .rows = {}};
  const double low = check.histogram.edges.front();
  const double high = check.histogram.edges.back();
  const double width = (high - low) / static_cast<double>(check.histogram.counts.size());
  const double top = static_cast<double>(check.n) * width / (check.law.sigma * std::sqrt(2.0 * 3.14159265358979323846));
  if (check.skewness.of_law) {  // of a law that is not normal: what is expected in each bin
    for (std::size_t i = 0; i < check.histogram.counts.size(); ++i) {
      table.rows.push_back(
          {0.5 * (check.histogram.edges[i] + check.histogram.edges[i + 1]), check.histogram.expected[i]});
    }
    return table;
  }
  constexpr int parts = 240;
  for (int i = 0; i <= parts; ++i) {
    const double x = low + (high - low) * i / parts;
    const double z = check.law.score(x);
    table.rows.push_back({x, top * std::exp(-0.5 * z * z)});
  }
  return table;
}

std::string value_text(const stats::MomentTest& test) { return significant(test.moment.value, 5); }

}  // namespace

Figure normal_histogram(const SamplerCheck& check) {
  const stats::NormalCheck& found = check.found;
  Figure figure;
  figure.name = "normal_histogram";
  const std::string law = check.distribution.value_or("normal");
  figure.title = std::to_string(found.n) + " random numbers from " + (check.distribution ? law + " " : "N") + "(" +
                 number_text(found.law.mean) + ", " + number_text(found.law.sigma) + "²)";
  figure.subtitle = "sampler " + check.sampler + ", seed " + seed_text(check.seed);
  figure.tables = {count_table(found.histogram), curve_table(found)};
  figure.panels.push_back({.title = "",
                           .x = {.quantity = "value", .symbol = "", .unit = ""},
                           .y = {.quantity = "numbers in a bin", .symbol = "", .unit = "", .low = 0.0},
                           .layers = {}});
  figure.panels.back().layers = {{.kind = LayerKind::boxes,
                                  .table = 0,
                                  .columns = {0, 1, 2, 3},
                                  .style = {.colour = "#9fc5e8"},
                                  .legend = "random numbers"},
                                 {.kind = LayerKind::line,
                                  .table = 1,
                                  .columns = {0, 1},
                                  .style = {.colour = "#d55e00", .marker = 0, .width = 2.0},
                                  .legend = law + " distribution"}};
  figure.caption = "Mean " + value_text(found.mean) + ", standard deviation " + value_text(found.standard_deviation) +
                   ", skewness " + value_text(found.skewness.test) + ", kurtosis " + value_text(found.kurtosis.test) +
                   " (" + significant(found.kurtosis.of_law.value_or(3.0), 5) + " for a " + law + " distribution).";
  return figure;
}

}  // namespace rocking::analysis

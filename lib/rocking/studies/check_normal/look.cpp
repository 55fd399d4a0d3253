#include "rocking/studies/check_normal/study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;

// A p-value in words. Among nineteen p-values one below 0.01 is not remarkable: every sixth normal sample has one.
std::string judgement(double p_value) {
  if (p_value >= 0.01) return "not remarkable";
  if (p_value < 1e-6) return "not this distribution";
  return "1 sample in " + significant(1.0 / p_value, 2);
}

look::Row moment_row(const std::string& name, const stats::MomentTest& test) {
  return {name,
          number(test.moment.value, 8),
          number(test.moment.standard_error, 3),
          number(test.moment.z, look::decimals(2)),
          number(test.p_value, 3),
          judgement(test.p_value)};
}

look::Row test_row(const std::string& name, const stats::TestOfFit& test) {
  return {name, number(test.statistic, 4), number(test.p_value, 3), judgement(test.p_value)};
}

look::Row tail_row(const stats::TailCount& tail) {
  return {"beyond " + significant(tail.sigmas, 1) + " sigma", look::whole(tail.beyond.successes),
          number(tail.expected, 4), number(tail.p_value, 3), judgement(tail.p_value)};
}

std::string table_of(const std::vector<std::string>& titles, std::vector<look::Row> rows) {
  look::Table table;
  add_columns(table, titles);
  table.rows = std::move(rows);
  return to_terminal(table);
}

// How often a perfect sampler has a moment as near to that of the law.
std::string nearness_line(const std::string& name, const stats::ShapeTest& shape) {
  const auto per_cent = [](const stats::Nearness& near) { return fixed_point(100.0 * near.probability, 0) + " %"; };
  return name + " within " + significant(shape.nearness[0].distance, 3) + ": expected in " +
         per_cent(shape.nearness[0]) + (shape.of_law ? " of" : " of normal") + " samples of this size; within " +
         significant(shape.nearness[1].distance, 3) + ", as found here: in " + per_cent(shape.nearness[1]) + '\n';
}

/// With the value of the distribution.
std::string shape_name(const std::string& name, const stats::ShapeTest& shape, double normal) {
  return name + " (" + significant(shape.of_law.value_or(normal), 5) + ')';
}

std::string moments_table(const stats::NormalCheck& check) {
  const std::string table =
      table_of({"moment", "value", "standard error", "z", "p-value", "result"},
               {moment_row("mean", check.mean), moment_row("standard deviation", check.standard_deviation),
                moment_row(shape_name("skewness", check.skewness, 0.0), check.skewness.test),
                moment_row(shape_name("kurtosis", check.kurtosis, 3.0), check.kurtosis.test)});
  const auto distance = [](const std::string& name, const stats::ShapeTest& shape, double normal) {
    const double value = shape.of_law.value_or(normal);
    return value == 0.0 ? name : name + " - " + significant(value, 5);
  };
  return table + '\n' + nearness_line(distance("skewness", check.skewness, 0.0), check.skewness) +
         nearness_line(distance("kurtosis", check.kurtosis, 3.0), check.kurtosis);
}

std::string correlations_table(const stats::NormalCheck& check) {
  std::vector<look::Row> rows;
  for (const stats::CorrelationTest& correlation : check.correlations) {
    std::string name = correlation.between;
    std::replace(name.begin(), name.end(), '_', ' ');
    rows.push_back(moment_row(name, correlation.test));
  }
  return table_of({"correlation", "value", "standard error", "z", "p-value", "result"}, std::move(rows));
}

// Among many p-values a small one is to be expected; the line says how often.
std::string smallest_line(const stats::NormalCheck& check) {
  const stats::SmallestPValue smallest = stats::smallest_p_value(check);
  return "smallest of " + std::to_string(smallest.tests) + " p-values: " + significant(smallest.value, 3) + "; about " +
         significant(100.0 * smallest.probability, 2) + " % of normal samples have one as small\n";
}

std::string bars(const stats::Histogram& histogram) {
  constexpr double longest = 50.0;
  const auto tallest = static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  std::vector<look::Row> rows;
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    rows.push_back({number(histogram.edges[k], 4), look::whole(histogram.counts[k]),
                    number(histogram.expected[k], look::decimals(1))});
  }
  const std::string table = table_of({"from", "count", "expected"}, std::move(rows));
  std::string text;
  std::size_t start = 0;
  for (std::size_t row = 0; row <= histogram.counts.size(); ++row) {
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

/// `, sampler box-muller, seed 0x2012`.
static std::string origin_of(const SamplerCheck& check) {
  if (check.generated) return ", sampler " + check.generated->sampler + ", seed " + seed_text(check.generated->seed);
  return std::string(check.of_file->has_own_law ? ", their own mean and standard deviation" : "") + ", in " +
         check.of_file->file;
}

std::string check_normal_summary(const SamplerCheck& check) {
  const stats::NormalCheck& found = check.found;
  const std::string mean = significant(found.law.mean, 6);
  const std::string sigma = significant(found.law.sigma, 6);
  std::string text =
      std::to_string(found.n) + (check.of_file ? " numbers against " : " numbers from ") +
      (check.distribution ? *check.distribution + " with mean " + mean + " and standard deviation " + sigma
                          : "N(" + mean + ", " + sigma + "^2)") +
      origin_of(check) + (stats::is_refuted(found) ? ": refuted, a p-value is below 1e-6" : ": not refuted") + "\n\n";
  text += moments_table(found) + '\n';
  if (check.of_file && check.of_file->has_own_law) {
    text +=
        "mean and standard deviation are those of the distribution, so that their rows test nothing; the p-values of "
        "the tests of fit take it into account\n\n";
  }
  if (check.distribution) {
    text +=
        "moments: for large samples; what follows is of the normal scores of the numbers under the distribution\n\n";
  }
  text += correlations_table(found) + '\n';
  text += table_of(
      {"test of fit", "statistic", "p-value", "result"},
      {test_row("D'Agostino-Pearson", found.dagostino_pearson), test_row("Anderson-Darling", found.anderson_darling),
       test_row("Kolmogorov-Smirnov", found.kolmogorov_smirnov)});
  text += '\n' + table_of({"tails", "count", "expected", "p-value", "result"},
                          {tail_row(found.tails[0]), tail_row(found.tails[1]), tail_row(found.tails[2])});
  return text + '\n' + smallest_line(found) + '\n' + bars(found.histogram);
}

}  // namespace rocking

namespace rocking::analysis {
namespace {

Table count_table(const stats::Histogram& histogram) {
  Table table{.name = "counts",
              .columns = {{"from", "left edge of the bin"},
                          {"to", "its right edge"},
                          {"zero", "bottom of the bar"},
                          {"count", "numbers in the bin"},
                          {"expected", "expected number"}}};
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    table.rows.push_back({histogram.edges[i], histogram.edges[i + 1], 0.0, histogram.counts[i], histogram.expected[i]});
  }
  return table;
}

/// The density of the distribution times n times the width of a bin.
Table curve_table(const stats::NormalCheck& check) {
  Table table{.name = "normal curve", .columns = {{"x", "value"}, {"expected", "expected numbers in a bin around it"}}};
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
  figure.subtitle = origin_of(check).substr(2);
  figure.tables = {count_table(found.histogram), curve_table(found)};
  figure.panels.push_back({.x = {.quantity = "value"}, .y = {.quantity = "numbers in a bin", .low = 0.0}});
  draw({.kind = LayerKind::boxes, .style = {.colour = "#9fc5e8"}, .legend = "random numbers"}, {}, figure);
  draw({.kind = LayerKind::line,
        .table = 1,
        .style = {.colour = "#d55e00", .marker = 0, .width = 2.0},
        .legend = law + " distribution"},
       {}, figure);
  figure.caption = "Mean " + value_text(found.mean) + ", standard deviation " + value_text(found.standard_deviation) +
                   ", skewness " + value_text(found.skewness.test) + ", kurtosis " + value_text(found.kurtosis.test) +
                   " (" + significant(found.kurtosis.of_law.value_or(3.0), 5) + " for a " + law + " distribution).";
  return figure;
}

}  // namespace rocking::analysis

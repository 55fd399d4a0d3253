#include "analysis/histogram_figure.hpp"

#include <cmath>

#include "analysis/data_file.hpp"
#include "analysis/output_file.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

Table count_table(const Json& histogram) {
  Table table{.name = "counts",
              .columns = {{"from", "left edge of the bin"},
                          {"to", "its right edge"},
                          {"zero", "bottom of the bar"},
                          {"count", "numbers in the bin"},
                          {"expected", "expected number"}},
              .rows = {}};
  const Json& edges = histogram.at("edges");
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    table.rows.push_back({edges.at(i).get<double>(), edges.at(i + 1).get<double>(), 0.0,
                          histogram.at("counts").at(i).get<double>(), histogram.at("expected").at(i).get<double>()});
  }
  return table;
}

/// The density of the law times n times the width of a bin.
Table curve_table(const Json& output) {
  Table table{.name = "normal curve",
              .columns = {{"x", "value"}, {"expected", "expected numbers in a bin around it"}},
              .rows = {}};
  const Json& edges = output.at("histogram").at("edges");
  const double low = edges.front();
  const double high = edges.back();
  const double mean = output.at("law").at("mean");
  const double sigma = output.at("law").at("sigma");
  const double width = (high - low) / static_cast<double>(edges.size() - 1);
  const double top = output.at("n").get<double>() * width / (sigma * std::sqrt(2.0 * 3.14159265358979323846));
  constexpr int parts = 240;
  for (int i = 0; i <= parts; ++i) {
    const double x = low + (high - low) * i / parts;
    const double z = (x - mean) / sigma;
    table.rows.push_back({x, top * std::exp(-0.5 * z * z)});
  }
  return table;
}

std::string moment(const Json& output, const char* key) {
  return significant(output.at(key).at("value").get<double>(), 5);
}

}  // namespace

Figure normal_histogram(const Json& output) {
  Figure figure;
  figure.name = "normal_histogram";
  read_or_refuse(output, [&] {
    const std::string mean = number_text(output.at("law").at("mean"));
    const std::string sigma = number_text(output.at("law").at("sigma"));
    figure.title =
        std::to_string(output.at("n").get<std::uint64_t>()) + " random numbers from N(" + mean + ", " + sigma + "²)";
    figure.subtitle =
        "sampler " + output.at("sampler").get<std::string>() + ", seed " + output.at("seed").get<std::string>();
    figure.tables = {count_table(output.at("histogram")), curve_table(output)};
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
                                    .legend = "normal distribution"}};
    figure.caption = "Mean " + moment(output, "mean") + ", standard deviation " + moment(output, "standard_deviation") +
                     ", skewness " + moment(output, "skewness") + ", kurtosis " + moment(output, "kurtosis") +
                     " (3 for a normal distribution).";
  });
  return figure;
}

}  // namespace rocking::analysis

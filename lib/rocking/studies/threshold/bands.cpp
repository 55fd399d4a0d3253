#include "rocking/studies/threshold/bands.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rocking/base/many_parts.hpp"

namespace rocking {
namespace {

/// An edge of a case.
struct CaseEdge {
  std::size_t place;
  ThresholdEdge edge;
};

/// Neighbours in a scan that differ.
std::vector<CaseEdge> changes_in(const std::vector<std::vector<ThresholdPoint>>& scans) {
  std::vector<CaseEdge> edges;
  for (std::size_t place = 0; place < scans.size(); ++place) {
    const auto& scan = scans[place];
    for (std::size_t i = 1; i < scan.size(); ++i) {
      if (scan[i - 1].happens == scan[i].happens) continue;
      const bool begins = scan[i].happens;
      edges.push_back({place, {.stands = scan[begins ? i - 1 : i], .happens = scan[begins ? i : i - 1]}});
    }
  }
  return edges;
}

bool is_within(const ThresholdEdge& edge, double accuracy) {
  const double a = edge.stands.value;
  const double b = edge.happens.value;
  return std::abs(b - a) <= accuracy * std::max(std::abs(a), std::abs(b)) || std::nextafter(a, b) == b;
}

void bisect(CaseEdge& at, double accuracy, const PointAt& point_at) {
  ThresholdEdge& edge = at.edge;
  while (!is_within(edge, accuracy)) {
    const ThresholdPoint middle = point_at(at.place, std::midpoint(edge.stands.value, edge.happens.value));
    (middle.happens ? edge.happens : edge.stands) = middle;
  }
}

bool has_answer(const ThresholdPoint& point) {
  return point.happens || point.termination == dynamics::Termination::reached_horizon;
}

}  // namespace

std::vector<std::array<double, 2>> ThresholdBands::gaps() const {
  std::vector<std::array<double, 2>> found;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].begins_band()) found.push_back({edges[i - 1].stands.value, edges[i].stands.value});
  }
  return found;
}

ThresholdBands with_bands(const std::vector<ThresholdPoint>& scan, std::vector<ThresholdEdge> edges) {
  ThresholdBands found{.bands = {}, .edges = std::move(edges), .without_answer = {}};
  double low = scan.front().value;
  for (const ThresholdEdge& edge : found.edges) {
    const double value = edge.happens.value;
    if (edge.begins_band()) {
      low = value;
    } else {
      found.bands.push_back({low, value});
    }
  }
  if (scan.back().happens) found.bands.push_back({low, scan.back().value});
  for (const ThresholdPoint& point : scan) {
    if (!has_answer(point)) found.without_answer.push_back(point.value);
  }
  return found;
}

std::vector<double> scanned_values(const ThresholdQuestion& question) {
  const double from = question.from.value();
  const double to = question.to.value();
  const std::uint64_t steps = question.steps.value();
  std::vector<double> values;
  for (std::uint64_t i = 0; i < steps; ++i) {
    values.push_back(from + (to - from) * (static_cast<double>(i) / static_cast<double>(steps)));
  }
  values.push_back(to);
  return values;
}

std::vector<ThresholdBands> bands_of(std::size_t count, const ThresholdQuestion& question, const PointAt& point_at,
                                     const RunOptions& options) {
  const std::vector<double> values = scanned_values(question);
  std::vector<std::vector<ThresholdPoint>> scans(count, std::vector<ThresholdPoint>(values.size()));
  std::uint64_t done = 0;
  std::uint64_t all = count * values.size();
  const base::ManyParts how{.threads = options.threads, .stop = options.stop_requested, .on_part = [&] {
                              if (options.on_progress) options.on_progress(++done, all);
                            }};
  base::for_each_part(how, all, [&](std::size_t i) {
    const std::size_t place = i / values.size();
    scans[place][i % values.size()] = point_at(place, values[i % values.size()]);
  });
  std::vector<CaseEdge> edges = changes_in(scans);
  all += edges.size();
  base::for_each_part(how, edges.size(), [&](std::size_t i) { bisect(edges[i], question.accuracy.value(), point_at); });
  std::vector<std::vector<ThresholdEdge>> by_case(count);
  for (const auto& [place, edge] : edges) by_case[place].push_back(edge);
  std::vector<ThresholdBands> found;
  for (std::size_t place = 0; place < count; ++place) {
    found.push_back(with_bands(scans[place], std::move(by_case[place])));
  }
  return found;
}

}  // namespace rocking

#include "rocking/studies/rare/committor.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/error.hpp"

namespace rocking::rare {
namespace {

constexpr std::int64_t most_kept = 1024;  // of a grid of 81 x 81 nodes 27 MB

/// Of a number of cells.
struct Cells {
  std::size_t whole;
  float rest;
};

Cells split(double cells, std::size_t count) {
  const double whole = std::min(std::floor(cells), static_cast<double>(count) - 1.0);
  return {static_cast<std::size_t>(whole), static_cast<float>(cells - whole)};
}

constexpr double smoothing = 0.3;  ///< of the law of an amplitude: samples are 0.75 apart

}  // namespace

double eighth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

double SectionAxis::node(std::size_t index) const {
  const std::size_t half = inner_cells + outer_cells;
  const std::size_t steps = index < half ? half - index : index - half;
  const double beyond = steps > inner_cells ? static_cast<double>(steps - inner_cells) : 0.0;
  const double within = static_cast<double>(std::min(steps, inner_cells));
  const double distance = inner * (within / static_cast<double>(inner_cells)) +
                          (outer - inner) * (beyond / static_cast<double>(outer_cells));
  return index < half ? -distance : distance;
}

double SectionAxis::cells_to(double coordinate) const {
  const double distance = std::min(std::abs(coordinate), outer);
  const double within = std::min(distance, inner) / inner * static_cast<double>(inner_cells);
  const double beyond = std::max(distance - inner, 0.0) / (outer - inner) * static_cast<double>(outer_cells);
  const double half = static_cast<double>(inner_cells + outer_cells);
  return coordinate < 0.0 ? half - within - beyond : half + within + beyond;
}

NormalLaw NormalFit::law() const {
  if (!(sum_ > 0.0)) return {};
  const double mean = first_ / sum_;
  const double variance = std::max(second_ / sum_ - mean * mean, 0.0);
  return {.mean = mean, .width = std::sqrt(variance + smoothing * smoothing)};
}

SectionPoint SectionGrid::node(std::size_t index) const {
  const std::size_t in_layer = index % layer_size();
  return {.tilt = tilt_.node(in_layer % row_length()),
          .tilt_rate = tilt_rate_.node(in_layer / row_length()),
          .slip_rate = slip_rate_ ? slip_rate_->node(index / layer_size()) : 0.0};
}

SectionGrid::Place SectionGrid::place(const SectionPoint& point) const {
  const Cells right = split(tilt_.cells_to(point.tilt), tilt_.cells());
  const Cells up = split(tilt_rate_.cells_to(point.tilt_rate), tilt_rate_.cells());
  const Cells ahead = slip_rate_ ? split(slip_rate_->cells_to(point.slip_rate), slip_rate_->cells()) : Cells{0, 0.0F};
  return {.node = static_cast<std::uint32_t>(ahead.whole * layer_size() + up.whole * row_length() + right.whole),
          .right = right.rest,
          .up = up.rest,
          .ahead = ahead.rest};
}

std::vector<Committor::PlacedImage> Committor::placed(const std::vector<Image>& images) const {
  std::vector<PlacedImage> all;
  all.reserve(images.size());
  for (const Image& image : images) all.push_back({image.fate, grid_.place(image.point)});
  return all;
}

Committor::Committor(const SectionGrid& grid, std::span<const Transitions> transitions, std::int64_t periods,
                     const std::function<void()>& look)
    : grid_(grid), periods_(periods), stride_((periods + most_kept - 1) / most_kept) {
  ROCKING_EXPECT(transitions.size() == 1 || static_cast<std::int64_t>(transitions.size()) >= periods - 1);
  Nodes next{.roots = std::vector<float>(grid.size(), 0.0F), .means = {}, .widths = {}};
  nodes_.push_back(next);
  std::vector<PlacedImage> images;
  for (std::int64_t remaining = 1; remaining < periods; ++remaining) {
    if (look) look();
    const bool is_one = transitions.size() == 1;
    const Transitions& of_period = transitions[is_one ? 0 : static_cast<std::size_t>(periods - remaining - 1)];
    if (remaining == 1 || !is_one) images = placed(of_period.images);
    next = one_period_before(of_period, images, next.roots);
    if (remaining % stride_ == 0) nodes_.push_back(next);
  }
}

Committor::Nodes Committor::one_period_before(const Transitions& transitions, const std::vector<PlacedImage>& images,
                                              const std::vector<float>& next) const {
  const std::size_t samples = transitions.weights.size();
  const bool has_amplitudes = !transitions.amplitudes.empty();
  Nodes nodes{.roots = std::vector<float>(grid_.size()),
              .means = std::vector<float>(has_amplitudes ? grid_.size() : 0),
              .widths = std::vector<float>(has_amplitudes ? grid_.size() : 0)};
  for (std::size_t node = 0; node < grid_.size(); ++node) {
    double sum = 0.0;
    NormalFit fit;
    for (std::size_t j = 0; j < samples; ++j) {
      const PlacedImage& image = images[node * samples + j];
      if (image.fate == Image::Fate::ends) continue;
      const bool moves_on = image.fate == Image::Fate::moves_on;
      const double h = transitions.weights[j] * (moves_on ? eighth_power(grid_.interpolated(next, image.place)) : 1.0);
      sum += h;
      if (has_amplitudes) fit.add(h, transitions.amplitudes[j]);
    }
    const double root = rare::eighth_root(std::min(sum, 1.0));
    nodes.roots[node] = static_cast<float>(root);
    if (!has_amplitudes) continue;
    const NormalLaw law = fit.law();
    nodes.means[node] = static_cast<float>(root * law.mean);
    nodes.widths[node] = static_cast<float>(root * law.width);
  }
  return nodes;
}

const Committor::Nodes& Committor::nodes(std::int64_t k) const {
  ROCKING_EXPECT(1 <= k && k <= periods_);
  return nodes_[static_cast<std::size_t>((periods_ - k) / stride_)];
}

NormalLaw Committor::amplitude(std::int64_t k, const SectionPoint& point) const {
  const Nodes& at = nodes(k);
  if (at.means.empty()) return {};
  const SectionGrid::Place place = grid_.place(point);
  const double root = grid_.interpolated(at.roots, place);
  if (!(root > 0.0)) return {};
  return {.mean = grid_.interpolated(at.means, place) / root, .width = grid_.interpolated(at.widths, place) / root};
}

double Committor::eighth_root(std::int64_t k, const SectionPoint& point) const {
  return grid_.interpolated(nodes(k).roots, grid_.place(point));
}

double Committor::operator()(std::int64_t k, const SectionPoint& point) const {
  return eighth_power(eighth_root(k, point));
}

double Committor::at_node(std::int64_t k, std::size_t node) const {
  return eighth_power(static_cast<double>(nodes(k).roots[node]));
}

}  // namespace rocking::rare

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

/// An image with its place on the grid.
struct PlacedImage {
  Image::Fate fate;
  SectionGrid::Place place;
};

std::vector<PlacedImage> placed(const SectionGrid& grid, const std::vector<Image>& images) {
  std::vector<PlacedImage> all;
  all.reserve(images.size());
  for (const Image& image : images) all.push_back({image.fate, grid.place(image.point)});
  return all;
}

/// The eighth roots one period before those of `next`.
std::vector<float> one_period_before(const SectionGrid& grid, const std::vector<double>& weights,
                                     const std::vector<PlacedImage>& images, const std::vector<float>& next) {
  std::vector<float> roots(grid.size());
  for (std::size_t node = 0; node < roots.size(); ++node) {
    double sum = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const PlacedImage& image = images[node * weights.size() + j];
      if (image.fate == Image::Fate::ends) continue;
      const bool moves_on = image.fate == Image::Fate::moves_on;
      sum += weights[j] * (moves_on ? eighth_power(grid.interpolated(next, image.place)) : 1.0);
    }
    roots[node] = static_cast<float>(eighth_root(std::min(sum, 1.0)));
  }
  return roots;
}

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

Committor::Committor(const SectionGrid& grid, std::span<const Transitions> transitions, std::int64_t periods,
                     const std::function<void()>& look)
    : grid_(grid), periods_(periods), stride_((periods + most_kept - 1) / most_kept) {
  ROCKING_EXPECT(transitions.size() == 1 || static_cast<std::int64_t>(transitions.size()) >= periods - 1);
  std::vector<float> next(grid.size(), 0.0F);
  roots_.push_back(next);
  std::vector<PlacedImage> images;
  for (std::int64_t remaining = 1; remaining < periods; ++remaining) {
    if (look) look();
    const bool is_one = transitions.size() == 1;
    const Transitions& of_period = transitions[is_one ? 0 : static_cast<std::size_t>(periods - remaining - 1)];
    if (remaining == 1 || !is_one) images = placed(grid, of_period.images);
    next = one_period_before(grid, of_period.weights, images, next);
    if (remaining % stride_ == 0) roots_.push_back(next);
  }
}

const std::vector<float>& Committor::roots(std::int64_t k) const {
  ROCKING_EXPECT(1 <= k && k <= periods_);
  return roots_[static_cast<std::size_t>((periods_ - k) / stride_)];
}

double Committor::eighth_root(std::int64_t k, const SectionPoint& point) const {
  return grid_.interpolated(roots(k), grid_.place(point));
}

double Committor::operator()(std::int64_t k, const SectionPoint& point) const {
  return eighth_power(eighth_root(k, point));
}

double Committor::at_node(std::int64_t k, std::size_t node) const {
  return eighth_power(static_cast<double>(roots(k)[node]));
}

}  // namespace rocking::rare

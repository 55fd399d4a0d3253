#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rocking::rare {

/// A point of the Poincare section.
struct SectionPoint {
  double tilt = 0.0;       ///< Theta [-]
  double tilt_rate = 0.0;  ///< Theta' [-]
  double slip_rate = 0.0;  ///< V [-]
};

/// Nodes of one coordinate, symmetric about 0, which is one of them: `inner_cells` of one length up to `inner`, and
/// `outer_cells` from there to `outer`, on each side. inner < outer.
struct SectionAxis {
  double inner = 1.0;
  double outer = 2.0;
  std::size_t inner_cells = 1;
  std::size_t outer_cells = 1;

  [[nodiscard]] std::size_t cells() const { return 2 * (inner_cells + outer_cells); }
  [[nodiscard]] double node(std::size_t index) const;
  /// Whole cells and a part from the first node to the coordinate; of one beyond the ends, to the end.
  [[nodiscard]] double cells_to(double coordinate) const;
};

/// A grid of nodes, one of which is the state of rest. What lies outside has the place of the nearest point on the
/// edge.
class SectionGrid {
 public:
  /// Without `slip_rate` all nodes have V = 0, and the place of a point does not depend on its V.
  SectionGrid(const SectionAxis& tilt, const SectionAxis& tilt_rate, const std::optional<SectionAxis>& slip_rate = {})
      : tilt_(tilt), tilt_rate_(tilt_rate), slip_rate_(slip_rate) {}

  [[nodiscard]] std::size_t size() const { return layer_size() * (slip_rate_ ? slip_rate_->cells() + 1 : 1); }
  [[nodiscard]] const SectionAxis& tilt() const { return tilt_; }
  [[nodiscard]] const SectionAxis& tilt_rate() const { return tilt_rate_; }
  [[nodiscard]] SectionPoint node(std::size_t index) const;

  /// The cell of a point: its first node, and the distances from there in cells.
  struct Place {
    std::uint32_t node = 0;
    float right = 0.0F;
    float up = 0.0F;
    float ahead = 0.0F;  ///< to the next V; 0 without
  };
  [[nodiscard]] Place place(const SectionPoint& point) const;

  /// Linear interpolation between the nodes, in each coordinate.
  template <class Values>
  [[nodiscard]] double interpolated(const Values& values, const Place& place) const {
    const double here = in_layer(values, place.node, place);
    if (place.ahead == 0.0F) return here;
    return here + static_cast<double>(place.ahead) * (in_layer(values, place.node + layer_size(), place) - here);
  }

 private:
  [[nodiscard]] std::size_t row_length() const { return tilt_.cells() + 1; }
  [[nodiscard]] std::size_t layer_size() const { return row_length() * (tilt_rate_.cells() + 1); }

  template <class Values>
  [[nodiscard]] double in_layer(const Values& values, std::size_t n, const Place& place) const {
    const std::size_t row = row_length();
    const double x = place.right;
    const double y = place.up;
    const double low = values[n] + x * (values[n + 1] - values[n]);
    const double high = values[n + row] + x * (values[n + row + 1] - values[n + row]);
    return low + y * (high - low);
  }

  SectionAxis tilt_;
  SectionAxis tilt_rate_;
  std::optional<SectionAxis> slip_rate_;
};

struct NormalLaw {
  double mean = 0.0;
  double width = 1.0;
};

/// Where a motion that starts in a node is a period later.
struct Image {
  enum class Fate : std::uint8_t {
    moves_on,
    event,  ///< the event has happened
    ends,   ///< without the event, which cannot happen any more
  };
  Fate fate = Fate::moves_on;
  SectionPoint point;
};

/// Images of the nodes of a grid over one period: of node i the sample j is images[i * weights.size() + j], with the
/// probability weights[j].
struct Transitions {
  std::vector<double> weights;
  std::vector<Image> images;
  std::vector<double> amplitudes = {};  ///< of each sample, the normal number of its amplitude; empty: none is given
};

/// The first two moments of a normal number, of samples with weights.
class NormalFit {
 public:
  void add(double weight, double number) {
    sum_ += weight;
    first_ += weight * number;
    second_ += weight * number * number;
  }
  /// A little wider than the samples, which are few. Without any, the standard normal law.
  [[nodiscard]] NormalLaw law() const;

 private:
  double sum_ = 0.0;
  double first_ = 0.0;
  double second_ = 0.0;
};

/// h(k, z): estimate of the probability that the event happens between strobe point k and the last one, number
/// `periods`, of a motion that is in z at strobe point k. By backward recursion over the grid:
///
///     h(k, node i) = sum over j of weights[j] h(k + 1, image j of node i),   h(periods, z) = 0
///
/// with h = 1 at the event, and of the given amplitudes the moments under weights[j] h(k + 1, image j). The eighth root of
/// h is interpolated: h falls off over many orders of magnitude between nodes, and it may be 0.
class Committor {
 public:
  /// `transitions`: one for all periods, or that of each period k to k + 1, k = 1 ... periods - 1.
  /// `look` is called in each period; it may throw.
  Committor(const SectionGrid& grid, std::span<const Transitions> transitions, std::int64_t periods,
            const std::function<void()>& look = {});

  [[nodiscard]] const SectionGrid& grid() const { return grid_; }
  [[nodiscard]] std::int64_t periods() const { return periods_; }
  /// h(k, z)^(1/8), 1 <= k <= periods.
  [[nodiscard]] double eighth_root(std::int64_t k, const SectionPoint& point) const;
  [[nodiscard]] double operator()(std::int64_t k, const SectionPoint& point) const;
  /// h(k, node).
  [[nodiscard]] double at_node(std::int64_t k, std::size_t node) const;
  /// Of the amplitude between strobe points k and k + 1, given that the event happens: its normal number is about so.
  [[nodiscard]] NormalLaw amplitude(std::int64_t k, const SectionPoint& point) const;

 private:
  struct Nodes {
    std::vector<float> roots;   ///< h^(1/8)
    std::vector<float> means;   ///< of the amplitude, times the roots; empty: none is given
    std::vector<float> widths;  ///< likewise
  };
  /// An image with its place on the grid.
  struct PlacedImage {
    Image::Fate fate;
    SectionGrid::Place place;
  };
  [[nodiscard]] std::vector<PlacedImage> placed(const std::vector<Image>& images) const;
  /// `next`: the roots one period later.
  [[nodiscard]] Nodes one_period_before(const Transitions& transitions, const std::vector<PlacedImage>& images,
                                        const std::vector<float>& next) const;
  /// Of a long horizon, h is kept for every `stride_`-th number of remaining periods.
  [[nodiscard]] const Nodes& nodes(std::int64_t k) const;

  SectionGrid grid_;
  std::int64_t periods_;
  std::int64_t stride_;
  std::vector<Nodes> nodes_;  ///< by remaining periods over the stride
};

[[nodiscard]] inline double eighth_power(double x) {
  const double square = x * x;
  const double fourth = square * square;
  return fourth * fourth;
}
[[nodiscard]] double eighth_root(double x);

}  // namespace rocking::rare

#include "rocking/scene/shaking.hpp"

#include <algorithm>
#include <variant>

namespace rocking {
namespace {

constexpr double two_pi = 0x1.921fb54442d18p+2;

/// Sets the amplitudes that do not stand in the scene.
void add_amplitudes(const std::optional<PhysicalAmplitude>& physical, const SceneBlock& block, double psi,
                    Shaking& shaking) {
  if (!physical) {
    shaking.amplitude_g = shaking.amplitude * psi;
    shaking.amplitude_m_s2 = shaking.amplitude_g * block.gravity;
    return;
  }
  const bool in_g = physical->unit == AccelerationUnit::gravity;
  const double value = mean_of(physical->value);
  shaking.given_amplitude = shaking_numbers[in_g ? 1 : 2].key;
  shaking.amplitude_g = in_g ? value : value / block.gravity;
  shaking.amplitude_m_s2 = in_g ? value * block.gravity : value;
}

void add_frequencies(const std::optional<PhysicalFrequency>& physical, double p, Shaking& shaking) {
  if (!physical) {
    shaking.frequency_hz = shaking.frequency_ratio * p / two_pi;
    shaking.period_s = two_pi / (shaking.frequency_ratio * p);
    return;
  }
  const bool in_hertz = physical->unit == FrequencyUnit::hertz;
  const double value = mean_of(physical->value);
  shaking.given_frequency = shaking_numbers[in_hertz ? 4 : 5].key;
  shaking.frequency_hz = in_hertz ? value : 1.0 / value;
  shaking.period_s = in_hertz ? 1.0 / value : value;
}

template <class Physical>
bool is_given_drawn(const std::optional<Physical>& physical, const Quantity& ratio) {
  return is_drawn(physical ? physical->value : ratio);
}

}  // namespace

BalanceAngles balance_of(const Scene& scene) {
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const double left = block.edges[0].shape_angle, right = block.edges[1].shape_angle;
  if (block.open_side != 0.0) {
    const double only = block.open_side > 0.0 ? left : right;
    return {.least = only, .largest = only, .is_of_mean_block = is_drawn(scene.block)};
  }
  const auto [least, largest] = std::minmax(left, right);
  return {.least = least, .largest = largest, .is_of_mean_block = is_drawn(scene.block)};
}

BalanceAngles joined(const std::optional<BalanceAngles>& first, const BalanceAngles& second) {
  if (!first) return second;
  return {.least = std::min(first->least, second.least),
          .largest = std::max(first->largest, second.largest),
          .is_of_mean_block = first->is_of_mean_block || second.is_of_mean_block};
}

std::optional<Shaking> shaking_of(const Scene& scene) {
  const dynamics::Geometry mean = dynamics::geometry_of(mean_block(scene));
  Shaking shaking{.amplitude = amplitude_for(scene, mean), .frequency_ratio = frequency_ratio_for(scene, mean)};
  return std::visit(
      [&]<class Kind>(const Kind& kind) -> std::optional<Shaking> {
        if constexpr (requires { kind.physical_amplitude; }) {
          add_amplitudes(kind.physical_amplitude, scene.block, mean.shape_angle, shaking);
          add_frequencies(kind.physical_frequency, mean.frequency_parameter, shaking);
          shaking.has_drawn_amplitude = is_given_drawn(kind.physical_amplitude, kind.amplitude);
          shaking.has_drawn_frequency = is_given_drawn(kind.physical_frequency, kind.frequency_ratio);
          if constexpr (requires { kind.vertical; }) {
            if (kind.vertical) {
              const dynamics::VerticalSine sine = kind.vertical_sine(mean, scene.block.gravity);
              shaking.vertical = VerticalShaking{.amplitude_g = sine.amplitude,
                                                 .frequency_hz = sine.cycles / sine.periods * shaking.frequency_hz,
                                                 .phase_rad = sine.phase};
            }
          }
          return shaking;
        } else {
          return std::nullopt;
        }
      },
      scene.excitation);
}

}  // namespace rocking

#include "rocking/scene/excitation.hpp"

namespace rocking {

bool is_drawn(const Quantity& quantity) { return !std::holds_alternative<double>(quantity); }

Reach reach_of(const Quantity& quantity) {
  constexpr double largest_normal_draw = 8.6;
  if (const auto* uniform = std::get_if<Uniform>(&quantity)) return {.least = uniform->low, .largest = uniform->high};
  if (const auto* normal = std::get_if<Normal>(&quantity)) {
    const double farthest = largest_normal_draw * normal->sigma;
    return {.least = normal->mean - farthest, .largest = normal->mean + farthest};
  }
  return {.least = std::get<double>(quantity), .largest = std::get<double>(quantity)};
}

double mean_of(const Quantity& quantity) {
  if (const auto* uniform = std::get_if<Uniform>(&quantity)) return 0.5 * (uniform->low + uniform->high);
  if (const auto* normal = std::get_if<Normal>(&quantity)) return normal->mean;
  return std::get<double>(quantity);
}

}  // namespace rocking

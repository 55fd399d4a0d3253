#include "analysis/figure.hpp"

namespace rocking::analysis {

std::string label_of(const Axis& axis) {
  std::string label = axis.quantity;
  if (!axis.symbol.empty()) label += (label.empty() ? "" : " ") + axis.symbol;
  if (!axis.unit.empty()) label += " [" + axis.unit + ']';
  return label;
}

}  // namespace rocking::analysis

#pragma once

#include <string>

namespace rocking {

/// How a number of an experiment is called in tables and figures.
struct QuantityName {
  std::string quantity;    ///< `base amplitude`
  std::string symbol;      ///< `A_h`, where a `_` begins a subscript; may be empty
  std::string unit;        ///< empty: dimensionless
  std::string latex = {};  ///< heading of a column in LaTeX; empty: the quantity
};

/// The name of the number at this place of an experiment.
[[nodiscard]] QuantityName quantity_name(const std::string& pointer);

}  // namespace rocking

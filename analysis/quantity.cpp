#include "analysis/quantity.hpp"

#include <algorithm>

#include "rocking/text/number_text.hpp"

namespace rocking::analysis {

double mean_of(const Json& quantity) {
  if (quantity.is_number()) return quantity.get<double>();
  if (quantity.contains("normal")) return quantity.at("normal").at("mean").get<double>();
  const Json& ends = quantity.at("uniform");
  return 0.5 * (ends.at(0).get<double>() + ends.at(1).get<double>());
}

Spread spread_of(const std::vector<double>& numbers) {
  const auto [low, high] = std::ranges::minmax(numbers);
  return {.low = low, .high = high};
}

std::string spread_in_words(const Spread& spread, int digits) {
  const std::string low = significant(spread.low, digits);
  const std::string high = significant(spread.high, digits);
  return low == high ? low : low + " to " + high;
}

std::string quantity_in_words(const Json& quantity) {
  const auto in_words = [](const Json& number) { return significant(number.get<double>(), 6); };
  if (quantity.is_number()) return in_words(quantity);
  if (quantity.contains("uniform")) {
    return in_words(quantity.at("uniform").at(0)) + " to " + in_words(quantity.at("uniform").at(1)) + " (drawn)";
  }
  const Json& normal = quantity.at("normal");
  return in_words(normal.at("mean")) + " (drawn, standard deviation " + in_words(normal.at("sigma")) + ")";
}

}  // namespace rocking::analysis

#include "analysis/quantity.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string_view name_of_law(const Quantity& quantity) {
  return std::visit(
      []<class Law>(const Law&) -> std::string_view {
        if constexpr (std::is_same_v<Law, double>) {
          return "";
        } else {
          return Law::name;
        }
      },
      quantity);
}

/// Of a law that is given by it and reaches as far as it does; absent otherwise.
std::optional<double> standard_deviation_in(const Quantity& quantity) {
  return std::visit(
      []<class Law>(const Law& law) -> std::optional<double> {
        if constexpr (requires { law.between; }) {
          if (law.between) return std::nullopt;
        }
        if constexpr (requires { law.sigma; }) return law.sigma;
        return std::nullopt;
      },
      quantity);
}

}  // namespace

Spread spread_of(const std::vector<double>& numbers) {
  const auto [low, high] = std::ranges::minmax(numbers);
  return {.low = low, .high = high};
}

std::string spread_in_words(const Spread& spread, int digits) {
  const std::string low = significant(spread.low, digits);
  const std::string high = significant(spread.high, digits);
  return low == high ? low : low + " to " + high;
}

std::string quantity_in_words(const Quantity& quantity) {
  const double mean = mean_of(quantity);
  if (!is_drawn(quantity)) return significant(mean, 6);
  const auto in_words = [](double number) { return significant(number, 3); };
  const std::string name(name_of_law(quantity));
  if (const auto sigma = standard_deviation_in(quantity)) {
    return in_words(mean) + " (drawn, " + (name == "normal" ? "" : name + ", ") + "standard deviation " +
           in_words(*sigma) + ')';
  }
  const Reach reach = reach_of(quantity);
  return in_words(reach.least) + " to " + in_words(reach.largest) +
         (name == "uniform" ? " (drawn)" : " (drawn, " + name + ')');
}

}  // namespace rocking::analysis

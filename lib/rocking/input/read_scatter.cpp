#include "rocking/input/read_scatter.hpp"

#include <cmath>

#include "rocking/scene/rules.hpp"

namespace rocking {

void read_scatter(ObjectReader& in, std::initializer_list<Scatter> of) {
  const bool is_relative = in.has("relative_sigma");
  if (is_relative && in.has("sigma")) return in.reject("relative_sigma", "excludes \"sigma\"", "keep one of them");
  const double given = in.number(is_relative ? "relative_sigma" : "sigma", rules::sigma);
  for (const Scatter& each : of) {
    const double sigma = is_relative ? given * std::abs(each.mean()) : given;
    if (rules::sigma.allows(sigma)) {
      *each.sigma = sigma;
    } else {
      in.reject("relative_sigma", "makes a standard deviation above 1e6", "give a smaller fraction of the mean");
    }
  }
}

}  // namespace rocking

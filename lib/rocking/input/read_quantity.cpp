#include "rocking/input/read_quantity.hpp"

#include <optional>
#include <utility>

#include "rocking/scene/check_numbers.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

Uniform read_uniform(ObjectReader& law, const NumberRule& rule) {
  const Json& ends = *law.value("uniform");
  if (!ends.is_array() || ends.size() != 2) {
    law.reject("uniform", "must be a list of two numbers, the ends of the interval",
               "give a value such as [-0.1, 0.1]");
    return {};
  }
  const std::string place = law.place_of("uniform");
  const auto low = checked_number(ends[0], child_pointer(place, "0"), rule, law.problems());
  const auto high = checked_number(ends[1], child_pointer(place, "1"), rule, law.problems());
  if (!low || !high) return {};
  if (auto refusal = refuse_ends({*low, *high})) {
    law.reject("uniform", std::move(refusal->reason), std::move(refusal->remedy));
  }
  law.write("uniform", Json::array({*low, *high}));
  return {*low, *high};
}

Normal read_normal(ObjectReader& law, const NumberRule& rule) {
  Normal normal;
  law.object("normal", [&](ObjectReader& in) {
    NumberRule required = rule;
    required.standard = std::nullopt;
    normal.mean = in.number("mean", required);
    normal.sigma = in.number("sigma", rules::sigma);
  });
  return normal;
}

}  // namespace

Quantity read_quantity(ObjectReader& in, std::string_view key, const NumberRule& rule) {
  const Json* found = in.value(key);
  if (found == nullptr || !found->is_object()) return in.number(key, rule);
  Quantity quantity = 0.0;
  in.object(key, [&](ObjectReader& law) {
    const bool uniform = law.has("uniform");
    const bool normal = law.has("normal");
    if (uniform == normal) {
      in.reject(key, uniform ? "cannot have two distributions" : "has no distribution",
                "give {\"uniform\": [a, b]} or {\"normal\": {\"mean\": m, \"sigma\": s}}");
    } else if (uniform) {
      quantity = read_uniform(law, rule);
    } else {
      quantity = read_normal(law, rule);
    }
  });
  return quantity;
}

}  // namespace rocking

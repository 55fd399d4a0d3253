#include "rocking/report/read_quantity.hpp"

#include <charconv>
#include <system_error>

#include "rocking/report/rules.hpp"

namespace rocking::report {
namespace {

using experiment::Normal;
using experiment::Quantity;
using experiment::Uniform;

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
  if (!(*low < *high))
    law.reject("uniform", "its first end must be less than its second", "swap them, or write a number");
  law.write("uniform", Json::array({*low, *high}));
  return {*low, *high};
}

Normal read_normal(ObjectReader& law, const NumberRule& rule) {
  Normal normal;
  law.object("normal", [&](ObjectReader& in) {
    normal.mean = in.number("mean", rule);
    normal.sigma = in.number("sigma", rules::sigma);
  });
  return normal;
}

}  // namespace

Quantity read_quantity(ObjectReader& in, std::string_view key, const NumberRule& rule) {
  const Json* found = in.value(key);
  if (found == nullptr || !found->is_object()) {
    NumberRule with_default = rule;
    with_default.standard = 0.0;
    return in.number(key, with_default);
  }
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

double mean_of(const Quantity& quantity) {
  if (const auto* uniform = std::get_if<Uniform>(&quantity)) return 0.5 * (uniform->low + uniform->high);
  if (const auto* normal = std::get_if<Normal>(&quantity)) return normal->mean;
  return std::get<double>(quantity);
}

std::optional<std::uint64_t> seed_from_text(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  std::uint64_t seed = 0;
  const char* const all_read = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), all_read, seed, hexadecimal ? 16 : 10);
  if (error != std::errc() || end != all_read) return std::nullopt;
  return seed;
}

std::string seed_text(std::uint64_t seed) {
  char digits[16];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, seed, 16);
  static_cast<void>(error);  // 16 digits hold every 64-bit number
  return "0x" + std::string(digits, end);
}

}  // namespace rocking::report

#include "rocking/base/build_info.hpp"

#include <cfenv>
#include <cmath>
#include <limits>
#include <string>

#include "rocking/base/digest.hpp"
#include "rocking/base/elementary.hpp"

namespace rocking::base {
namespace {

#if defined(__x86_64__)
bool fuses_in_hardware() { return __builtin_cpu_supports("fma") != 0; }
#else
bool fuses_in_hardware() { return true; }  // part of every AArch64
#endif

// Whether a b + c is rounded once: (1 + eps)^2 - (1 + 2 eps) = eps^2, which two roundings lose.
bool fuses_exactly() {
  const volatile double eps = std::numeric_limits<double>::epsilon();
  return fused(1.0 + eps, 1.0 + eps, -(1.0 + 2.0 * eps)) == eps * eps;
}

bool keeps_small_numbers() {
  const volatile double smallest = std::numeric_limits<double>::min();
  return 0.25 * smallest > 0.0;
}

// SHA-256 of sin, cos, atan and ln at ten thousand points.
std::string elementary_digest() {
  Sha256Builder digest;
  for (int i = -5000; i < 5000; ++i) {
    const double x = 0.12345 * i;
    const auto [sine, cosine] = sin_cos(x);
    digest.add(sine);
    digest.add(cosine);
    digest.add(arc_tangent(x));
    digest.add(natural_logarithm(std::abs(x) + 0.001));
  }
  return to_hex(digest.finish());
}

constexpr std::string_view expected_elementary_digest =
    "2a846a212407852e70922205ec897b9328975dfad54ef39934e185e96718351c";

}  // namespace

std::vector<ArithmeticCheck> arithmetic_checks() {
  return {{"fused_multiply_add_in_hardware", fuses_in_hardware()},
          {"fused_multiply_add_rounds_once", fuses_exactly()},
          {"rounds_to_nearest", std::fegetround() == FE_TONEAREST},
          {"keeps_subnormal_numbers", keeps_small_numbers()},
          {"elementary_functions_give_the_known_bits", elementary_digest() == expected_elementary_digest}};
}

}  // namespace rocking::base

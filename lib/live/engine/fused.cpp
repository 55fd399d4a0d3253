// A module of its own: a fused multiply-add in software. It calls that of the C library, which takes several times as long,
// for numbers of extreme size only.

#include "fused.hpp"

#include <cmath>

extern "C" {
double fused(double a, double b, double c);
double fused(double a, double b, double c) {
  return rocking::live::fused_in_software(a, b, c, [](double x, double y, double z) { return std::fma(x, y, z); });
}
}

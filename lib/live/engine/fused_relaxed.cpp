// A module of its own: a multiply-add of relaxed SIMD, which rounds once where the processor has such an instruction. The page
// uses it where it has the bits of fused.cpp.

#include <wasm_simd128.h>

extern "C" {
double fused(double a, double b, double c);
double fused(double a, double b, double c) {
  return wasm_f64x2_extract_lane(wasm_f64x2_relaxed_madd(wasm_f64x2_splat(a), wasm_f64x2_splat(b), wasm_f64x2_splat(c)),
                                 0);
}
}

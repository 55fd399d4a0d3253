#include "rocking/random/normal_kernels.hpp"

#include <vector>

namespace rocking::random {
namespace {

std::vector<NormalKernels> those_that_run_here() {
  std::vector<NormalKernels> all;
  const auto add = [&all](std::span<const NormalKernels> kernels) {
    all.insert(all.end(), kernels.begin(), kernels.end());
  };
  add(plain_normal_kernels());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
    add(avx512_normal_kernels());
  }
#endif
  return all;
}

}  // namespace

std::span<const NormalKernels> available_normal_kernels() {
  static const std::vector<NormalKernels> kernels = those_that_run_here();
  return kernels;
}

}  // namespace rocking::random

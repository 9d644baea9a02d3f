// SPDX-License-Identifier: MIT
// The CPU asked by the compiler's builtins, set by set, as Highway's targets need them.
#include "lane_target.h"

#include <hwy/detect_targets.h>

#include <atomic>

namespace moivre {
namespace {

// All others that the program may have been compiled for: without an answer nothing is left out.
constexpr std::int64_t kBaseline = HWY_ENABLED_BASELINE | HWY_EMU128 | HWY_SCALAR;

std::int64_t targets_of_cpu() {
  std::int64_t targets = kBaseline;
#if HWY_ARCH_X86
  __builtin_cpu_init();
  const auto add = [&](std::int64_t target, bool runs) { targets |= runs ? target : 0; };
  const bool ssse3 = __builtin_cpu_supports("ssse3");
  const bool sse4 = ssse3 && __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") &&
                    __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx3 = avx2 && __builtin_cpu_supports("avx512f") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  add(HWY_SSSE3, ssse3);
  add(HWY_SSE4, sse4);
  add(HWY_AVX2, avx2);
  add(HWY_AVX3, avx3);
#endif
  return targets;
}

std::atomic<std::int64_t> restriction{0};

}  // namespace

std::int64_t runnable_targets() {
  static const std::int64_t targets = targets_of_cpu();
  const std::int64_t only = restriction.load(std::memory_order_relaxed);
  return only == 0 ? targets : targets & only;
}

void restrict_targets(std::int64_t targets) {
  restriction.store(targets, std::memory_order_relaxed);
}

}  // namespace moivre

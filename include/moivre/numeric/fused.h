// SPDX-License-Identifier: MIT
// How does a program for every x86-64 use fused multiply-adds where the CPU has them? One function
// twice, chosen once.
//
// A program for the baseline instruction set calls the C library for std::fma. Double-double needs
// one for every product and spends most of its time in these calls. `fused(f)` runs f as compiled
// for the FMA instructions, with all that it calls inlined, where the CPU has them, else as it
// stands. std::fma rounds the same either way. Worth it around whole evaluations, not around single
// products. On other processors std::fma is an instruction anyway.
#pragma once

namespace moivre {

#if defined(__x86_64__) && !defined(__FMA__)

namespace detail {

inline bool has_fma() {
  static const bool has = [] {
    __builtin_cpu_init();
    return __builtin_cpu_supports("fma") != 0;
  }();
  return has;
}

template <class F>
__attribute__((target("fma"), flatten, noinline)) void run_fused(const F& f) {
  f();
}

}  // namespace detail

template <class F>
void fused(const F& f) {
  if (detail::has_fma()) {
    detail::run_fused(f);
  } else {
    f();
  }
}

#else

template <class F>
void fused(const F& f) {
  f();
}

#endif

}  // namespace moivre

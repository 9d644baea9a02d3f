// SPDX-License-Identifier: MIT
// How often were closures sought, their polynomials written down and solved? Counters on the calls;
// include once.
//
// The names are those that g++ and clang++ give find_closures, formulate and solve.
#pragma once

#include "counted_calls.h"
#include "moivre/closures/closures.h"
#include "moivre/formulation/formulation.h"

namespace moivre::test {

inline CallCounter closure_searches;
inline CallCounter closure_polynomials;
inline CallCounter solves;

}  // namespace moivre::test

moivre::ClosureResult
real_find_closures(const moivre::Mechanism& mechanism, const moivre::Tracker& tracker, const moivre::ClosureOptions& options, const std::atomic<bool>& stop) __asm__(
    "__real__ZN6moivre13find_closuresERKNS_9MechanismERKNS_7TrackerERKNS_14ClosureOptionsERKSt6"
    "atomicIbE");
moivre::ClosureResult
wrap_find_closures(const moivre::Mechanism& mechanism, const moivre::Tracker& tracker, const moivre::ClosureOptions& options, const std::atomic<bool>& stop) __asm__(
    "__wrap__ZN6moivre13find_closuresERKNS_9MechanismERKNS_7TrackerERKNS_14ClosureOptionsERKSt6"
    "atomicIbE");
moivre::ClosureResult wrap_find_closures(const moivre::Mechanism& mechanism,
                                         const moivre::Tracker& tracker,
                                         const moivre::ClosureOptions& options,
                                         const std::atomic<bool>& stop) {
  moivre::test::closure_searches.raise();
  return real_find_closures(mechanism, tracker, options, stop);
}

moivre::Formulation real_formulate(const moivre::Mechanism& mechanism, double t) __asm__(
    "__real__ZN6moivre9formulateERKNS_9MechanismEd");
moivre::Formulation wrap_formulate(const moivre::Mechanism& mechanism, double t) __asm__(
    "__wrap__ZN6moivre9formulateERKNS_9MechanismEd");
moivre::Formulation wrap_formulate(const moivre::Mechanism& mechanism, double t) {
  moivre::test::closure_polynomials.raise();
  return real_formulate(mechanism, t);
}

moivre::SolveResult
real_solve(const moivre::System& f, const moivre::Tracker& tracker, const moivre::SolveOptions& options, const std::atomic<bool>& stop) __asm__(
    "__real__ZN6moivre5solveERKNS_6SystemERKNS_7TrackerERKNS_12SolveOptionsERKSt6atomicIbE");
moivre::SolveResult
wrap_solve(const moivre::System& f, const moivre::Tracker& tracker, const moivre::SolveOptions& options, const std::atomic<bool>& stop) __asm__(
    "__wrap__ZN6moivre5solveERKNS_6SystemERKNS_7TrackerERKNS_12SolveOptionsERKSt6atomicIbE");
moivre::SolveResult wrap_solve(const moivre::System& f, const moivre::Tracker& tracker,
                               const moivre::SolveOptions& options, const std::atomic<bool>& stop) {
  moivre::test::solves.raise();
  return real_solve(f, tracker, options, stop);
}

// SPDX-License-Identifier: MIT
// How does a test run on every instruction set of the machine? One after the other is chosen, and
// the best again in the end.
#pragma once

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

#include "lane_target.h"

namespace moivre::test {

/// Chooses an instruction set for as long as it lives, for the library and for what the tests have
/// Highway dispatch.
class Target {
 public:
  explicit Target(std::int64_t target) { choose(target); }
  ~Target() { choose(0); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    restrict_targets(target);
  }
};

/// Every instruction set that the machine runs and the library was compiled for, the scalar one
/// among them.
inline std::vector<std::int64_t> targets() {
  std::vector<std::int64_t> all;
  std::int64_t rest = runnable_targets() & HWY_TARGETS;
  for (; rest != 0; rest &= rest - 1) all.push_back(rest & -rest);
  return all;
}

template <class Body>
void on_every_target(Body&& body) {
  for (const std::int64_t target : targets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const Target chosen(target);
    body();
  }
}

}  // namespace moivre::test

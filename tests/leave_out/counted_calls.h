// SPDX-License-Identifier: MIT
// How often was a function called? A counter that a wrapped function raises and a test reads.
#pragma once

namespace moivre::test {

/// Calls from the beginning of the program. Constant-initialized, so that a call before main counts
/// as well.
class CallCounter {
 public:
  void raise() noexcept { ++calls_; }
  int calls() const noexcept { return calls_; }
  int calls_of(auto&& action) {
    const int before = calls_;
    action();
    return calls_ - before;
  }

 private:
  int calls_ = 0;
};

}  // namespace moivre::test

// SPDX-License-Identifier: MIT
// How often was a function called? Counted<&function> stands where the linker joins caller and
// callee: the library holds no counter.
//
//   calls_of<Counted<&solve>>(action)   calls of solve() that other sources make during the action
//   Counted<&Phi::jacobian>::calls()    of a member function, from the beginning of the program
// counted_calls.cmake names call() and real() so, in the object file, that the linker sends calls
// of the function to call(), and those of real() to the function. Where it has not, real() is
// missing and nothing is linked.
// Edges: an overload is chosen by static_cast. What a compiler has joined within one source is not
// seen (moivre_alone of cmake/module.cmake).
// Not supported: constructors and virtual functions.
#pragma once

#include <atomic>
#include <utility>

namespace moivre::test {

/// A function of the same calling convention that is no member.
template <class R, class... A>
auto as_free_function(R (*)(A...)) -> R (*)(A...);
template <class C, class R, class... A>
auto as_free_function(R (C::*)(A...)) -> R (*)(C*, A...);
template <class C, class R, class... A>
auto as_free_function(R (C::*)(A...) const) -> R (*)(const C*, A...);

template <auto function, class Free = decltype(as_free_function(function))>
class Counted;

template <auto function, class R, class... A>
class Counted<function, R (*)(A...)> {
 public:
  /// Those before main included.
  static int calls() {
    // Without a use they would not be in the object file.
    static_cast<void>(&call);
    static_cast<void>(&named_);
    return calls_;
  }

 private:
  static R real(A... arguments);
  [[gnu::used]] static R call(A... arguments) {
    ++calls_;
    return real(std::forward<A>(arguments)...);
  }

  [[gnu::used]] static inline const auto named_ = function;
  static inline std::atomic<int> calls_ = 0;
};

/// Calls during the action. What: a Counted, or a sum of them.
template <class What>
int calls_of(auto&& action) {
  const int before = What::calls();
  action();
  return What::calls() - before;
}

}  // namespace moivre::test

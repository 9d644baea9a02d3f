// SPDX-License-Identifier: MIT
// How many threads, and the same work on each of them?
//
// What the work throws is thrown to the caller when all threads have ended. Not supported: pools
// that outlive a call.
#pragma once

#include <algorithm>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace moivre {

/// As many as are wanted; 0: as many as the machine has.
inline int thread_count(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// work() on each of so many threads, at least on the caller's; on fewer where the system gives no
/// more.
template <class Work>
void on_threads(int threads, const Work& work) {
  std::vector<std::future<void>> others;
  try {
    for (int k = 1; k < threads; ++k) {
      others.push_back(std::async(std::launch::async, [&work] { work(); }));
    }
  } catch (const std::system_error&) {
    // Of what is to be done each thread takes what is left.
  }
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace moivre

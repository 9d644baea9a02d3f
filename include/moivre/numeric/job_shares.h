// SPDX-License-Identifier: MIT
// Which jobs of a list are this process's, where several do them, and what became of the others'?
//
//   draw()   a job that nobody has begun, until all are in hand or done
//   tell()   what became of it, as exact bytes, for all
//   wait()   what became of those of other processes
//
// Every process takes all outcomes and goes on with them, as if it had done all jobs. So the
// outcome of a job may depend on nothing but what the list's fingerprint is made of
// (moivre/numeric/observations.h). One that ends leaves what it has begun to the others.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace moivre {

struct ToldOutcome {
  std::uint64_t job = 0;
  std::string bytes;
};

class JobShares {
 public:
  virtual ~JobShares() = default;
  /// None where every job is in hand or done. Thread-safe.
  virtual std::optional<std::uint64_t> draw() = 0;
  /// Of a job that was drawn, or whose outcome was known. False: another has told it before, and
  /// wait() has its outcome, which is to be taken once. Thread-safe.
  virtual bool tell(std::uint64_t job, std::string outcome) = 0;
  /// Outcomes that others have sent since, when there are any; none: there are jobs to draw again.
  /// nullopt: all outcomes have come in, or nobody sends what is missing, or the run is to stop.
  virtual std::optional<std::vector<ToldOutcome>> wait(const std::atomic<bool>& stop) = 0;
};

/// Does jobs as long as there are any to draw, and takes what others tell. do_mine() draws until
/// there is none.
inline void do_together(JobShares& shares, const std::atomic<bool>& stop,
                        const std::function<void()>& do_mine,
                        const std::function<void(const ToldOutcome&)>& take) {
  do_mine();
  while (const auto told = shares.wait(stop)) {
    for (const ToldOutcome& outcome : *told) take(outcome);
    if (told->empty()) do_mine();
  }
}

}  // namespace moivre

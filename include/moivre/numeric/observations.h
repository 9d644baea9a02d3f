// SPDX-License-Identifier: MIT
// What has long work observed that need not be observed again? The outcomes of jobs, kept beyond
// the process.
//
//   list     jobs that are done together; its fingerprint is made of everything that their outcomes
//            depend on
//   job      its number in the list
//   outcome  exact bytes (numeric/bytes.h), and its kind, for those who look on
//
// Whatever lies between two lists follows from them and from what the run was asked. So a run to
// which the outcomes are told again is the run that they were first told to, to the last bit
// (decision 77).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "moivre/numeric/fingerprint.h"
#include "moivre/numeric/job_shares.h"

namespace moivre {

enum class OutcomeKind : std::uint8_t { root, at_infinity, failed, other };

struct JobOutcome {
  std::uint64_t job = 0;
  std::string bytes;
  OutcomeKind kind = OutcomeKind::other;
};

class Observations {
 public:
  virtual ~Observations() = default;
  /// The outcomes of this list that are kept, by job. Thread-safe.
  virtual std::map<std::uint64_t, std::string> recall(const Fingerprint& list) = 0;
  /// Takes outcomes, which are kept for good a little later, all of them or none. Thread-safe.
  virtual void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) = 0;

  /// Of a list of so many jobs, numbered from 0, that other processes do too; nullptr: this one is
  /// alone. Thread-safe.
  virtual std::unique_ptr<JobShares> share(const Fingerprint& /*list*/, std::uint64_t /*jobs*/) {
    return nullptr;
  }
  /// Lists of which none depends on another are done, as far as this process can, and no stop has
  /// cut them short; what comes next depends on them all. Thread-safe.
  virtual void lists_are_done() {}

  void keep(const Fingerprint& list, const JobOutcome& outcome) { keep(list, {&outcome, 1}); }
};

}  // namespace moivre

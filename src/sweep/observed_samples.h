// SPDX-License-Identifier: MIT
// Which samples were solved before? A sample is a job, told apart by its numbers.
//
// What else samples depend on is the run's: the mechanism, and the options that its ledger
// compares. A sample during which a family was learned is solved again, so that the families are
// there.
// Private to the module.
#pragma once

#include <optional>

#include "moivre/sweep/sweep.h"

namespace moivre {

class ObservedSamples {
 public:
  /// By options.closures.solve.observations, where there are any.
  ObservedSamples(const std::vector<Varied>& varied, const Tracker& tracker,
                  const SweepOptions& options);

  std::optional<SweepSample> recall(const std::vector<double>& at) const;
  void keep(const SweepSample& sample) const;

 private:
  Observations* observations_;
  Fingerprint list_;
  std::map<std::uint64_t, std::string> known_;
};

}  // namespace moivre

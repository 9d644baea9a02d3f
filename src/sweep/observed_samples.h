// SPDX-License-Identifier: MIT
// Which samples were solved before, and which borders between them were found, here or by other
// processes? A sample is a job, told apart by its numbers; of a list of borders each is one.
//
// What else samples depend on is the run's: the mechanism, and the options that its ledger
// compares. A sample during which a family was learned is solved again, so that the families are
// there.
// Private to the module.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "moivre/numeric/observations.h"
#include "moivre/sweep/sweep.h"

namespace moivre {

/// Two neighbours on the grid, which differ in the number `along`.
struct SamplePair {
  std::size_t first, second, along;
};

class ObservedSamples {
 public:
  /// By options.closures.solve.observations, where there are any.
  ObservedSamples(const std::vector<Varied>& varied, const Tracker& tracker,
                  const SweepOptions& options);

  std::optional<SweepSample> recall(const std::vector<double>& at) const;
  void keep(const SweepSample& sample) const;

  /// Of all samples, and of the borders between these pairs of them.
  Fingerprint list() const { return list_; }
  Fingerprint list_of_borders(const std::vector<SweepSample>& samples,
                              const std::vector<SamplePair>& pairs) const;
  Observations* observations() const { return observations_; }

 private:
  Observations* observations_;
  Fingerprint list_;
  std::map<std::uint64_t, std::string> known_;
};

/// Exact bytes, and what they say.
std::string bytes_of(const SweepSample& sample);
SweepSample sample_of(std::string_view bytes);
std::string bytes_of(const std::vector<SweepBorder>& borders);
std::vector<SweepBorder> borders_of(std::string_view bytes);

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Which families of coefficients are known, and is this system a member of one? A cache that grows
// while systems are solved.
//
// Linear equations of a system are eliminated. The rest is a member of the family of its monomials
// (family/coefficients.h). The family is learned when it is first met. Every later system with
// these monomials, or fewer, then takes as many paths as a generic one has roots. Mechanisms are
// solved block by block, and each kind of block is a family.
//
// Thread-safe. Edges: a family that could not be learned completely is not kept; its systems are
// solved as usual.
#pragma once

#include <memory>
#include <mutex>

#include "moivre/family/family.h"

namespace moivre {

class FamilyBook : public KnownStarts {
 public:
  /// seed: of what is learned.
  explicit FamilyBook(std::vector<Family> families = {}, std::uint64_t seed = 1);

  /// From the roots of f's family; nullopt if elimination alone decides, or no family could be
  /// learned.
  std::optional<GivenStart> start_of(const System& f, const Tracker& tracker,
                                     const SolveOptions& options,
                                     const std::atomic<bool>& stop) override;

  std::vector<Family> families() const;
  /// How many were learned since it was made.
  std::size_t learned() const;

 private:
  std::shared_ptr<const Family> find(const System& f) const;
  std::shared_ptr<const Family> find_or_learn(const System& f, const Tracker& tracker,
                                              const SolveOptions& options,
                                              const std::atomic<bool>& stop);

  mutable std::mutex mutex_;
  std::mutex learning_;  // one at a time
  std::vector<std::shared_ptr<const Family>> families_;
  std::vector<System> refused_;  // could not be learned
  std::uint64_t seed_;
  std::size_t learned_ = 0;
};

}  // namespace moivre

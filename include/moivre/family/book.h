// SPDX-License-Identifier: MIT
// Which families of coefficients are known, and is this system a member of one? A book that grows while systems are solved.
//
// A system is reduced by its linear equations; what is left is a member of the family of its monomials (family/coefficients.h). That
// family is learned when it is first met, and every later system with these monomials, or fewer, takes as many paths as a
// generic one has roots. Mechanisms are solved block by block: each kind of block is a family.
//
// Thread-safe. Edges: a family that could not be learned completely is not kept; its systems are solved as any other.
#pragma once

#include <memory>
#include <mutex>

#include "moivre/family/family.h"

namespace moivre {

class FamilyBook {
 public:
  /// seed: of what is learned.
  explicit FamilyBook(std::vector<Family> families = {}, std::uint64_t seed = 1);

  /// The roots of f by a family; nullopt where elimination alone decides, or no family can be had.
  std::optional<SolveResult> solve(const System& f, const Tracker& tracker,
                                   const SolveOptions& options, const std::atomic<bool>& stop);

  /// Makes solve() ask this book first. The book must outlive every use of the options.
  void serve(SolveOptions& options);

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

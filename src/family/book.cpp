// SPDX-License-Identifier: MIT
// Families found by their monomials, and learned where there is none yet.
#include "moivre/family/book.h"

#include <algorithm>

#include "moivre/family/coefficients.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/solver/given_start.h"
#include "start_of_member.h"

namespace moivre {
namespace {

bool has_zero_polynomial(const System& f) {
  return std::any_of(f.polynomials.begin(), f.polynomials.end(),
                     [](const Polynomial& p) { return p.terms.empty(); });
}

/// The same equations in x1, x2, ...: what the unknowns are called is no part of a family of
/// blocks.
System renamed(System f) {
  for (std::size_t j = 0; j < f.variables.size(); ++j) {
    f.variables[j] = std::string("x").append(std::to_string(j + 1));
  }
  f.groups.clear();
  return f;
}

}  // namespace

FamilyBook::FamilyBook(std::vector<Family> families, std::uint64_t seed) : seed_(seed) {
  for (Family& family : families) {
    families_.push_back(std::make_shared<const Family>(std::move(family)));
  }
}

std::shared_ptr<const Family> FamilyBook::find(const System& f) const {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Family> best;
  for (const auto& family : families_) {
    if (best && best->roots.size() <= family->roots.size()) continue;
    if (coefficients_in(*family, f)) best = family;
  }
  return best;
}

std::shared_ptr<const Family> FamilyBook::find_or_learn(const System& f, const Tracker& tracker,
                                                        const SolveOptions& options,
                                                        const std::atomic<bool>& stop) {
  if (auto known = find(f)) return known;
  const std::lock_guard learning(learning_);
  if (auto known = find(f)) return known;
  Family unlearned = coefficient_family(renamed(f));
  if (std::find(refused_.begin(), refused_.end(), unlearned.system) != refused_.end()) {
    return nullptr;
  }
  SolveOptions of_learning = options;
  of_learning.seed = seed_;
  of_learning.start = StartKind::automatic;
  of_learning.certify = true;
  of_learning.progress = nullptr;
  Family family = learn(unlearned, tracker, of_learning, stop);
  if (!family.learning.complete) {
    if (!stop) refused_.push_back(std::move(unlearned.system));
    return nullptr;
  }
  const std::lock_guard lock(mutex_);
  ++learned_;
  families_.push_back(std::make_shared<const Family>(std::move(family)));
  return families_.back();
}

std::optional<GivenStart> FamilyBook::start_of(const System& f, const Tracker& tracker,
                                               const SolveOptions& options,
                                               const std::atomic<bool>& stop) {
  Reduction reduction = eliminate(f);
  const System& reduced = reduction.system;
  if (reduction.verdict != Reduction::Verdict::square || has_zero_polynomial(reduced)) {
    return std::nullopt;
  }
  const std::shared_ptr<const Family> family = find_or_learn(reduced, tracker, options, stop);
  if (!family) return std::nullopt;
  GivenStart start = start_of_member(*family, *coefficients_in(*family, reduced), reduced);
  start.reduction = std::move(reduction);
  return start;
}

std::vector<Family> FamilyBook::families() const {
  const std::lock_guard lock(mutex_);
  std::vector<Family> families;
  for (const auto& family : families_) families.push_back(*family);
  return families;
}

std::size_t FamilyBook::learned() const {
  const std::lock_guard lock(mutex_);
  return learned_;
}

}  // namespace moivre

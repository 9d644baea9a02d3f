// SPDX-License-Identifier: MIT
// A choice of one factor of every term, term after term; the smallest choices are the planes.
#include "moivre/polynomial/coordinate_planes.h"

#include <algorithm>

namespace moivre {
namespace {

using Zeros = std::vector<std::uint32_t>;

bool has_zero_factor(const Monomial& m, const Zeros& zeros) {
  return std::any_of(m.begin(), m.end(), [&](const Power& factor) {
    return std::binary_search(zeros.begin(), zeros.end(), factor.variable);
  });
}

Zeros with(Zeros zeros, std::uint32_t variable) {
  zeros.insert(std::lower_bound(zeros.begin(), zeros.end(), variable), variable);
  return zeros;
}

/// Every Z that is smallest, and others.
class Choices {
 public:
  explicit Choices(const System& f) : unknowns_(f.variables.size()) {
    for (const Polynomial& p : f.polynomials) {
      for (const Term& term : p.terms) terms_.push_back(&term.monomial);
    }
    // Those of few factors leave few choices.
    std::stable_sort(terms_.begin(), terms_.end(),
                     [](const Monomial* a, const Monomial* b) { return a->size() < b->size(); });
    choose({}, 0);
  }

  const std::vector<Zeros>& found() const { return found_; }

 private:
  void choose(const Zeros& zeros, std::size_t first) {
    constexpr std::size_t kMostChoices = 20'000;
    if (zeros.size() >= unknowns_ || ++choices_ > kMostChoices) return;
    while (first < terms_.size() && has_zero_factor(*terms_[first], zeros)) ++first;
    if (first == terms_.size()) {
      found_.push_back(zeros);
      return;
    }
    for (const Power& factor : *terms_[first]) choose(with(zeros, factor.variable), first + 1);
  }

  std::size_t unknowns_;
  std::vector<const Monomial*> terms_;
  std::size_t choices_ = 0;
  std::vector<Zeros> found_;
};

bool lies_in_another(const Zeros& zeros, const std::vector<Zeros>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Zeros& fewer) {
    return fewer.size() < zeros.size() &&
           std::includes(zeros.begin(), zeros.end(), fewer.begin(), fewer.end());
  });
}

}  // namespace

Polynomial on_plane(const Polynomial& p, const std::vector<std::uint32_t>& zeros) {
  Polynomial left;
  for (const Term& term : p.terms) {
    if (!has_zero_factor(term.monomial, zeros)) left.terms.push_back(term);
  }
  return left;
}

std::uint64_t plane_dimension(const System& f, const std::vector<std::uint32_t>& zeros) {
  std::uint64_t dimension = f.variables.size() - zeros.size();
  for (const VariableGroup& group : f.groups) {
    if (!group.is_homogeneous) continue;
    // No point of a projective space.
    if (std::includes(zeros.begin(), zeros.end(), group.variables.begin(), group.variables.end())) {
      return 0;
    }
    --dimension;
  }
  return dimension;
}

std::vector<std::string> zero_names(const CoordinatePlane& plane,
                                    const std::vector<std::string>& variables) {
  std::vector<std::string> names;
  for (const std::uint32_t j : plane.zeros) names.push_back(variables[j]);
  return names;
}

std::vector<CoordinatePlane> coordinate_planes(const System& f) {
  std::vector<Zeros> found = Choices(f).found();
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<CoordinatePlane> planes;
  for (const Zeros& zeros : found) {
    const std::uint64_t dimension = plane_dimension(f, zeros);
    const bool is_barred =
        std::any_of(f.denominators.begin(), f.denominators.end(),
                    [&](const Polynomial& d) { return on_plane(d, zeros).terms.empty(); });
    if (dimension == 0 || zeros.empty() || is_barred || lies_in_another(zeros, found)) continue;
    planes.push_back({zeros, dimension});
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const auto& a, const auto& b) { return a.dimension > b.dimension; });
  return planes;
}

}  // namespace moivre

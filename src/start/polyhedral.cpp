// SPDX-License-Identifier: MIT
// The generic member of a support, and the toric start points and weights of each path.
#include "moivre/start/polyhedral.h"

#include <algorithm>
#include <cmath>

#include "exact_coefficient.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/scale.h"
#include "moivre/start/binomial.h"
#include "moivre/start/cell_geometry.h"
#include "moivre/start/path_index.h"

namespace moivre {
namespace {

// Where a path begins, the terms that its binomials leave out are at most this relative to them:
// Newton's method begins there.
constexpr double kLeastPart = 1e-4;
// Of the lifting: ties are rare, slacks stay within 64 bits; random parts of up to four binary
// orders of magnitude.
constexpr double kLiftingUnit = 0x1p20;
constexpr double kRandomPart = 4;
constexpr std::uint64_t kMostCoefficientLiftings = 8;

double modulus_of(const Coefficient& c) { return is_zero(c) ? 1 : std::exp2(log2_size(c)); }

/// Number by number of all terms, in the order of the supports.
std::vector<Complex> generic_coefficients(const System& f, const std::vector<Support>& supports,
                                          std::uint64_t seed) {
  std::vector<Complex> g;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const std::vector<Term>& own = f.polynomials[i].terms;
    for (std::size_t k = 0; k < supports[i].terms.size(); ++k) {
      const double modulus = k < own.size() ? modulus_of(own[k].coefficient) : 1;
      g.push_back(modulus * random_phase(seed, RandomStream::generic_member, g.size()));
    }
  }
  return g;
}

/// -log2 of the coefficients' moduli and random numbers in [0, kRandomPart), in units of 1 /
/// kLiftingUnit.
Lifting coefficient_lifting(const System& f, const std::vector<Support>& supports,
                            std::uint64_t seed, std::uint64_t attempt) {
  std::uint64_t index = attempt << 48;  // terms are fewer
  Lifting lifting;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const std::vector<Term>& own = f.polynomials[i].terms;
    std::vector<std::int64_t>& block = lifting.emplace_back();
    for (std::size_t k = 0; k < supports[i].terms.size(); ++k) {
      const double size = k < own.size() ? log2_size(own[k].coefficient) : 0;
      const double part =
          kRandomPart * random_unit(seed, RandomStream::coefficient_lifting, index++);
      block.push_back(std::llround(kLiftingUnit * (part - size)));
    }
  }
  return lifting;
}

Monomial monomial_of(const Exponents& exponents) {
  Monomial m;
  for (std::uint32_t j = 0; j < exponents.size(); ++j) {
    if (exponents[j] > 0) m.push_back({j, exponents[j]});
  }
  return m;
}

System generic_member(const System& f, const std::vector<Support>& supports,
                      const std::vector<Complex>& g) {
  System member{f.variables, {}};
  auto next = g.begin();
  for (const Support& support : supports) {
    Polynomial& p = member.polynomials.emplace_back();
    for (const Exponents& exponents : support.terms) {
      p.terms.push_back({exact_coefficient(*next++), monomial_of(exponents)});
    }
  }
  return member;
}

class PolyhedralPoints : public StartPoints {
 public:
  PolyhedralPoints(Homotopy toric, MixedSubdivision cells, std::vector<Complex> g)
      : toric_(std::move(toric)),
        cells_(std::move(cells)),
        index_(make_path_index(cells_.cells)),
        g_(std::move(g)) {}

  std::uint64_t paths() const { return index_.paths(); }

  StartPoint at(std::uint64_t path) const override {
    const StartRoot root = start_root(index_, path);
    const MixedCell& cell = cells_.cells[root.cell];
    const BinomialSystem binomials = binomial_system(cells_, cell, g_);
    Point x = binomial_root(binomials, root.root);
    x.push_back(1);
    auto frame = std::make_shared<PathFrame>(frame_at(toric_, x));
    frame->weights = cell_weights(cells_, cell);
    const double span = toric_span(cell, binomials.log_modulus, frame->weights);
    for (double& w : frame->weights) w *= span;
    x = inside(frame, std::move(x));
    return {std::move(x), std::move(frame)};
  }

 private:
  // T: log |term k| - log |binomial's terms| - w_k T <= log kLeastPart for all terms that the
  // binomials leave out.
  double toric_span(const MixedCell& cell, const std::vector<double>& log_modulus,
                    const std::vector<double>& weights) const {
    double span = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < cells_.supports.size(); ++i) {
      const std::vector<Exponents>& terms = cells_.supports[i].terms;
      const auto size = [&](std::size_t k) {
        double log_size = std::log(std::abs(g_[next + k]));
        for (std::size_t j = 0; j < terms[k].size(); ++j) {
          log_size += static_cast<double>(terms[k][j]) * log_modulus[j];
        }
        return log_size;
      };
      const double binomial = size(cell.edges[i][0]);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        if (weights[next + k] == 0) continue;
        span = std::max(span, (size(k) - binomial - std::log(kLeastPart)) / weights[next + k]);
      }
      next += terms.size();
    }
    return span;
  }

  Homotopy toric_;
  MixedSubdivision cells_;
  PathIndex index_;
  std::vector<Complex> g_;
};

}  // namespace

std::vector<Support> start_supports(const System& f) {
  return with_origin(supports_of(f), f.variables.size()).supports;
}

CellSearch start_cells(const System& f, std::uint64_t seed, const CellSearchOptions& options) {
  const std::vector<Support> supports = start_supports(f);
  CellSearch search;
  for (std::uint64_t attempt = 0; attempt < kMostCoefficientLiftings; ++attempt) {
    const Lifting lifting = coefficient_lifting(f, supports, seed, attempt);
    search = mixed_cells_of_lifting(supports, lifting, seed, options);
    if (search.end != CellSearchEnd::not_generic) return search;
  }
  return mixed_cells(supports, seed, options);
}

StartPlan polyhedral_plan(const System& f, MixedSubdivision cells, std::uint64_t seed) {
  std::vector<Complex> coefficients = generic_coefficients(f, cells.supports, seed);
  const System g = generic_member(f, cells.supports, coefficients);
  const Homotopy toric = Homotopy::toric(g);
  auto points =
      std::make_shared<PolyhedralPoints>(toric, std::move(cells), std::move(coefficients));
  StartPlan plan{StartSource::polyhedral, points->paths(), {}, points};
  plan.stages.push_back(toric);
  plan.stages.push_back(Homotopy::framed(f, g));
  return plan;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Quadrics restricted to what linear equations leave, until a formula has their roots; Newton's
// method on the equations as they are.
#include "quadratic_block.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "moivre/factorization/lu.h"
#include "moivre/start/multihomogeneous.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

// Beside the sum of what was added, some roundings: nothing else is left.
constexpr double kNothing = 1e-14;
// Beside the same, enough to divide by, and to be told from nothing.
constexpr double kClear = 1e-6;
// Of the discriminant, beside its terms: nearer roots are left to a solve, which knows double ones.
constexpr double kApart = 1e-8;
// Worse conditioned roots are left to a solve too.
constexpr double kWellConditioned = 1e6;
// The formula has at least this many digits right; each correction doubles them.
constexpr double kNear = 1e-7;
constexpr int kCorrections = 4;
constexpr double kUnitRoundoff = 0x1p-53;
// Of the largest coordinate: a part smaller than a thousandth of its last digit is 0.
constexpr double kTiny = 1e-3 * kUnitRoundoff;

struct Quadric {
  MatrixXcd M;
  MatrixXd S;
  bool has_pivot = false;  ///< it takes a term out of the others, and stays as it is

  Index unknowns() const { return M.rows() - 1; }
};

struct Reduced {
  std::vector<Quadric> quadrics;
  MatrixXcd T;
};

enum class Highest {
  none,     ///< a linear equation
  clear,    ///< there are quadratic terms
  unclear,  ///< small ones, that may be rounding or not
};

/// Sets to 0 what is rounding among the quadratic terms.
Highest settle(Quadric& q) {
  Highest highest = Highest::none;
  for (Index j = 0; j < q.unknowns(); ++j) {
    for (Index i = 0; i <= j; ++i) {
      const double size = std::abs(q.M(i, j));
      if (size <= kNothing * q.S(i, j)) {
        q.M(i, j) = q.M(j, i) = 0;
      } else if (size <= kClear * q.S(i, j)) {
        return Highest::unclear;
      } else {
        highest = Highest::clear;
      }
    }
  }
  return highest;
}

/// A P, where P [x; 1] puts share [x; 1] in as number `pivot`: that column's shares are added to
/// the others.
template <class Matrix, class Vector>
Matrix with_column_shared(const Matrix& A, Index pivot, const Vector& share) {
  Matrix B(A.rows(), A.cols() - 1);
  for (Index j = 0; j < B.cols(); ++j) {
    const Index from = j < pivot ? j : j + 1;
    for (Index i = 0; i < B.rows(); ++i) B(i, j) = A(i, from) + A(i, pivot) * share[j];
  }
  return B;
}

/// P^T M P of a symmetric M.
template <class Matrix, class Vector>
Matrix restricted(const Matrix& M, Index pivot, const Vector& share) {
  const Matrix half = with_column_shared(M, pivot, share);
  return with_column_shared(Matrix(half.transpose()), pivot, share);
}

/// Solves the linear equation for its largest unknown and puts that in everywhere. False where none
/// is large enough.
bool substitute(const Quadric& linear, Reduced& all) {
  const Index k = linear.unknowns();
  Index pivot = 0;
  linear.M.col(k).head(k).cwiseAbs().maxCoeff(&pivot);
  const Complex a = linear.M(pivot, k);
  if (!(std::abs(a) > kClear * linear.S(pivot, k))) return false;
  // y_pivot = share [y without the pivot; 1]; the constant stands in M once, the other entries of
  // the row twice.
  VectorXcd share(k);
  for (Index i = 0; i < k; ++i) {
    const Index from = i < pivot ? i : i + 1;
    share[i] = -linear.M(from, k) / a * (from == k ? 0.5 : 1.0);
  }
  all.T = with_column_shared(all.T, pivot, share);
  for (Quadric& q : all.quadrics) {
    q.M = restricted(q.M, pivot, share);
    q.S = restricted(q.S, pivot, share.cwiseAbs());
    q.has_pivot = false;
  }
  return true;
}

/// Takes the largest quadratic term of an equation out of the others. False where each has taken
/// one.
bool combine(std::vector<Quadric>& quadrics) {
  const auto pivot =
      std::find_if(quadrics.begin(), quadrics.end(), [](const Quadric& q) { return !q.has_pivot; });
  if (pivot == quadrics.end()) return false;
  pivot->has_pivot = true;
  const Index k = pivot->unknowns();
  Index i = 0;
  Index j = 0;
  pivot->M.topLeftCorner(k, k).cwiseAbs().maxCoeff(&i, &j);
  for (Quadric& q : quadrics) {
    if (&q == &*pivot || q.has_pivot || q.M(i, j) == Complex(0)) continue;
    const Complex share = q.M(i, j) / pivot->M(i, j);
    q.M -= share * pivot->M;
    q.S += std::abs(share) * pivot->S;
    q.M(i, j) = q.M(j, i) = 0;
  }
  return true;
}

/// With at most one unknown and one equation left; nullopt where it does not come to that.
std::optional<Reduced> reduced(std::vector<Quadric> quadrics, Index n) {
  Reduced all{std::move(quadrics), MatrixXcd::Identity(n + 1, n + 1)};
  while (!all.quadrics.empty()) {
    std::optional<std::size_t> linear;
    for (std::size_t e = 0; e < all.quadrics.size() && !linear; ++e) {
      const Highest highest = settle(all.quadrics[e]);
      if (highest == Highest::unclear) return std::nullopt;
      if (highest == Highest::none) linear = e;
    }
    if (linear) {
      const Quadric equation = std::move(all.quadrics[*linear]);
      all.quadrics.erase(all.quadrics.begin() + static_cast<std::ptrdiff_t>(*linear));
      // The last unknown's square may cancel by chance alone: its other root is far away then, not
      // absent.
      const Index k = equation.unknowns();
      if (k == 0 || (k == 1 && equation.S(0, 0) > 0) || !substitute(equation, all)) {
        return std::nullopt;
      }
    } else if (all.T.cols() == 2) {
      return all;
    } else if (!combine(all.quadrics)) {
      return std::nullopt;
    }
  }
  return all;
}

/// Of M_00 y^2 + 2 M_01 y + M_11, where they are apart.
std::optional<std::vector<Complex>> roots_of(const Quadric& q) {
  const Complex a = q.M(0, 0);
  const Complex b = q.M(0, 1);
  const Complex c = q.M(1, 1);
  const Complex discriminant = b * b - a * c;
  if (!(std::abs(discriminant) > kApart * (std::norm(b) + std::abs(a * c)))) return std::nullopt;
  const Complex root = std::sqrt(discriminant);
  // The sum of two numbers on one side does not cancel.
  const Complex far = -(b + ((std::conj(b) * root).real() < 0 ? -root : root));
  return std::vector<Complex>{far / a, c / far};
}

void snap_to_zero(Point& x) {
  const double tiny = kTiny * max_norm(x);
  for (Complex& xi : x) {
    if (std::abs(xi.real()) <= tiny) xi.real(0);
    if (std::abs(xi.imag()) <= tiny) xi.imag(0);
  }
}

/// The total degree, or the multihomogeneous number of these groups where that is less.
std::uint64_t bound_of(const System& f, const Partition& groups) {
  const std::uint64_t total = total_degree(degrees(f)).value_or(0);
  return std::min(total, multihomogeneous_number(f, groups).value_or(total));
}

double weight(Index i, Index j) { return i == j ? 1 : 0.5; }

}  // namespace

QuadraticBlock::QuadraticBlock(const Formulation& f, const Block& block)
    : n_(static_cast<Index>(block.variables.size())) {
  System own;  // in the block's unknowns, whatever the others are
  std::map<std::size_t, std::uint32_t> place;
  Partition halves(2);
  for (const std::size_t v : block.variables) {
    const auto k = static_cast<std::uint32_t>(place.size());
    place.emplace(v, k);
    own.variables.push_back(f.system.variables[v]);
    halves[v <= f.mirror[v] ? 0 : 1].push_back(k);
  }
  std::erase_if(halves, [](const auto& half) { return half.empty(); });
  for (const std::size_t e : block.equations) {
    Equation equation;
    TermMap terms;
    for (const Term& term : f.system.polynomials[e].terms) {
      Product product{to_complex_double_double(term.coefficient), {}, n_, n_};
      Monomial monomial;
      for (const Power& power : term.monomial) {
        const auto k = place.find(power.variable);
        if (k == place.end()) {
          product.known.push_back(power);
          continue;
        }
        monomial.push_back({k->second, power.exponent});
        (product.i == n_ ? product.i : product.j) = static_cast<Index>(k->second);
        if (power.exponent > 1) product.j = static_cast<Index>(k->second);
      }
      terms.emplace(std::move(monomial), Coefficient{1, 0});
      equation.push_back(std::move(product));
    }
    own.polynomials.push_back(to_polynomial(std::move(terms)));
    is_quadratic_ = is_quadratic_ && degree(own.polynomials.back()) <= 2;
    equations_.push_back(std::move(equation));
  }
  if (is_quadratic_) bound_ = bound_of(own, halves);
}

std::vector<QuadraticBlock::Equation> QuadraticBlock::equations_at(
    const std::vector<KnownValue>& values) const {
  std::map<std::uint32_t, ComplexDoubleDouble> rounded;
  std::vector<Equation> equations = equations_;
  for (Equation& equation : equations) {
    for (Product& term : equation) {
      for (const Power& power : term.known) {
        const auto [at, is_new] = rounded.try_emplace(power.variable);
        if (is_new) at->second = to_complex_double_double(values[power.variable]->exact);
        for (std::uint32_t k = 0; k < power.exponent; ++k) term.c = product(term.c, at->second);
      }
    }
  }
  return equations;
}

std::optional<Solution> QuadraticBlock::refined(const std::vector<Equation>& equations,
                                                Point x) const {
  const auto n = static_cast<std::size_t>(n_);
  Lu lu(n);
  Point step(n);
  for (int k = 0; k < kCorrections; ++k) {
    std::vector<ComplexDoubleDouble> fine(x.begin(), x.end());
    fine.emplace_back(1.0);
    std::fill(lu.matrix().begin(), lu.matrix().end(), Complex(0));
    for (std::size_t e = 0; e < n; ++e) {
      ComplexDoubleDouble value;
      for (const Product& term : equations[e]) {
        const auto i = static_cast<std::size_t>(term.i);
        const auto j = static_cast<std::size_t>(term.j);
        const ComplexDoubleDouble by_i = product(term.c, fine[j]);
        value += product(by_i, fine[i]);
        if (i < n) lu.matrix()[e * n + i] += to_complex(by_i);
        if (j < n) lu.matrix()[e * n + j] += i < n ? to_complex(term.c) * x[i] : to_complex(term.c);
      }
      step[e] = -to_complex(value);
    }
    if (!lu.factor()) return std::nullopt;
    lu.solve(step);
    const double size = std::max(1.0, max_norm(x));
    const double moved = max_norm(step) / size;
    if (!(moved <= kNear)) return std::nullopt;
    // Two corrections at least, so that what is small beside the others is known to its own last
    // digit.
    if (k >= 2 && moved <= 2 * kUnitRoundoff) {
      Solution solution;
      solution.condition = lu.condition();
      solution.accuracy = 2 * moved + kUnitRoundoff;
      snap_to_zero(x);
      solution.x = std::move(x);
      if (!(solution.condition <= kWellConditioned)) return std::nullopt;
      return solution;
    }
    for (std::size_t i = 0; i < n; ++i) x[i] += step[i];
  }
  return std::nullopt;
}

std::optional<std::vector<Solution>> QuadraticBlock::roots(
    const std::vector<KnownValue>& values) const {
  if (!is_quadratic_) return std::nullopt;
  const std::vector<Equation> equations = equations_at(values);
  std::vector<Quadric> quadrics;
  for (const Equation& equation : equations) {
    Quadric q{MatrixXcd::Zero(n_ + 1, n_ + 1), MatrixXd::Zero(n_ + 1, n_ + 1)};
    for (const Product& term : equation) {
      const Complex c = weight(term.i, term.j) * to_complex(term.c);
      q.M(term.i, term.j) += c;
      q.S(term.i, term.j) += std::abs(c);
      if (term.i == term.j) continue;
      q.M(term.j, term.i) += c;
      q.S(term.j, term.i) += std::abs(c);
    }
    quadrics.push_back(std::move(q));
  }
  const std::optional<Reduced> all = reduced(std::move(quadrics), n_);
  if (!all) return std::nullopt;
  std::vector<VectorXcd> starts;
  if (all->quadrics.empty()) {
    starts.emplace_back(all->T.col(0));
  } else {
    const auto formula = roots_of(all->quadrics.front());
    if (!formula) return std::nullopt;
    for (const Complex& y : *formula) starts.emplace_back(all->T * Eigen::Vector2cd(y, 1));
  }
  std::vector<Solution> found;
  for (const VectorXcd& start : starts) {
    auto solution = refined(equations, Point(start.begin(), start.begin() + n_));
    if (!solution) return std::nullopt;
    solution->path = found.size();
    found.push_back(std::move(*solution));
  }
  return found;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Polynomials in numbers a + b sqrt(s), their derivatives, and Newton's method on them.
#include "pair_equations.h"

#include <algorithm>
#include <cmath>

#include "moivre/factorization/lu.h"

namespace moivre {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kNoPlace = static_cast<std::size_t>(-1);
// Corrections shrink by squares; what shrinks less began too far away.
constexpr int kPairCorrections = 8;
constexpr double kPairShrinks = 0.5;
// Beside |y|: the next correction, known before it is made, that need not be made.
constexpr double kPairConverged = 1e-12;
// Beside |y|: of this size corrections are rounding, and shrink no more.
constexpr double kPairRounding = 1e-10;

/// a + b e, e^2 = s, with the derivatives of a and b by s.
template <class S>
struct RootNumber {
  S a;
  S b;
  S a_s = 0.0;
  S b_s = 0.0;
};

template <class S>
RootNumber<S> times(const RootNumber<S>& x, const RootNumber<S>& y, const S& s) {
  const S bb = product(x.b, y.b);
  return {product(x.a, y.a) + product(s, bb), product(x.a, y.b) + product(x.b, y.a),
          product(x.a_s, y.a) + product(x.a, y.a_s) + bb +
              product(s, product(x.b_s, y.b) + product(x.b, y.b_s)),
          product(x.a_s, y.b) + product(x.a, y.b_s) + product(x.b_s, y.a) + product(x.b, y.a_s)};
}

/// Of all factors but one; of all where `skip` is none of them.
template <class S>
RootNumber<S> product_without(const std::vector<RootNumber<S>>& factors, std::size_t skip,
                              const S& s) {
  std::size_t k = skip == 0 ? 1 : 0;
  if (k >= factors.size()) return {1.0, 0.0};
  RootNumber<S> rest = factors[k];
  while (++k < factors.size()) {
    if (k != skip) rest = times(rest, factors[k], s);
  }
  return rest;
}

/// The blocks that a block needs, with those of mirror images, in their order.
std::vector<std::size_t> needed_blocks(const Formulation& formulation,
                                       const std::vector<Block>& blocks, std::size_t block) {
  std::vector<std::size_t> owner(formulation.system.variables.size(), kNoPlace);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    for (const std::size_t v : blocks[k].variables) owner[v] = k;
  }
  std::vector<bool> is_needed(blocks.size(), false);
  is_needed[block] = true;
  const auto need = [&](std::size_t variable) {
    if (owner[variable] != kNoPlace) is_needed[owner[variable]] = true;
  };
  // Blocks need earlier ones only; a mirror image may be later by a few.
  for (std::size_t before = 0, now = 1; now != before;) {
    before = now;
    for (std::size_t k = blocks.size(); k-- > 0;) {
      if (!is_needed[k]) continue;
      for (const std::size_t v : blocks[k].variables) need(formulation.mirror[v]);
      for (const std::size_t e : blocks[k].equations) {
        for (const Term& term : formulation.system.polynomials[e].terms) {
          for (const Power& power : term.monomial) need(power.variable);
        }
      }
    }
    now = static_cast<std::size_t>(std::count(is_needed.begin(), is_needed.end(), true));
  }
  std::vector<std::size_t> needed;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (is_needed[k] && k != block) needed.push_back(k);
  }
  return needed;
}

}  // namespace

struct PairEquations::Linearized {
  explicit Linearized(Index n) : lu(static_cast<std::size_t>(n + 1)) {}

  Eigen::Map<RowMatrix> jacobian() {
    const auto size = static_cast<Index>(lu.size());
    return {lu.matrix().data(), size, size};
  }
  /// Of n + 1 equations; once factored.
  PairVector solved(PairVector b) {
    lu.solve({b.data(), lu.size()});
    return b;
  }

  PairVector value;  ///< n
  Lu lu;             ///< of the derivatives; the last row is the caller's
};

PairEquations::PairEquations(const MovingPolynomials& polynomials, const std::vector<Block>& blocks,
                             std::size_t block, double from, double to)
    : polynomials_(polynomials), from_(from), duration_(to - from) {
  const Formulation& f = polynomials.formulation();
  place_.assign(f.system.variables.size(), kNoPlace);
  std::vector<std::size_t> all = needed_blocks(f, blocks, block);
  all.push_back(block);
  for (const std::size_t k : all) {
    if (k == block) needed_ = variables_.size();
    for (const std::size_t v : blocks[k].variables) {
      place_[v] = variables_.size();
      variables_.push_back(static_cast<std::uint32_t>(v));
    }
    rows_.insert(rows_.end(), blocks[k].equations.begin(), blocks[k].equations.end());
  }
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const std::size_t image = place_[f.mirror[variables_[k]]];
    has_mirror_ = has_mirror_ && image != kNoPlace && (image < needed_) == (k < needed_);
    mirror_.push_back(static_cast<Index>(image));
  }
}

Point PairEquations::restricted(const Point& root) const {
  Point x;
  for (const std::uint32_t v : variables_) x.push_back(root[v] / polynomials_.units()[v]);
  return x;
}

Point PairEquations::image(const Point& x) const {
  Point image(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    image[k] = std::conj(x[static_cast<std::size_t>(mirror_[k])]);
  }
  return image;
}

PairVector PairEquations::point(const Point& x, double tau) const {
  const Point other = image(x);
  PairVector y = PairVector::Zero(size() + 1);
  for (std::size_t k = 0; k < x.size(); ++k) {
    y[static_cast<Index>(k)] = (x[k] + other[k]) / 2.0;
    if (k < needed_) continue;
    // sqrt(s) = i: u is real in the mirror's sense.
    y[first_u() + static_cast<Index>(k - needed_)] = (x[k] - other[k]) / Complex(0, 2);
  }
  y[at_s()] = -1;
  y[at_tau()] = tau;
  return normalized(y);
}

std::array<Point, 2> PairEquations::roots(const PairVector& y) const {
  const Complex root = std::sqrt(Complex(y[at_s()].real(), 0));
  std::array<Point, 2> both;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      Complex x = y[static_cast<Index>(k)];
      if (k >= needed_) {
        x += (side == 0 ? root : -root) * y[first_u() + static_cast<Index>(k - needed_)];
      }
      both[side].push_back(x);
    }
  }
  return both;
}

PairVector PairEquations::without_u_and_s(PairVector y) const {
  y.segment(first_u(), own() + 1).setZero();
  return y;
}

PairVector PairEquations::normalized(PairVector y) const {
  const double length = y.segment(first_u(), own()).norm();
  y.segment(first_u(), own()) /= length;
  y[at_s()] *= length * length;
  return y;
}

/// What rounding took away from the real structure is put back.
PairVector PairEquations::made_real(const PairVector& y) const {
  PairVector real = y;
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const auto at = static_cast<Index>(k);
    real[at] = (y[at] + std::conj(y[mirror_[k]])) / 2.0;
    if (k < needed_) continue;
    const Index shift = first_u() - static_cast<Index>(needed_);
    real[at + shift] = (y[at + shift] + std::conj(y[mirror_[k] + shift])) / 2.0;
  }
  real[at_s()] = y[at_s()].real();
  real[at_tau()] = y[at_tau()].real();
  return real;
}

bool PairEquations::linearize(const PairVector& y, const PairVector& base, Linearized& to) const {
  const auto moving = polynomials_.at(time(y[at_tau()].real()), rows_);
  if (!moving) return false;
  const Index n = size();
  const Complex s = y[at_s()];
  to.value = PairVector::Zero(n);
  auto J = to.jacobian();
  J.setZero();
  const auto needed = static_cast<Index>(needed_);
  std::vector<RootNumber<Complex>> factors;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto row_a = static_cast<Index>(r);
    const Index row_b = r < needed_ ? Index{-1} : row_a + own();
    for (const MovingPolynomials::MovingTerm& term : polynomials_.rows()[rows_[r]]) {
      factors.clear();
      for (const std::uint32_t v : term.factors) {
        const std::size_t k = place_[v];
        const auto place = static_cast<Index>(k);
        factors.push_back({y[place], k < needed_ ? Complex(0) : y[first_u() + place - needed]});
      }
      const Complex c = moving->c[term.number];
      for (std::size_t skip = 0; skip <= factors.size(); ++skip) {
        const RootNumber<Complex> rest = product_without(factors, skip, s);
        const Complex a = product(c, rest.a);
        const Complex b = product(c, rest.b);
        if (skip == factors.size()) {
          const Complex rate = moving->rate[term.number] * duration_;
          to.value[row_a] += a;
          J(row_a, at_s()) += product(c, rest.a_s);
          J(row_a, at_tau()) += product(rate, rest.a);
          if (row_b < 0) continue;
          to.value[row_b] += b;
          J(row_b, at_s()) += product(c, rest.b_s);
          J(row_b, at_tau()) += product(rate, rest.b);
          continue;
        }
        const auto place = static_cast<Index>(place_[term.factors[skip]]);
        const Index u = first_u() + place - needed;
        J(row_a, place) += a;
        if (place >= needed) J(row_a, u) += product(s, b);
        if (row_b < 0) continue;
        J(row_b, place) += b;
        if (place >= needed) J(row_b, u) += a;
      }
    }
  }
  const auto u0 = base.segment(first_u(), own());
  to.value[n - 1] = u0.dot(y.segment(first_u(), own())) - 1.0;
  J.row(n - 1).segment(first_u(), own()) = u0.adjoint();
  // Derivatives that are not finite make steps that are not. To look at all of them takes as long
  // as to compute them.
  return to.value.allFinite();
}

std::optional<PairPoint> PairEquations::corrected(PairVector y, const PairVector& base,
                                                  const PairVector& normal, double offset,
                                                  const PairVector& before) const {
  double last = 0;
  Linearized here(size());
  for (int k = 0; k < kPairCorrections; ++k) {
    if (!linearize(y, base, here)) return std::nullopt;
    here.jacobian().row(size()) = normal.adjoint();
    PairVector miss(size() + 1);
    miss << -here.value, offset - normal.dot(y);
    if (!here.lu.factor()) return std::nullopt;
    const PairVector step = here.solved(std::move(miss));
    const double length = step.norm();
    const bool is_rounding = k > 0 && length <= kPairRounding * y.norm();
    const bool began_too_far = k > 0 && length > kPairShrinks * last && !is_rounding;
    if (!std::isfinite(length) || began_too_far) return std::nullopt;
    y += step;
    const double ratio = k > 0 ? length / last : 1;
    last = length;
    // By quadratic convergence the next one is length * ratio^2.
    if (length * ratio * ratio > kPairConverged * y.norm() && !is_rounding) continue;
    const PairVector along = made_real(here.solved(PairVector::Unit(size() + 1, size())));
    const double way = before.dot(along).real() < 0 ? -along.norm() : along.norm();
    if (!std::isfinite(way) || way == 0) return std::nullopt;
    return PairPoint{made_real(y), along / way};
  }
  return std::nullopt;
}

/// Newton's method with the derivatives in double: each step brings their digits.
std::optional<double> PairEquations::sharp_s(const PairVector& y) const {
  constexpr int kMostRounds = 8;
  constexpr double kSharp = 1e-26;
  const auto c = polynomials_.sharply_at(time(y[at_tau()].real()), rows_);
  Linearized here(size());
  if (!c || !linearize(y, y, here)) return std::nullopt;
  here.jacobian().row(size()) = PairVector::Unit(size() + 1, at_tau()).adjoint();
  if (!here.lu.factor()) return std::nullopt;
  std::vector<ComplexDoubleDouble> sharp(y.begin(), y.end());
  const auto needed = static_cast<Index>(needed_);
  for (int round = 0; round < kMostRounds; ++round) {
    PairVector miss = PairVector::Zero(size() + 1);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      ComplexDoubleDouble a;
      ComplexDoubleDouble b;
      for (const MovingPolynomials::MovingTerm& term : polynomials_.rows()[rows_[r]]) {
        RootNumber<ComplexDoubleDouble> whole{(*c)[term.number], 0.0};
        for (const std::uint32_t v : term.factors) {
          const std::size_t k = place_[v];
          RootNumber<ComplexDoubleDouble> factor{sharp[k], 0.0};
          if (k >= needed_) factor.b = sharp[k + variables_.size() - needed_];
          whole = times(whole, factor, sharp[static_cast<std::size_t>(at_s())]);
        }
        a += whole.a;
        b += whole.b;
      }
      const auto row = static_cast<Index>(r);
      miss[row] = -to_complex(a);
      if (row >= needed) miss[row + own()] = -to_complex(b);
    }
    ComplexDoubleDouble along = -1.0;
    for (Index k = first_u(); k < first_u() + own(); ++k) {
      along += product(ComplexDoubleDouble(std::conj(y[k])), sharp[static_cast<std::size_t>(k)]);
    }
    miss[size() - 1] = -to_complex(along);
    const PairVector step = here.solved(std::move(miss));
    for (Index k = 0; k < size(); ++k) sharp[static_cast<std::size_t>(k)] += step[k];
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() <= kSharp * y.norm()) {
      return to_complex(sharp[static_cast<std::size_t>(at_s())]).real();
    }
  }
  return std::nullopt;
}

}  // namespace moivre

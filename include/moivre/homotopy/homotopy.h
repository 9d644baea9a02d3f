// SPDX-License-Identifier: MIT
// How does the start system become the target? H(x, t) = t F(x) + (1 - t) G(x), in projective coordinates.
//
//   F, G: n polynomials in n variables, each pair F_i, G_i homogenized to one degree (polynomial/homogenize.h)
//   x: N = n + 1 homogeneous coordinates, x_n = x_0 the homogenizing one;  t: complex
//   H: n,  H_x = t F_x + (1 - t) G_x: n x N,  H_t = F - G: n
//
// A path to infinity is a path to x_n = 0: it ends like any other. The randomness that keeps the paths apart
// for t in [0, 1) is in G's coefficients (start/total_degree.h), the gamma trick. t is complex because an endgame
// walks circles around t = 1. The homotopy is immutable; every thread owns an evaluator.
// Source: [Morgan87, ch. 1 and 3], [SommeseWampler05, ch. 3 and 8].
#pragma once

#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "moivre/numeric/scalar.h"
#include "moivre/polynomial/tape.h"

namespace moivre {

/// One side of a homotopy: a homogenized system and its tape.
struct HomotopySide {
  System system;
  Tape tape;
  bool real = false;  ///< all coefficients are real, and kept as such
};

class Homotopy {
 public:
  /// Throws std::invalid_argument when F and G are not both n polynomials in n variables.
  Homotopy(const System& f, const System& g);

  std::size_t equations() const { return target_.tape.equations; }
  std::size_t coordinates() const { return target_.tape.variables; }
  const HomotopySide& target() const { return target_; }
  const HomotopySide& start() const { return start_; }

 private:
  HomotopySide target_;
  HomotopySide start_;
};

/// t and 1 - t, the weights of F and G. Near t = 1 the difference would lose the digits of 1 - t.
template <class S>
struct Time {
  Time(const S& value) : t(value), rest(S(1.0) - value) {}
  Time(const S& value, const S& one_minus_value) : t(value), rest(one_minus_value) {}

  S t;
  S rest;
};
using PathTime = Time<Complex>;

namespace detail {

/// A side with its coefficients rounded to S (or to S's reals) and the memory for evaluating it.
template <class S>
class SideEvaluator {
 public:
  using Real = typename Scalar<S>::Real;

  explicit SideEvaluator(const HomotopySide& side)
      : tape(side.tape),
        registers_(side.tape.register_count()),
        value(side.tape.equations),
        jacobian(side.tape.jacobian.size()) {
    if (side.real) {
      c_ = round_coefficients<Real>(tape, side.system, [](const Coefficient& c) {
        return Scalar<S>::round_real(c.re);
      });
    } else {
      c_ = round_coefficients<S>(tape, side.system, Scalar<S>::round);
    }
  }

  void evaluate_value(std::span<const S> x) {
    std::visit(
        [&](const auto& c) {
          using C = typename std::decay_t<decltype(c)>::value_type;
          evaluate<S, C>(tape, std::span<const C>(c), x, std::span<S>(registers_),
                         std::span<S>(value));
        },
        c_);
  }
  void evaluate_jacobian(std::span<const S> x) {
    std::visit(
        [&](const auto& c) {
          using C = typename std::decay_t<decltype(c)>::value_type;
          evaluate<S, C>(tape, std::span<const C>(c), x, std::span<S>(registers_),
                         std::span<S>(value), std::span<S>(jacobian));
        },
        c_);
  }

  const Tape& tape;

 private:
  std::vector<S> registers_;
  std::variant<std::vector<Real>, std::vector<S>> c_;

 public:
  std::vector<S> value;
  std::vector<S> jacobian;
};

}  // namespace detail

/// H and its derivatives at (x, t) in the scalar S. Owns its memory, allocates nothing after construction; one a thread.
template <class S>
class HomotopyEvaluator {
 public:
  explicit HomotopyEvaluator(const Homotopy& homotopy)
      : f_(homotopy.target()), g_(homotopy.start()) {}

  /// h <- H(x, t).
  void value(std::span<const S> x, const Time<S>& t, std::span<S> h) {
    f_.evaluate_value(x);
    g_.evaluate_value(x);
    blend_values(t, h);
  }

  /// h <- H, hx <- the n rows of H_x (row-major, N columns, so hx may be a taller matrix), ht <- H_t.
  void linearization(std::span<const S> x, const Time<S>& t, std::span<S> h, std::span<S> hx,
                     std::span<S> ht) {
    f_.evaluate_jacobian(x);
    g_.evaluate_jacobian(x);
    blend_values(t, h);
    for (std::size_t i = 0; i < ht.size(); ++i) ht[i] = f_.value[i] - g_.value[i];
    const std::size_t columns = f_.tape.variables;
    std::fill_n(hx.begin(), f_.tape.equations * columns, S(0.0));
    add_jacobian(f_, t.t, columns, hx);
    add_jacobian(g_, t.rest, columns, hx);
  }

 private:
  void blend_values(const Time<S>& t, std::span<S> h) const {
    for (std::size_t i = 0; i < f_.value.size(); ++i) {
      h[i] = product(t.t, f_.value[i]) + product(t.rest, g_.value[i]);
    }
  }
  static void add_jacobian(const detail::SideEvaluator<S>& side, const S& weight,
                           std::size_t columns, std::span<S> hx) {
    for (std::size_t k = 0; k < side.jacobian.size(); ++k) {
      const Tape::Entry& entry = side.tape.jacobian[k];
      hx[entry.row * columns + entry.column] += product(weight, side.jacobian[k]);
    }
  }

  detail::SideEvaluator<S> f_;
  detail::SideEvaluator<S> g_;
};

}  // namespace moivre

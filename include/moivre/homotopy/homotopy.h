// SPDX-License-Identifier: MIT
// How does one system become another? H(x, t) = sum_k c_k(t) x^{a_k}: one support, in projective
// coordinates, whose coefficients move.
//
//   straight     c_k(t) = t f_k + (1 - t) g_k           H = t F + (1 - t) G over the union of both
//                supports
//   toric        c_k(t) = g_k e^{-w_k (1 - t)}          w_k >= 0 the weights of one path, from the
//                cell that it comes from
//   parameters   c_k(t) = q_k((1 - t) p + t p')         q_k polynomials of a family's parameters, p
//                and p' two members; p' is the
//                                                       homotopy's, or every path's own
//
//   F, G: n polynomials in n variables, every equation homogenized to one degree
//   (polynomial/homogenize.h)
//   x: N = n + 1 homogeneous coordinates; which one is x_0, the homogenizing one, the chart knows;
//   t: complex
//   H: n,  H_x: n x N,  H_t: n
//
// A path to infinity is a path to x_0 = 0, and ends like any other. The randomness that keeps paths
// apart for t in [0, 1) is in G's coefficients (start/). t is complex because an endgame follows
// circles around t = 1. A framed homotopy differs from path to path: each path has its own units
// and, for the toric law, its own weights (homotopy/frame.h).
// Immutable; every thread owns an evaluator (homotopy/evaluator.h).
// Not supported: coefficients that are not polynomials of the parameters.
// Source: [Morgan87, ch. 1 and 3], [SommeseWampler05, ch. 3, 7 and 8], [HuberSturmfels95].
#pragma once

#include <optional>
#include <vector>

#include "moivre/homotopy/chart.h"
#include "moivre/homotopy/frame.h"
#include "moivre/homotopy/time.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/tape.h"

namespace moivre {

/// By which law the coefficients move.
enum class CoefficientLaw { straight, toric, parameters };

/// F(x; p) between two members: the coefficients as polynomials of the parameters, in the order of
/// the support's terms.
struct ParameterLaw {
  System coefficients;
  Tape tape;
  Point from;  ///< p at t = 0
  Point to;    ///< p at t = 1; empty: every path brings its own (PathFrame::member)

  const Point& target(const PathFrame* frame) const { return to.empty() ? frame->member : to; }
};

class Homotopy {
 public:
  /// t F + (1 - t) G. Throws std::invalid_argument when F and G are not both n polynomials in n
  /// variables.
  Homotopy(const System& f, const System& g);
  /// The same, followed by every path in a frame of its own.
  static Homotopy framed(const System& f, const System& g);
  /// G's toric homotopy, framed. Throws std::invalid_argument when G is not n polynomials in n
  /// variables.
  static Homotopy toric(const System& g);
  /// From F(x; p = from) to F(x; p = to). `family`: n polynomials in n unknowns and, after these,
  /// as many parameters as `from` and `to` have. Throws std::invalid_argument when the numbers do
  /// not fit.
  static Homotopy parameters(const System& family, const Point& from, const Point& to);
  /// From F(x; p = from) to as many members as there are paths: each brings its own in its frame.
  /// There are no f_k and g_k.
  static Homotopy members(const System& family, const Point& from);

  std::size_t equations() const { return tape_.equations; }
  std::size_t coordinates() const { return tape_.variables; }
  std::size_t terms() const { return g_.size(); }
  CoefficientLaw law() const { return law_; }
  bool is_framed() const { return is_framed_; }
  const Chart& chart() const { return chart_; }
  const Tape& tape() const { return tape_; }
  /// The union of the supports, homogenized, with the terms in the order of the affine polynomials.
  /// Its coefficients have no meaning.
  const System& support() const { return support_; }
  /// Of term k, counted over all equations: f_k and g_k, zero where a side has no such term.
  /// Between two members c_k at t = 1, and at t = 0 on the tangent there.
  const Coefficient& f(std::size_t k) const { return f_[k]; }
  const Coefficient& g(std::size_t k) const { return g_[k]; }
  /// What the errors of the file's numbers change in f_k, relative to it; none where it is exact or
  /// zero.
  const NumberErrors& errors(std::size_t k) const;
  /// The largest bound() of them.
  double largest_error() const;
  /// Of F's coefficients (polynomial/digits.h), or empty. Throws std::invalid_argument where they
  /// are not F's.
  void set_coefficient_errors(const CoefficientErrors& errors);
  /// log2 of the size of g_k, or of f_k where the start has no such term; of a framed homotopy
  /// only.
  double log2_size(std::size_t k) const { return log2_sizes_[k]; }
  /// The first term of equation i.
  std::size_t first_term(std::size_t i) const { return first_[i]; }
  const std::optional<ParameterLaw>& parameter_law() const { return parameters_; }

 private:
  Homotopy() = default;
  void set_support(const System& affine);

  CoefficientLaw law_ = CoefficientLaw::straight;
  bool is_framed_ = false;
  Chart chart_;
  System support_;
  Tape tape_;
  std::vector<std::size_t> first_;
  std::vector<Coefficient> f_;
  std::vector<Coefficient> g_;
  std::vector<NumberErrors> errors_;
  std::vector<double> log2_sizes_;
  std::optional<ParameterLaw> parameters_;
};

}  // namespace moivre

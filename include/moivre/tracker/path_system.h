// SPDX-License-Identifier: MIT
// What does the path look like near (x, t)? Newton corrections, tangent and condition from one
// factorization.
//
// The homotopy has n equations in N = n + 1 homogeneous coordinates; the last row is the natural
// patch of the point itself, x^H (.) = 0, so corrections and tangents are the shortest ones and |x|
// hardly changes:
//
//   J = [ H_x ]     J dx = [ -H ]    Newton correction         J x' = [ -H_t dt/ds ]   tangent
//       [ x^H ]            [  0 ]                                     [      0     ]
//
// J: N x N, rows scaled (factorization/lu.h). Corrections are measured by |dx|_w = max_i |dx_i| /
// w_i, w_i = max(|x_i|, kRelativeFloor |x|_inf): relative in each coordinate, with a floor.
//
// Where rounding of the residual stops Newton's method, H is evaluated in double-double from there
// on; x, J and its factors stay double. Corrections then contract until x itself is rounded, up to
// conditions near 1e14.
// Source: [ShubSmale93] for the patch, [Timme21, sec. 2] for the norm.
#pragma once

#include <memory>
#include <span>

#include "moivre/factorization/lu.h"
#include "moivre/homotopy/evaluator.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

/// Coordinates smaller than this fraction of the largest one count as being of that size.
inline constexpr double kRelativeFloor = 1e-5;

/// max_i |v_i| / max(|x_i|, kRelativeFloor |x|_inf); NaN where v or x is.
double weighted_norm(std::span<const Complex> v, std::span<const Complex> x);

struct CorrectorOptions {
  double tolerance = 1e-9;  ///< |dx|_w at which the point counts as on the path
  double largest_correction =
      0.1;  ///< |dx|_w of the first correction above which the point is refused
  double largest_contraction = 0.25;  ///< |dx_k+1|_w / |dx_k|_w above which Newton is refused
  double stagnation = 1e-6;           ///< |dx|_w that passes where rounding stops the contraction
  int maximum_iterations = 8;
  bool renews = false;  ///< J factored anew for every correction; the tangent is the last one's
  bool fine = false;    ///< residuals in double-double from the first one on
};

struct Correction {
  bool converged = false;
  double first = 0;     ///< |dx_1|_w, how far the point was from the path
  double last = 0;      ///< |dx_k|_w of the last correction
  double residual = 0;  ///< max_i |H_i| before the first correction
};

/// f_k and g_k of a homotopy in double-double.
struct FineEnds {
  std::vector<ComplexDoubleDouble> f, g;
};

class PathSystem {
 public:
  explicit PathSystem(const Homotopy& homotopy);

  std::size_t coordinates() const { return n_ + 1; }
  const Homotopy& homotopy() const { return definition_; }
  /// The correction that the last step of correct() took.
  std::span<const Complex> last_correction() const { return dx_; }

  /// The frame of the path that is looked at, where the homotopy is framed; it has to stay where it
  /// is.
  void set_frame(const PathFrame* frame) noexcept;

  /// Evaluates H, H_x, H_t at (x, t) and factors J. False when J is singular or something is not
  /// finite.
  bool linearize(std::span<const Complex> x, const PathTime& t) noexcept;

  /// dx <- J^{-1} [-H_t dt; 0] with the factors of the last linearize().
  void tangent(Complex dt, std::span<Complex> dx) noexcept;

  /// w <- J^{-H} w with the factors of the last linearize(): n + 1.
  void solve_adjoint(std::span<Complex> w) noexcept { lu_.solve_adjoint(w); }

  /// Newton from x at fixed t, x replaced. Simplified: the factors of the last linearize() serve as
  /// long as they contract;
  /// they are renewed once when they do not, and at the start when `fresh`. Where the options renew
  /// them for every correction, x is accepted where the next one would be within the tolerance.
  Correction correct(std::span<Complex> x, const PathTime& t, const CorrectorOptions& options,
                     bool fresh) noexcept;

  /// Condition number of J as it stands, from the last linearize(): it tells a vanishing row as
  /// well, so it grows wherever the path nears a singular point. Equations are to have coefficients
  /// near 1.
  double condition() noexcept { return lu_.unscaled_condition(); }

  /// The homotopy's coefficients; rounded when they are first asked for.
  const FineEnds& fine_ends();

  /// max_i |H_i| of the last evaluation.
  double residual() const noexcept;

  const WorkCount& work() const noexcept { return work_; }

 private:
  bool newton_step(std::span<Complex> x, double& size) noexcept;
  void evaluate_fine(std::span<const Complex> x, const PathTime& t) noexcept;

  const Homotopy& definition_;
  std::size_t n_;
  HomotopyEvaluator<Complex> homotopy_;
  const PathFrame* frame_ = nullptr;
  Lu lu_;
  std::vector<Complex> h_;
  std::vector<Complex> ht_;
  std::vector<Complex> dx_;
  std::vector<double> weights_;
  /// In double-double; made when it is first needed.
  struct Fine {
    explicit Fine(const Homotopy& h) : homotopy(h), x(h.coordinates()), value(h.equations()) {}
    HomotopyEvaluator<ComplexDoubleDouble> homotopy;
    std::vector<ComplexDoubleDouble> x;
    std::vector<ComplexDoubleDouble> value;
  };
  std::unique_ptr<Fine> fine_;
  std::unique_ptr<const FineEnds> fine_ends_;
  WorkCount work_;
};

}  // namespace moivre

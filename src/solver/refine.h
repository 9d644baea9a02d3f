// SPDX-License-Identifier: MIT
// How exactly is a root known? Newton's method on the system as given, to the last digit of double.
//
// Residuals are evaluated in double-double from the exact coefficients, the Jacobian in double: the
// correction dx = -J^{-1} F(x) then tells the true error as long as J is not singular to working
// precision. A root is called simple when Newton contracts quadratically; a multiple one contracts
// by (m-1)/m only, whatever the rounding. Source: [Tisseur01] for the accuracy of Newton's method
// with residuals in extended precision.
#pragma once

#include <memory>

#include "moivre/certify/certificate.h"
#include "moivre/numeric/double_double.h"
#include "moivre/polynomial/tape.h"
#include "moivre/solver/solve.h"

namespace moivre {

struct Refined {
  Point x;
  bool simple = false;
  double residual = 0;   ///< max_i |F_i(x)| / sum |terms of F_i|
  double accuracy = 0;   ///< bound on |x - x*|_inf / max(1, |x|_inf); of a simple root only
  double condition = 0;  ///< of the row-scaled Jacobian
};

/// Immutable and shared: the tape of a system and its coefficients in three scalars.
struct RefinerProgram {
  RefinerProgram(const System& f, std::vector<double> natural_sizes);

  Tape tape;
  std::vector<Complex> c;
  std::vector<ComplexDoubleDouble> exact;
  std::vector<double> size;  ///< |c|
  std::vector<double>
      error;  ///< what c may be off by (polynomial/digits.h); empty where all are exact
  std::vector<double> unit;  ///< n, the natural size of each unknown
  double curvature = 1;      ///< of the equation of the highest degree, beside one of low degree
};

/// unit: from the presolve's scaling; 1 where nothing is known.
std::shared_ptr<const RefinerProgram> make_refiner_program(const System& f,
                                                           std::vector<double> unit);

/// Owns its memory; one a thread.
class Refiner {
 public:
  explicit Refiner(std::shared_ptr<const RefinerProgram> program);
  ~Refiner();
  Refiner(Refiner&&) noexcept;

  /// The sizes that coordinates are measured by where they are smaller, from now on; empty: the program's.
  void measure_by(std::vector<double> units);

  /// From x, of relative accuracy `accuracy`. Where Newton does not contract, x is left as it was.
  /// Parts of coordinates that vanish to within the accuracy are set to 0 if that fits F as well.
  Refined refine(const Point& x, double accuracy);

  /// As refine(), with x, F and J in double-double: for roots of conditions up to 1e22, where the Jacobian in double says
  /// nothing. The accuracy takes in what rounding in double-double leaves open.
  Refined refine_fine(const Point& x);

  /// The root that is proved, as accurate as that says. Parts of coordinates that may be 0 are set to 0 if that fits F as well.
  /// condition: as far as it is known, else not finite.
  Refined take(const Certificate& proved, double condition);

  /// Whether Newton's method may go from x, of relative accuracy `accuracy`, to y.
  bool is_within_reach(const Point& x, double accuracy, const Point& y);

  /// A direction in which F changes least at x, as far as J in double tells, of size 1; `any` where it tells nothing.
  Point softest(const Point& x, Point any);

  /// For an end where `sheets` sheets meet: no Newton, the rest as refine(). The accuracy takes into
  /// account that a residual of e means an error near e^{1/sheets}.
  Refined keep(const Point& x, double accuracy, int sheets);

  /// F(x) / sum |terms|, each equation, in double-double from the exact coefficients.
  /// Lives until the next call, and no longer than the Refiner: a temporary one is refused.
  const std::vector<Complex>& relative_values(const Point& x) &;

  /// max_i |relative_values(x)_i|.
  double residual(const Point& x);

 private:
  bool newton(Point& x, double reach);
  bool is_simple(const Point& x);
  double sensitivity(const Point& x);
  double natural_residual(const Point& x);
  void snap_to_zero(Refined& root, double accuracy);
  bool take_snapped(Refined& root, Point&& snapped);
  bool contracts_beside(double sensitivity);

  struct Workspace;
  std::unique_ptr<Workspace> w_;
};

}  // namespace moivre

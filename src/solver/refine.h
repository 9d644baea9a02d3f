// SPDX-License-Identifier: MIT
// How exactly is an end known, on the system as given?
//
// Residuals are evaluated in double-double from the exact coefficients, the Jacobian in double. An
// end is a simple root where a certificate says so (certificates.h), and then as accurate as that
// says. The mean of a circle, at which several sheets meet, is kept as it is: a residual of e
// leaves an error near e^{1/sheets} open. Source: [Tisseur01] for residuals in extended precision.
#pragma once

#include <memory>

#include "moivre/certify/certificate.h"
#include "moivre/numeric/double_double.h"
#include "moivre/polynomial/tape.h"
#include "moivre/solver/solve.h"
#include "shared_point.h"

namespace moivre {

struct Refined {
  SharedPoint x;
  bool simple = false;
  double residual = 0;  ///< max_i |F_i(x)| / sum |terms of F_i|
  double accuracy =
      0;  ///< |x - x*|_inf / max(1, |x|_inf): of a simple root a bound, else an estimate
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

  /// The root that is proved, as accurate as that says. Parts of coordinates that may be 0 are set
  /// to 0 if that fits F as well.
  Refined take(const Certificate& proved);

  /// Whether the root of an end x, of relative accuracy `accuracy`, may be y.
  bool is_within_reach(const Point& x, double accuracy, const Point& y);

  /// A direction in which F changes least at x, as far as J in double tells, of size 1; `any` where
  /// it tells nothing.
  Point softest(const Point& x, Point any);

  /// An end where `sheets` sheets meet, as it stands. Its accuracy takes into account that a
  /// residual of e means an error near e^{1/sheets}. Parts of coordinates that vanish to within the
  /// accuracy are set to 0 if that fits F as well.
  Refined keep(const Point& x, double accuracy, int sheets);

  /// F(x) / sum |terms|, each equation, in double-double from the exact coefficients.
  /// Lives until the next call, and no longer than the Refiner: a temporary one is refused.
  const std::vector<Complex>& relative_values(const Point& x) &;

  /// max_i |relative_values(x)_i|.
  double residual(const Point& x);

 private:
  double condition_at(const Point& x);
  double natural_residual(const Point& x);
  bool take_snapped(Refined& root, Point&& snapped);

  struct Workspace;
  std::unique_ptr<Workspace> w_;
};

}  // namespace moivre

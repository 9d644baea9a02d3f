// SPDX-License-Identifier: MIT
// What are the closure polynomials at any time, and how fast do their coefficients move? F(x; t),
// with its derivative by t.
//
//   F_i(x; t) = sum_k c_ik(t) x^a_ik,  x in units of the mechanism: a length counts by its largest
//                                      one
//
// Between two times the drivers move smoothly, and c_ik is its Chebyshev series there: the
// formulation is made at the nodes, 9, 17 or 33 of them until the last coefficients are rounding;
// else the stretch is halved.
// Some formulations are unique but for a factor of each row, or tell only what several rows of one
// name span: a pivot elsewhere gives other rows of that span. So the k rows R of a group, with M
// theirs in the middle of the stretch, are replaced by (R M^H)^-1 R, which depends on the span
// alone and moves smoothly while it does not turn too far.
// Stretches are made when they are asked for.
// Edges: where a driver's law has a corner, or a formulation changes its kind, nothing is known,
// and at() says so. Rows that are not smooth do not keep others from being known.
// Symbols: c in the order of the terms, row after row; t in seconds.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "moivre/formulation/formulation.h"
#include "moivre/numeric/double_double.h"

namespace moivre {

class MovingPolynomials {
 public:
  /// `borders`: two times or more, ascending. The mechanism must outlive it.
  MovingPolynomials(const Mechanism& mechanism, std::vector<double> borders);

  /// A term of one row; `number`: of its coefficient.
  struct MovingTerm {
    std::size_t number = 0;
    std::vector<std::uint32_t> factors;  ///< variables, as often as they are factors
  };
  const std::vector<std::vector<MovingTerm>>& rows() const { return rows_; }
  /// The monomials that occur at some time, with the coefficients of one time.
  const Formulation& formulation() const { return formulation_; }
  /// By which each variable of the formulation is divided.
  const std::vector<double>& units() const { return units_; }

  struct Coefficients {
    std::vector<Complex> c;
    std::vector<Complex> rate;  ///< dc/dt
  };
  /// Those of `rows`; nullopt: these are not smooth there.
  std::optional<Coefficients> at(double t, const std::vector<std::size_t>& rows) const;
  /// c from the formulation at that very time, twice as long: what the series leaves out would hide
  /// two roots that all but meet.
  std::optional<std::vector<ComplexDoubleDouble>> sharply_at(
      double t, const std::vector<std::size_t>& rows) const;

 private:
  /// Rows of which the formulation tells what they span.
  using Group = std::vector<std::size_t>;
  /// The Chebyshev series of every coefficient between two times.
  struct Stretch {
    double from = 0;
    double to = 0;
    std::vector<std::vector<Complex>> series;  ///< of each degree, all coefficients
    std::vector<Complex> middle;               ///< c there, as it is formulated
    std::vector<bool> is_smooth;               ///< of each row
  };
  const Stretch* stretch_at(double t, const std::vector<std::size_t>& rows) const;
  Stretch stretch(double from, double to) const;
  void fill(Stretch& stretch) const;
  std::optional<std::vector<ComplexDoubleDouble>> coefficients(double t) const;
  void find_groups();
  Eigen::MatrixXcd rows_of(const Group& group, const std::vector<Complex>& c) const;
  Eigen::MatrixXcd to_span(const Group& group, const std::vector<Complex>& c,
                           const std::vector<Complex>& middle) const;
  template <class Number>
  void replace_rows(const Group& group, const Eigen::MatrixXcd& by, std::vector<Number>& c) const;
  double last_share(const Group& group, const std::vector<std::vector<Complex>>& series,
                    const std::vector<std::vector<Complex>>& nodes) const;

  const Mechanism& mechanism_;
  std::vector<double> borders_;
  Formulation formulation_;
  std::vector<double> units_;
  std::vector<std::vector<MovingTerm>> rows_;
  std::vector<std::map<Monomial, std::size_t>> number_;  ///< of each row's terms
  std::size_t terms_ = 0;
  std::vector<Group> groups_;
  mutable std::map<std::pair<double, double>, Stretch> stretches_;  ///< by their ends
};

}  // namespace moivre

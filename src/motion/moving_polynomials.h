// SPDX-License-Identifier: MIT
// What are the closure polynomials at any time, and how fast do their coefficients move? F(x; t), with its derivative by t.
//
//   F_i(x; t) = sum_k c_ik(t) x^a_ik,  x in units of the mechanism: a length counts by its largest one
//
// Between two times the drivers move smoothly, and c_ik is its Chebyshev series there: the formulation is made at the nodes,
// 9, 17 or 33 of them until the last coefficients are rounding; else the stretch is halved. Each row is divided by one of its
// coefficients, since some formulations are unique but for a factor.
// Stretches are made when they are asked for.
// Edges: where a driver's law has a corner, or a formulation changes its kind, nothing is known, and at() says so.
// Symbols: c in the order of the terms, row after row; t in seconds.
#pragma once

#include <map>
#include <optional>
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
  /// nullopt: they are not smooth there.
  std::optional<Coefficients> at(double t) const;
  /// c from the formulation at that very time, twice as long: what the series leaves out would hide two roots that all but meet.
  std::optional<std::vector<ComplexDoubleDouble>> sharply_at(double t) const;

 private:
  /// The Chebyshev series of every coefficient between two times.
  struct Stretch {
    double from = 0;
    double to = 0;
    std::vector<std::vector<Complex>>
        series;                         ///< of each degree, all coefficients; empty: not smooth
    std::vector<std::size_t> divisors;  ///< of each row: the number of the coefficient that is 1
  };
  const Stretch& stretch_at(double t) const;
  Stretch stretch(double from, double to) const;
  std::optional<std::vector<ComplexDoubleDouble>> coefficients(double t) const;
  std::vector<std::size_t> largest_terms(const std::vector<Complex>& c) const;
  void divide_rows(const std::vector<std::size_t>& divisors, std::vector<Complex>& c) const;

  const Mechanism& mechanism_;
  std::vector<double> borders_;
  Formulation formulation_;
  std::vector<double> units_;
  std::vector<std::vector<MovingTerm>> rows_;
  std::vector<std::map<Monomial, std::size_t>> number_;  ///< of each row's terms
  std::size_t terms_ = 0;
  mutable std::vector<Stretch>
      stretches_;  ///< by time, without gaps once a border's stretch was asked for
};

}  // namespace moivre

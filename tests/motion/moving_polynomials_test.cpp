// SPDX-License-Identifier: MIT
// Are the polynomials of any time known from those of a few, also where a formulation tells only
// what they span?
#include "moving_polynomials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mechanisms.h"
#include "moivre/factorization/svd.h"
#include "moivre/formulation/exact.h"
#include "moivre/motion/motion.h"

namespace moivre {
namespace {

std::vector<std::size_t> rows_called(const Formulation& f, const std::string& name) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < f.equation_names.size(); ++row) {
    if (f.equation_names[row] == name) rows.push_back(row);
  }
  return rows;
}

/// Of these rows, each of length 1; columns by monomial.
Eigen::MatrixXd matrix_of(const Formulation& f, const std::vector<double>& units,
                          const std::vector<std::size_t>& rows,
                          std::map<Monomial, Eigen::Index>& columns) {
  constexpr Eigen::Index kMostMonomials = 64;
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), kMostMonomials);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const Term& term : f.system.polynomials[rows[k]].terms) {
      double c = to_complex(term.coefficient).real();
      for (const Power& power : term.monomial) c *= std::pow(units[power.variable], power.exponent);
      const Eigen::Index next = static_cast<Eigen::Index>(columns.size());
      matrix(static_cast<Eigen::Index>(k), columns.emplace(term.monomial, next).first->second) = c;
    }
  }
  return matrix.rowwise().normalized();
}

Eigen::MatrixXd matrix_of(const MovingPolynomials& polynomials, const std::vector<Complex>& c,
                          const std::vector<std::size_t>& rows,
                          std::map<Monomial, Eigen::Index>& columns) {
  Formulation f = polynomials.formulation();
  for (const std::size_t row : rows) {
    std::vector<Term>& terms = f.system.polynomials[row].terms;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      terms[k].coefficient = exactly(c[polynomials.rows()[row][k].number]);
    }
  }
  return matrix_of(f, std::vector<double>(f.system.variables.size(), 1), rows, columns);
}

// The pivots of its 3-spaces change within a quarter of a turn, and with them all four rows. What
// they span does not jump.
TEST(MovingPolynomials, SpanWhatAFormulationWithOtherPivotsSpans) {
  for (const char* name : {"bricard-driven", "7r-loop"}) {
    const Mechanism m = mechanism_file(name);
    const double to = natural_duration(m) / 4;
    const MovingPolynomials polynomials(m, {0, to});
    const std::vector<std::size_t> rows = rows_called(polynomials.formulation(), "loop");
    ASSERT_EQ(rows.size(), 4U);
    for (int k = 0; k <= 5; ++k) {
      const double t = to * k / 5;
      const auto moving = polynomials.at(t, rows);
      ASSERT_TRUE(moving) << name << ", t = " << t;
      std::map<Monomial, Eigen::Index> columns;
      const Eigen::MatrixXd known = matrix_of(polynomials, moving->c, rows, columns);
      const Eigen::MatrixXd formulated =
          matrix_of(formulate(m, t), polynomials.units(), rows, columns);
      Eigen::MatrixXd both(8, known.cols());
      both << known, formulated;
      const Eigen::VectorXd sigma = singular_values(both);
      EXPECT_GT(sigma[3], 1e-3) << name << ", t = " << t;
      EXPECT_LT(sigma[4], 1e-11) << name << ", t = " << t;
    }
  }
}

TEST(MovingPolynomials, TellTheRatesOfTheirCoefficients) {
  constexpr double kStep_s = 1e-5;
  const Mechanism m = mechanism_file("bricard-driven");
  const MovingPolynomials polynomials(m, {0, 1});
  const std::vector<std::size_t> rows = rows_called(polynomials.formulation(), "loop");
  const auto here = polynomials.at(0.4, rows);
  const auto before = polynomials.at(0.4 - kStep_s, rows);
  const auto after = polynomials.at(0.4 + kStep_s, rows);
  ASSERT_TRUE(here && before && after);
  for (const std::size_t row : rows) {
    for (const auto& term : polynomials.rows()[row]) {
      const Complex rate = (after->c[term.number] - before->c[term.number]) / (2 * kStep_s);
      EXPECT_LT(std::abs(here->rate[term.number] - rate), 1e-7);
    }
  }
}

}  // namespace
}  // namespace moivre

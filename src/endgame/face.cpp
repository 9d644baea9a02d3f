// SPDX-License-Identifier: MIT
// Faces from rounded valuations, and Gauss-Newton in logarithms on them: faces in double-double,
// their slopes in double.
#include "face.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "moivre/factorization/qr.h"
#include "moivre/numeric/fused.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Number = ComplexDoubleDouble;

/// Valuations as integers over one denominator.
struct Direction {
  int denominator = 1;
  std::vector<long> w;
};

std::optional<Direction> direction_of(const std::vector<double>& valuations,
                                      const EndParameters& ends) {
  for (int m = 1; m <= ends.maximum_winding; ++m) {
    Direction direction{m, {}};
    bool fits = true;
    for (const double v : valuations) {
      const double scaled = v * m;
      direction.w.push_back(std::lround(scaled));
      const double error = std::abs(scaled - static_cast<double>(direction.w.back()));
      fits = fits && error <= ends.valuation_error * std::max(1.0, std::abs(v)) * m;
    }
    if (fits) return direction;
  }
  return std::nullopt;
}

/// A term of a face in the units of the point, relative to the largest of its equation.
struct FaceTerm {
  Number c;
  const NumberErrors* errors;  ///< of c, relative
  const Monomial* monomial;
};
using Face = std::vector<FaceTerm>;

/// e^z - 1 without loss where z is small.
Complex exp_minus_1(const Complex& z) {
  const double half_sine = std::sin(z.imag() / 2);
  const double real = std::expm1(z.real());
  return {real - 2 * half_sine * half_sine * (real + 1), (real + 1) * std::sin(z.imag())};
}

class Faces {
 public:
  /// log2: units of the affine coordinates.
  Faces(PathSystem& path, double radius, const Direction& direction, const std::vector<int>& log2,
        const EndParameters& ends)
      : ends_(ends), x0_(path.homotopy().chart().homogenizing()) {
    const FineEnds& coefficients = path.fine_ends();
    for (std::size_t i = 0; i < path.homotopy().equations(); ++i) {
      faces_.push_back(face(path.homotopy(), coefficients, i, radius, direction, log2));
    }
  }

  bool may_vanish() const {
    return std::all_of(faces_.begin(), faces_.end(),
                       [](const Face& face) { return face.size() > 1; });
  }

  /// Gauss-Newton from y, in the units. Singular values of the Jacobian below a threshold, relative
  /// to the largest, are those of the torus that acts on all roots of a face, or of directions in
  /// which a step would lead astray. Towards a multiple root others become small too: where what is
  /// left lies in the directions cut off, fewer of them are.
  FaceRoot root_near(std::vector<Number> y) const {
    VectorXcd value(static_cast<Index>(faces_.size()));
    VectorXd error(value.size());
    MatrixXcd jacobian(value.size(), static_cast<Index>(y.size()));
    double threshold = ends_.face_threshold;
    double before = 0;
    FaceRoot result = FaceRoot::none;
    // Towards an m-fold root the values fall by (1 - 1/m)^m < 1/e with each iteration.
    const auto iterations = static_cast<int>(std::ceil(-std::log(ends_.fine_rounding)));
    for (int k = 0; k < iterations; ++k) {
      fused([&] { evaluate(y, value, error, jacobian); });
      const double largest = value.lpNorm<Eigen::Infinity>();
      if (largest <= ends_.fine_rounding) return FaceRoot::exact;
      const bool is_stuck = std::abs(largest - before) < ends_.face_progress * before;
      if (largest <= error.sum()) result = FaceRoot::as_rounded;
      // The errors make up for nothing where the way leads on to a root, slowly where that is a
      // multiple one.
      if (result == FaceRoot::as_rounded && is_stuck) break;
      if (is_stuck) threshold = std::max(ends_.face_progress * threshold, ends_.rounding);
      before = largest;
      const VectorXcd dz = shortest_solution(jacobian, -value, threshold);
      if (!dz.allFinite()) break;
      for (std::size_t j = 0; j < y.size(); ++j) {
        // 1 + (e^dz - 1) keeps all digits of double-double where dz is small.
        y[j] += product(Number(exp_minus_1(dz[static_cast<Index>(j)])), y[j]);
      }
    }
    return result;
  }

 private:
  Face face(const Homotopy& homotopy, const FineEnds& coefficients, std::size_t i, double radius,
            const Direction& direction, const std::vector<int>& log2) const {
    const std::vector<Term>& terms = homotopy.support().polynomials[i].terms;
    const std::size_t first = homotopy.first_term(i);
    std::vector<long> orders;
    std::vector<int> shifts;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      long order = is_zero(homotopy.f(first + k)) ? direction.denominator : 0;
      int shift = 0;
      for (const Power& power : terms[k].monomial) {
        if (power.variable == x0_) continue;
        order += static_cast<long>(power.exponent) * direction.w[power.variable];
        shift += static_cast<int>(power.exponent) * log2[power.variable];
      }
      orders.push_back(order);
      shifts.push_back(shift);
    }
    const long least = *std::min_element(orders.begin(), orders.end());
    Face face;
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (orders[k] != least) continue;
      const bool is_start = is_zero(homotopy.f(first + k));
      const Number value = is_start ? product(DoubleDouble(radius), coefficients.g[first + k])
                                    : coefficients.f[first + k];
      largest = std::max(largest, std::log2(magnitude1(value)) + shifts[k]);
      face.push_back({value, &homotopy.errors(first + k), &terms[k].monomial});
    }
    std::size_t next = 0;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (orders[k] != least) continue;
      const double factor = std::exp2(shifts[k] - std::floor(largest));
      face[next].c = product(DoubleDouble(factor), face[next].c);
      ++next;
    }
    return face;
  }

  // Each face over its largest term, what errors of the file's numbers change in it, and its
  // derivatives in log y: the torus that acts on the roots of a face is exactly their null space.
  void evaluate(const std::vector<Number>& y, VectorXcd& value, VectorXd& error,
                MatrixXcd& jacobian) const {
    jacobian.setZero();
    std::vector<Number> terms;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      terms.clear();
      for (const FaceTerm& term : faces_[i]) terms.push_back(value_of(term, y));
      const auto largest = std::max_element(
          terms.begin(), terms.end(),
          [](const Number& a, const Number& b) { return magnitude1(a) < magnitude1(b); });
      const FaceTerm& reference = faces_[i][static_cast<std::size_t>(largest - terms.begin())];
      const Complex scale = 1.0 / to_complex(*largest);
      const auto row = static_cast<Index>(i);
      Number sum(0.0);
      NumberErrors errors;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        sum += terms[k];
        const Complex share = to_complex(terms[k]) * scale;
        add(errors, share, *faces_[i][k].errors);
        add_exponents(*faces_[i][k].monomial, share, jacobian, row);
        add_exponents(*reference.monomial, -share, jacobian, row);
      }
      value[row] = to_complex(sum) * scale;
      error[row] = bound(errors);
    }
  }

  Number value_of(const FaceTerm& term, const std::vector<Number>& y) const {
    Number result = term.c;
    for (const Power& power : *term.monomial) {
      if (power.variable == x0_) continue;
      for (std::uint32_t e = 0; e < power.exponent; ++e)
        result = product(result, y[power.variable]);
    }
    return result;
  }

  void add_exponents(const Monomial& monomial, Complex share, MatrixXcd& jacobian,
                     Index row) const {
    for (const Power& power : monomial) {
      if (power.variable == x0_) continue;
      jacobian(row, static_cast<Index>(power.variable)) +=
          static_cast<double>(power.exponent) * share;
    }
  }

  EndParameters ends_;
  std::size_t x0_;
  std::vector<Face> faces_;
};

}  // namespace

FaceRoot face_root(PathSystem& path, const Point& x, double radius,
                   const std::vector<double>& valuations, const EndParameters& ends) {
  const std::optional<Direction> direction = direction_of(valuations, ends);
  if (!direction) return FaceRoot::none;
  const Chart& chart = path.homotopy().chart();
  std::vector<int> log2;
  std::vector<Number> y;
  for (std::size_t j = 0; j < chart.unknowns; ++j) {
    if (x[j] == 0.0) return FaceRoot::none;
    const Complex z = std::log(x[j]) - std::log(chart.x0(x));
    log2.push_back(static_cast<int>(std::lround(z.real() / std::log(2.0))));
    y.push_back(Number(std::exp(z - log2.back() * std::log(2.0))));
  }
  const Faces faces(path, radius, *direction, log2, ends);
  if (!faces.may_vanish()) return FaceRoot::none;
  return faces.root_near(std::move(y));
}

}  // namespace moivre

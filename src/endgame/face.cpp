// SPDX-License-Identifier: MIT
// Faces from rounded valuations, and Gauss-Newton in logarithms on them.
#include "face.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

// Valuations are known this well where they are steady.
constexpr double kValuationError = 0.03;
constexpr int kLargestDenominator = 32;
// Faces vanish to rounding: this, beside their largest terms.
constexpr double kVanished = 1e-12;
// The root lies near the path: its logarithms no further away than this.
constexpr double kNeighbourhood = 3;
// Enough for a double root, whose error halves with each iteration.
constexpr int kIterations = 50;
// Below this beside the largest, a singular value of the Jacobian is one of the torus that acts on all roots of a face.
constexpr double kRankThreshold = 1e-9;

/// Valuations as integers over one denominator.
struct Direction {
  int denominator = 1;
  std::vector<long> w;
};

std::optional<Direction> direction_of(const std::vector<double>& valuations) {
  for (int m = 1; m <= kLargestDenominator; ++m) {
    Direction direction{m, {}};
    bool fits = true;
    for (const double v : valuations) {
      const double scaled = v * m;
      direction.w.push_back(std::lround(scaled));
      const double error = std::abs(scaled - static_cast<double>(direction.w.back()));
      fits = fits && error <= kValuationError * std::max(1.0, std::abs(v)) * m;
    }
    if (fits) return direction;
  }
  return std::nullopt;
}

/// A term of a face: c e^{<a, z>}, z = log x.
struct FaceTerm {
  Complex log_c;
  const Monomial* monomial;
};
using Face = std::vector<FaceTerm>;

class Faces {
 public:
  Faces(const Homotopy& homotopy, double radius, const Direction& direction)
      : x0_(homotopy.chart().homogenizing()) {
    for (std::size_t i = 0; i < homotopy.equations(); ++i) {
      faces_.push_back(face(homotopy, i, radius, direction));
    }
  }

  bool may_vanish() const {
    return std::all_of(faces_.begin(), faces_.end(),
                       [](const Face& face) { return face.size() > 1; });
  }

  /// Gauss-Newton from z.
  bool vanish_near(VectorXcd z) {
    const VectorXcd begin = z;
    VectorXcd value(static_cast<Index>(faces_.size()));
    MatrixXcd jacobian(value.size(), z.size());
    for (int k = 0; k < kIterations; ++k) {
      evaluate(z, value, jacobian);
      if (value.lpNorm<Eigen::Infinity>() <= kVanished) return true;
      Eigen::CompleteOrthogonalDecomposition<MatrixXcd> qr;
      qr.setThreshold(kRankThreshold);
      z -= qr.compute(jacobian).solve(value);
      if (!z.allFinite() || (z - begin).lpNorm<Eigen::Infinity>() > kNeighbourhood) return false;
    }
    return false;
  }

 private:
  Face face(const Homotopy& homotopy, std::size_t i, double radius,
            const Direction& direction) const {
    const std::vector<Term>& terms = homotopy.support().polynomials[i].terms;
    std::vector<long> orders;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      long order = is_zero(homotopy.f(homotopy.first_term(i) + k)) ? direction.denominator : 0;
      for (const Power& power : terms[k].monomial) {
        if (power.variable == x0_) continue;
        order += static_cast<long>(power.exponent) * direction.w[power.variable];
      }
      orders.push_back(order);
    }
    const long least = *std::min_element(orders.begin(), orders.end());
    Face face;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (orders[k] != least) continue;
      const Coefficient& f = homotopy.f(homotopy.first_term(i) + k);
      const Complex c =
          is_zero(f) ? radius * to_complex(homotopy.g(homotopy.first_term(i) + k)) : to_complex(f);
      face.push_back({std::log(c), &terms[k].monomial});
    }
    return face;
  }

  // Each face beside its largest term.
  void evaluate(const VectorXcd& z, VectorXcd& value, MatrixXcd& jacobian) const {
    value.setZero();
    jacobian.setZero();
    std::vector<Complex> exponents;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      exponents.clear();
      double largest = -std::numeric_limits<double>::infinity();
      for (const FaceTerm& term : faces_[i]) {
        Complex e = term.log_c;
        for (const Power& power : *term.monomial) {
          if (power.variable == x0_) continue;
          e += static_cast<double>(power.exponent) * z[static_cast<Index>(power.variable)];
        }
        largest = std::max(largest, e.real());
        exponents.push_back(e);
      }
      const auto row = static_cast<Index>(i);
      for (std::size_t k = 0; k < faces_[i].size(); ++k) {
        const Complex size = std::exp(exponents[k] - largest);
        value[row] += size;
        for (const Power& power : *faces_[i][k].monomial) {
          if (power.variable == x0_) continue;
          jacobian(row, static_cast<Index>(power.variable)) +=
              static_cast<double>(power.exponent) * size;
        }
      }
    }
  }

  std::size_t x0_;
  std::vector<Face> faces_;
};

}  // namespace

bool has_face_root(const Homotopy& homotopy, const Point& x, double radius,
                   const std::vector<double>& valuations) {
  const std::optional<Direction> direction = direction_of(valuations);
  if (!direction) return false;
  Faces faces(homotopy, radius, *direction);
  if (!faces.may_vanish()) return false;
  const Chart& chart = homotopy.chart();
  VectorXcd z(static_cast<Index>(chart.unknowns));
  for (std::size_t j = 0; j < chart.unknowns; ++j) {
    if (x[j] == 0.0) return false;
    z[static_cast<Index>(j)] = std::log(x[j]) - std::log(chart.x0(x));
  }
  return faces.vanish_near(z);
}

}  // namespace moivre

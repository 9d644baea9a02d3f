// SPDX-License-Identifier: MIT
// One adjoint solve a sample, then a product for each rounded number.
#include "file_errors.h"

#include <algorithm>

#include "moivre/polynomial/value.h"

namespace moivre {
namespace {

/// l J^{-1}, l = e_0 - x_0 a.
Point gradient_of_x0(PathSystem& path, const Point& x, const Point& patch) {
  const std::size_t homogenizing = path.homotopy().chart().homogenizing();
  Point w(x.size());
  for (std::size_t j = 0; j < x.size(); ++j) w[j] = -product(x[homogenizing], patch[j]);
  w[homogenizing] += 1.0;
  const auto conjugate = [](const Complex& wj) { return std::conj(wj); };
  std::transform(w.begin(), w.end(), w.begin(), conjugate);
  path.solve_adjoint(w);
  std::transform(w.begin(), w.end(), w.begin(), conjugate);
  return w;
}

std::size_t numbers_of(const Homotopy& homotopy) {
  std::size_t numbers = 0;
  for (std::size_t k = 0; k < homotopy.terms(); ++k) {
    for (const NumberError& error : homotopy.errors(k)) {
      numbers = std::max<std::size_t>(numbers, error.number + 1);
    }
  }
  return numbers;
}

}  // namespace

std::vector<std::vector<Complex>> changes_of_x0(PathSystem& path, const PathFrame* frame,
                                                const Contour& circle, std::size_t of_turn,
                                                const std::vector<Point>& samples,
                                                const Point& patch) {
  const Homotopy& homotopy = path.homotopy();
  const FineEnds& coefficients = path.fine_ends();
  std::vector<std::vector<Complex>> changes(numbers_of(homotopy),
                                            std::vector<Complex>(samples.size()));
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const double angle = static_cast<double>(s % of_turn + 1) / static_cast<double>(of_turn);
    const PathTime t = circle.at(angle);
    if (!path.linearize(samples[s], t)) continue;
    const Point w = gradient_of_x0(path, samples[s], patch);
    for (std::size_t i = 0; i < homotopy.equations(); ++i) {
      const std::vector<Term>& terms = homotopy.support().polynomials[i].terms;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const std::size_t term = homotopy.first_term(i) + k;
        const NumberErrors& errors = homotopy.errors(term);
        if (errors.empty()) continue;
        Complex moved = product(t.t, to_complex(coefficients.f[term]));
        if (frame != nullptr) moved *= frame->factors[term];
        const Complex effect =
            -product(w[i], product(moved, value_at(terms[k].monomial, samples[s])));
        for (const NumberError& error : errors) {
          Complex& change = changes[error.number][s];
          change = add_product(effect, error.change, change);
        }
      }
    }
  }
  return changes;
}

}  // namespace moivre

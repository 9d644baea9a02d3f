// SPDX-License-Identifier: MIT
// Where does a path go on? The polynomial through its last points and tangents, in a scalar S of
// more digits than double.
//
//   p(w_i) = x_i, p'(w_i) = x'_i at k nodes: degree 2 k - 1, Newton's form with each node twice
//   (Hermite)
//   error a step h ahead, the nodes h apart: (k!)^2 (h / R)^{2 k} of |x|, R the distance of the
//   next singular point
//
// Beside another sheet many digits are asked for: they take many steps at a low order and few at a
// high one. A node more costs next to nothing compared with an evaluation in S.
// Edges: one node gives the tangent; its error is not known. Allocates nothing but what S does.
// Source: [StoerBulirsch02, section 2.1.5], divided differences of nodes that coincide.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "moivre/numeric/scalar.h"

namespace moivre {

/// x' = slope dx.
template <class S>
struct HermiteNode {
  using Real = typename Scalar<S>::Real;

  Real w;
  Real slope;
  const std::vector<S>* x = nullptr;
  const std::vector<S>* dx = nullptr;
};

template <class S>
class HermitePredictor {
  using Real = typename Scalar<S>::Real;

 public:
  static constexpr std::size_t kMostNodes = 6;

  /// y <- p(w). nodes: 1 ... kMostNodes, all w_i different. Returns the largest coordinate of the
  /// term of highest degree; infinity where there is but one node.
  double predict(std::span<const HermiteNode<S>> nodes, const Real& w, std::span<S> y) {
    const std::size_t count = 2 * nodes.size();
    prepare(nodes, w);
    double last_term = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      for (std::size_t i = 0; i < count; ++i) difference_[i] = (*nodes[i / 2].x)[j];
      S term;
      y[j] = difference_[0];
      for (std::size_t order = 1; order < count; ++order) {
        for (std::size_t i = 0; i + order < count; ++i) {
          const bool is_one_node = order == 1 && i % 2 == 0;
          difference_[i] = is_one_node ? product(nodes[i / 2].slope, (*nodes[i / 2].dx)[j])
                                       : product(reciprocal_[i / 2][(i + order) / 2],
                                                 difference_[i + 1] - difference_[i]);
        }
        term = product(product_[order], difference_[0]);
        y[j] += term;
      }
      last_term = std::max(last_term, magnitude1(to_complex(term)));
    }
    return nodes.size() > 1 ? last_term : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr std::size_t kMost = 2 * kMostNodes;

  /// 1 / (w_k - w_i), i < k, and the products of w - w_i of doubled nodes.
  void prepare(std::span<const HermiteNode<S>> nodes, const Real& w) {
    product_[0] = Real(1.0);
    for (std::size_t order = 1; order < 2 * nodes.size(); ++order) {
      product_[order] = product_[order - 1] * (w - nodes[(order - 1) / 2].w);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t k = i + 1; k < nodes.size(); ++k) {
        reciprocal_[i][k] = Real(1.0) / (nodes[k].w - nodes[i].w);
      }
    }
  }

  std::array<S, kMost> difference_;
  std::array<Real, kMost> product_;
  std::array<std::array<Real, kMostNodes>, kMostNodes> reciprocal_;
};

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Where will each lane's path be a step ahead? Hermite extrapolation through its last points and
// tangents.
//
//   nodes 0, 1, 2 at s, s - g_1, s - g_2;  x(s + h) ~ sum_i A_i(h) x_i + B_i(h) x_i',  local order
//                                          6
//   A_i = (1 - 2 l_i'(s_i)(s + h - s_i)) l_i^2,  B_i = (s + h - s_i) l_i^2,  l_i Lagrange's
//                                                polynomials
//   over the first one or two nodes alone: order 2 (Euler's step) or 4
//
// Homogeneous points are extrapolated in a fixed affine patch a x = 1, where the path is
// holomorphic in s. The patch is a = x^H / |x|^2 of a point of the path; it is renewed, and the
// nodes with it, when |a| |x| leaves kPatchReach.
// A path that sets out has no past: two nodes are laid back along its tangent, so that the first
// steps are Euler's.
// Why this predictor: docs/decisions.
#if defined(MOIVRE_LANE_PATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_PATH_INL_H_
#undef MOIVRE_LANE_PATH_INL_H_
#else
#define MOIVRE_LANE_PATH_INL_H_
#endif

#include <array>

#include "lane_complex-inl.h"
#include "moivre/tracker_lanes/lane_tracker.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// |a| |x| above which a patch is renewed: 1 where a was taken.
inline constexpr double kPatchReach = 1.2;

template <class R>
class LanePath {
 public:
  using Number = typename LaneScalar<R>::Number;

  explicit LanePath(std::size_t coordinates, LanePredictor predictor = LanePredictor::quintic)
      : n_(coordinates),
        predictor_(predictor),
        patch_(coordinates),
        nodes_{Node(n_), Node(n_), Node(n_)},
        gaps_(1) {}

  const LaneVector<R>& patch() const { return patch_; }
  /// The last point and its tangent.
  LaneVector<R>& x() { return nodes_[0].x; }
  LaneVector<R>& tangent() { return nodes_[0].dx; }

  /// Sets a lane's point, of norm 1, before its segment.
  void place(std::size_t lane, std::span<const Number> x) {
    for (std::size_t i = 0; i < n_; ++i) {
      patch_.set(i, lane, conj(x[i]));
      for (Node& node : nodes_) {
        node.x.set(i, lane, x[i]);
        node.dx.set(i, lane, Number(0.0));
      }
    }
    gaps_.set(0, lane, Complex(1, 2));
  }

  /// predicted <- x(s + h).
  void predict(V h, LaneVector<R>& predicted) const {
    switch (predictor_) {
      case LanePredictor::tangent:
        return combine<1>({Weights{broadcast(1.0), h}}, predicted);
      case LanePredictor::cubic:
        return combine<2>(cubic_weights(h), predicted);
      case LanePredictor::quintic:
        return combine<3>(quintic_weights(h), predicted);
    }
  }

  /// Where `stepped`, nodes move up after a step h; where `replaced` as well, the last node becomes
  /// (x, dx).
  void advance(Mask stepped, Mask replaced, V h, const LaneVector<R>& x, const LaneVector<R>& dx) {
    for (std::size_t i = 0; i < n_; ++i) {
      advance_entry(stepped, replaced, load(x[i]), nodes_[0].x[i], nodes_[1].x[i], nodes_[2].x[i]);
      advance_entry(stepped, replaced, load(dx[i]), nodes_[0].dx[i], nodes_[1].dx[i],
                    nodes_[2].dx[i]);
    }
    const LaneComplex<V> g = load(gaps_[0]);
    store(select(stepped, LaneComplex<V>{h, g.re + h}, g), gaps_[0]);
  }

  /// Where `mask`, lays the past back along the tangent, a step h and two of them.
  void forget(Mask mask, V h) {
    const V two_h = h + h;
    for (std::size_t i = 0; i < n_; ++i) {
      const LaneComplex<R> x = load(nodes_[0].x[i]);
      const LaneComplex<R> dx = load(nodes_[0].dx[i]);
      store(select(mask, x - h * dx, load(nodes_[1].x[i])), nodes_[1].x[i]);
      store(select(mask, x - two_h * dx, load(nodes_[2].x[i])), nodes_[2].x[i]);
      store(select(mask, dx, load(nodes_[1].dx[i])), nodes_[1].dx[i]);
      store(select(mask, dx, load(nodes_[2].dx[i])), nodes_[2].dx[i]);
    }
    store(select(mask, LaneComplex<V>{h, two_h}, load(gaps_[0])), gaps_[0]);
  }

  /// Renews the patch in the lanes that have left its reach.
  void renew_patches() {
    V size = zeros();
    V patch = zeros();
    for (std::size_t i = 0; i < n_; ++i) {
      size = size + squared_magnitude(load(nodes_[0].x[i]));
      patch = patch + squared_magnitude(load(patch_[i]));
    }
    const Mask far = (size * patch) > broadcast(kPatchReach * kPatchReach);
    if (is_nowhere(far)) return;
    const V scale = broadcast(1.0) / square_root(size);
    for (std::size_t i = 0; i < n_; ++i) {
      const LaneComplex<R> own = conj(scale * load(nodes_[0].x[i]));
      store(select(far, own, load(patch_[i])), patch_[i]);
    }
    for (Node& node : nodes_) into_patch(far, node);
  }

  /// 1 - a x, how far x is off the patch.
  LaneComplex<R> distance(const LaneVector<R>& x) const {
    LaneComplex<R> result = one<R>();
    for (std::size_t i = 0; i < n_; ++i) {
      result = subtract_product(load(patch_[i]), load(x[i]), result);
    }
    return result;
  }

 private:
  struct Node {
    explicit Node(std::size_t n) : x(n), dx(n) {}
    LaneVector<R> x;
    LaneVector<R> dx;
  };
  struct Weights {
    V a, b;
  };

  static Weights weights(V l, V slope, V distance) {
    const V squared = l * l;
    const V factor = subtract_multiply(slope + slope, distance, broadcast(1.0));
    return {factor * squared, distance * squared};
  }

  std::array<Weights, 2> cubic_weights(V h) const {
    const V g = load(gaps_[0]).re;
    const V r = broadcast(1.0) / g;
    const V after = h + g;
    return {weights(after * r, r, h), weights(-(h * r), -r, after)};
  }

  std::array<Weights, 3> quintic_weights(V h) const {
    const LaneComplex<V> g = load(gaps_[0]);
    const V one = broadcast(1.0);
    const V between = g.im - g.re;
    const V after1 = h + g.re;
    const V after2 = h + g.im;
    const V r1 = one / g.re;
    const V r2 = one / g.im;
    const V rb = one / between;
    const V l0 = after1 * r1 * (after2 * r2);
    const V l1 = -(h * r1 * (after2 * rb));
    const V l2 = h * r2 * (after1 * rb);
    return {weights(l0, r1 + r2, h), weights(l1, rb - r1, after1), weights(l2, -(r2 + rb), after2)};
  }

  // predicted <- sum_i A_i x_i + B_i x_i' over the first nodes.
  template <std::size_t Nodes>
  void combine(const std::array<Weights, Nodes>& w, LaneVector<R>& predicted) const {
    for (std::size_t i = 0; i < n_; ++i) {
      LaneComplex<R> x = add_product(w[0].b, load(nodes_[0].dx[i]), w[0].a * load(nodes_[0].x[i]));
      for (std::size_t k = 1; k < Nodes; ++k) {
        x = add_product(w[k].a, load(nodes_[k].x[i]), x);
        x = add_product(w[k].b, load(nodes_[k].dx[i]), x);
      }
      store(x, predicted[i]);
    }
  }

  static void advance_entry(Mask stepped, Mask replaced, const LaneComplex<R>& value,
                            LaneCell<R>& node0, LaneCell<R>& node1, LaneCell<R>& node2) {
    const LaneComplex<R> newest = load(node0);
    const LaneComplex<R> middle = load(node1);
    store(select(stepped, middle, load(node2)), node2);
    store(select(stepped, newest, middle), node1);
    store(select(replaced, value, newest), node0);
  }

  // x / (a x) and its derivative.
  void into_patch(Mask mask, Node& node) {
    LaneComplex<R> ax = zero<R>();
    LaneComplex<R> adx = zero<R>();
    for (std::size_t i = 0; i < n_; ++i) {
      const LaneComplex<R> a = load(patch_[i]);
      ax = add_product(a, load(node.x[i]), ax);
      adx = add_product(a, load(node.dx[i]), adx);
    }
    const LaneComplex<R> scale = reciprocal(ax);
    for (std::size_t i = 0; i < n_; ++i) {
      const LaneComplex<R> x = scale * load(node.x[i]);
      const LaneComplex<R> dx = scale * subtract_product(x, adx, load(node.dx[i]));
      store(select(mask, x, load(node.x[i])), node.x[i]);
      store(select(mask, dx, load(node.dx[i])), node.dx[i]);
    }
  }

  std::size_t n_;
  LanePredictor predictor_;
  LaneVector<R> patch_;
  Node nodes_[3];
  LaneVector<V> gaps_;  // g_1 and g_2 in the place of real and imaginary part
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif

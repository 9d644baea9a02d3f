// SPDX-License-Identifier: MIT
// The spherical four-bar of the turns, and one determinant.
#include "four_turns.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "arithmetic.h"
#include "dyad.h"

namespace moivre {
namespace {

constexpr std::size_t kTurns = 4;
constexpr std::size_t kSlides = 2;

using Vector = std::array<Polynomial, 3>;

/// Of the angle between the axes of two turns.
double sine(const LoopElement& a, const LoopElement& b) {
  const auto direction = [](const LoopElement& element) {
    const Quaternion<double> q = to_double(element.axis).q;
    return Eigen::Vector3d(q[1], q[2], q[3]).normalized();
  };
  return direction(a).cross(direction(b)).norm();
}

Polynomial component(const std::array<Rational, 3>& along, const Vector& v) {
  Polynomial sum;
  for (std::size_t k = 0; k < v.size(); ++k) sum = sum + Coefficient{along[k], 0} * v[k];
  return without_noise(sum, largest_coefficient(sum));
}

/// Whether v has no part in this direction but rounding.
bool stands_across(const std::array<Rational, 3>& along, const Vector& v) {
  double size = 0;
  double most = 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    size = std::max(size, largest_coefficient(v[k]));
    most = std::max(most, std::abs(to_double(along[k])));
  }
  return without_noise(component(along, v), size * most).terms.empty();
}

std::array<Rational, 3> cross(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class FourTurns {
 public:
  FourTurns(SpatialFrame& frame, const JointLoop& loop)
      : frame_(frame), loop_(loop), turns_(turns_of(loop)) {
    for (std::size_t k = 1; k < loop.elements.size(); ++k) {
      if (!loop.elements[k].is_turn) other_ = k;
    }
  }

  void add() {
    add_turns();
    add_slides();
  }

 private:
  const LoopElement& e(std::size_t k) const { return loop_.elements[k]; }
  const LoopElement& turn(std::size_t k) const { return loop_.elements[turns_[k]]; }

  /// What stands between two elements: A of the slide that moves, 1 for the others.
  ExactPose between(std::size_t first, std::size_t last, std::size_t moved) const {
    return first <= moved && moved < last ? e(moved).axis : ExactPose::identity();
  }

  /// The dyad of turns `first` and the next one, with the slide `moved` in it.
  MovingPose dyad(std::size_t first, const std::array<Polynomial, 4>& coordinates,
                  std::size_t moved) const {
    const auto a = basis_of(turn(first));
    const auto b = basis_of(turn(first + 1));
    const ExactPose inside = between(turns_[first] + 1, turns_[first + 1], moved);
    MovingPose pose;
    for (std::size_t k = 0; k < 4; ++k) {
      pose = pose + coordinates[k] * to_moving(a[k / 2] * inside * b[k % 2]);
    }
    return pose;
  }

  /// The product of the loop, linear in the slide `moved`: its factor. No slide moves where `moved`
  /// is the loop's size.
  MovingPose chain(std::size_t moved) const {
    return to_moving(between(0, turns_[0], moved)) * dyad(0, c_, moved) *
           to_moving(between(turns_[1] + 1, turns_[2], moved)) * dyad(2, d_, moved) *
           to_moving(between(turns_[3] + 1, loop_.elements.size(), moved));
  }

  /// g conj(q(w)) without its real part.
  Vector shift(const MovingPose& pose) const {
    const auto g = product(pose.g, to_moving(conjugate(loop_.whole)).q);
    return {g[1], g[2], g[3]};
  }

  void add_turns() {
    c_ = add_dyad_coordinates(frame_, turn(0), turn(1));
    add_quadric(frame_, turn(0), c_);
    LoopElement a = turn(2);
    LoopElement b = turn(3);
    a.axis.g = b.axis.g = {};
    const MovingPose rest = conjugate(dyad(0, c_, loop_.elements.size())) * to_moving(loop_.whole);
    d_ = coordinates_in(dyad_space(a, b, frame_.length()), rest);
    for (Polynomial& d : d_) d = without_noise(d, largest_coefficient(d));
    add_quadric(frame_, a, d_);
    add_half_angles(frame_, turn(0), turn(1), c_);
    add_half_angles(frame_, turn(2), turn(3), d_);
  }

  void add_slides() {
    const std::size_t none = loop_.elements.size();
    const Quaternion<Rational> q = loop_.whole.q;
    const MovingPose turned = dyad(0, c_, none);
    const Polynomial N = dot(turned.q, turned.q);
    Vector v0 = shift(chain(none));
    const auto wanted = product(loop_.whole.g, conjugate(q));
    for (std::size_t k = 0; k < v0.size(); ++k) {
      v0[k] = rounded_difference(v0[k], Coefficient{wanted[k + 1], 0} * N);
    }
    const auto& axis = e(0).axis.g;
    const std::array<Rational, 3> a1{axis[1], axis[2], axis[3]};
    // No turn between the slides: v_2 is N times a constant.
    const bool is_beside = other_ < turns_.front() || other_ > turns_.back();
    Vector v2 = shift(chain(other_));
    Vector beside = v2;
    if (is_beside) {
      const Quaternion<Rational> there = other_ < turns_.front()
                                             ? scaled(dot(q, q), e(other_).axis.g)
                                             : product(product(q, e(other_).axis.g), conjugate(q));
      for (std::size_t k = 0; k < beside.size(); ++k) beside[k] = real_constant(there[k + 1]);
      for (std::size_t k = 0; k < v2.size(); ++k) v2[k] = N * beside[k];
    }
    std::array<Rational, 3> smallest{};
    const auto least = std::min_element(
        a1.begin(), a1.end(), [](const Rational& a, const Rational& b) { return a * a < b * b; });
    smallest[static_cast<std::size_t>(least - a1.begin())] = 1;
    const std::array<Rational, 3> m1 = cross(a1, smallest);
    const std::array<Rational, 3> m2 = cross(a1, m1);
    if (stands_across(m1, beside) && stands_across(m2, beside)) {
      // Slides along parallel lines make up no more than one of them does.
      frame_.add_equation("loop", component(m1, v0));
      frame_.add_equation(e(other_).name, component(m2, v0));
    } else {
      const Polynomial lines =
          component(m1, v0) * component(m2, beside) - component(m2, v0) * component(m1, beside);
      frame_.add_equation("loop", without_noise(lines, largest_coefficient(lines)));
      std::array<Rational, 3> m = m1;
      const Rational part = frame_.random_number();
      for (std::size_t k = 0; k < m.size(); ++k) m[k] += part * m2[k];
      frame_.add_equation(e(other_).name, component(m, v0) + e(other_).unknown * component(m, v2));
    }
    const Rational square = dot(q, q) * (a1[0] * a1[0] + a1[1] * a1[1] + a1[2] * a1[2]);
    frame_.add_equation(e(0).name, component(a1, v0) + e(other_).unknown * component(a1, v2) +
                                       e(0).unknown * (Coefficient{square, 0} * N));
  }

  SpatialFrame& frame_;
  const JointLoop& loop_;
  std::vector<std::size_t> turns_;
  std::size_t other_ = 0;  ///< S_2's number; S_1 is number 0
  std::array<Polynomial, 4> c_, d_;
};

}  // namespace

std::optional<JointLoop> begun_with_slide(const JointLoop& loop) {
  // Dyads of turns that are nearer to parallel have coordinates that differ by rounding.
  constexpr double kParallel = 1e-3;
  if (turns_of(loop).size() != kTurns || loop.elements.size() != kTurns + kSlides)
    return std::nullopt;
  std::optional<JointLoop> best;
  double merit = kParallel;
  for (JointLoop& way : all_ways(loop)) {
    if (way.elements.front().is_turn) continue;
    const std::vector<std::size_t> turns = turns_of(way);
    const auto& all = way.elements;
    const double least =
        std::min(sine(all[turns[0]], all[turns[1]]), sine(all[turns[2]], all[turns[3]]));
    if (least <= merit) continue;
    merit = least;
    best = std::move(way);
  }
  return best;
}

void add_four_turns(SpatialFrame& frame, const JointLoop& begun) { FourTurns(frame, begun).add(); }

}  // namespace moivre

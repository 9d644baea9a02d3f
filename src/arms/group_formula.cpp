// SPDX-License-Identifier: MIT
// Quadratics in cosines and sines, real as long as their roots are; a quartic where neighbouring
// axes are skew.
#include "group_formula.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "exact_motion.h"

namespace moivre {
namespace {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// e_1 and e_2 are dependent; lengths count relative to the arm's.
constexpr double kDependent = 1e-9;

/// Cosine and sine of a joint's value.
template <class S>
struct Turn {
  S c, s;
};

template <class T, class S>
Turn<T> in(const Turn<S>& turn) {
  return {T(turn.c), T(turn.s)};
}

JointLink operator*(const JointLink& a, const JointLink& b) { return {a.R * b.R, a.R * b.t + a.t}; }
JointLink inverse(const JointLink& a) { return {a.R.transpose(), -(a.R.transpose() * a.t)}; }

JointLink link_of(const ExactDisplacement& exact, double length) {
  const RealDisplacement g = rounded(exact);
  const Eigen::Quaterniond turn(g.q[0], g.q[1], g.q[2], g.q[3]);
  const Quaternion<double> shift = shift_of(g);
  return {turn.normalized().toRotationMatrix(),
          Eigen::Vector3d(shift[1], shift[2], shift[3]) / length};
}

/// A turn that takes z to the axis.
JointLink onto(const Eigen::Vector3d& axis) {
  return {Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix(),
          Eigen::Vector3d::Zero()};
}

PointOrPlane moved(const JointLink& by, const PointOrPlane& what, bool is_point) {
  PointOrPlane there{by.R * what.v, what.offset};
  if (is_point) {
    there.v += by.t;
  } else {
    there.offset += there.v.dot(by.t);
  }
  return there;
}

/// A turn about z, real or complex.
template <class S>
Vector3<S> turned(const Turn<S>& by, const Vector3<S>& v) {
  return {by.c * v.x() - by.s * v.y(), by.s * v.x() + by.c * v.y(), v.z()};
}

/// About z, what takes v to u.
template <class S>
Turn<S> turn_between(const Vector3<S>& v, const Vector3<S>& u) {
  const S across = v.x() * v.x() + v.y() * v.y();
  return {(v.x() * u.x() + v.y() * u.y()) / across, (v.x() * u.y() - v.y() * u.x()) / across};
}

/// Both turns with A cos + B sin = C; of two that are conjugate the first.
template <class F>
void for_each_turn(double A, double B, double C, const F& take) {
  const double square = A * A + B * B;
  const double rest = square - C * C;
  const double c = A * C / square, s = B * C / square;
  if (rest < 0) {
    const double far = std::sqrt(-rest) / square;
    take(Turn<Complex>{{c, -B * far}, {s, A * far}});
    return;
  }
  const double far = std::sqrt(rest) / square;
  take(Turn<double>{c - B * far, s + A * far});
  take(Turn<double>{c + B * far, s - A * far});
}

template <class F>
void for_each_turn(Complex A, Complex B, Complex C, const F& take) {
  const Complex square = A * A + B * B;
  const Complex far = std::sqrt(square - C * C) / square;
  const Complex c = A * C / square, s = B * C / square;
  take(Turn<Complex>{c - B * far, s + A * far});
  take(Turn<Complex>{c + B * far, s - A * far});
}

double angle(const Turn<double>& turn) { return std::atan2(turn.s, turn.c); }
Complex angle(const Turn<Complex>& turn) {
  const Complex i(0, 1);
  return -i * std::log(turn.c + i * turn.s);
}

/// The joints outside, in the order in which they are found, and what is known of the loop at one
/// pose.
struct Outside {
  std::array<JointLink, 4> D;
  Vector3<double> v;  ///< what is taken to `target`
  PointOrPlane target;
  Eigen::Matrix3d y;                    ///< columns: of 1, cos c, sin c
  std::array<Eigen::RowVector3d, 2> f;  ///< likewise
  std::array<Eigen::Vector2d, 2> e;
};

std::array<Eigen::Vector2d, 2> constraints_of(const JointLink& between) {
  return {Eigen::Vector2d((between.R.transpose() * between.t).head<2>()),
          Eigen::Vector2d(between.R.row(2).head<2>().transpose())};
}

bool are_dependent(const std::array<Eigen::Vector2d, 2>& e) {
  return std::abs(e[0].x() * e[1].y() - e[0].y() * e[1].x()) <= kDependent;
}

Outside outside_of(const GroupFormula& formula, const Eigen::Isometry3d& pose) {
  Outside at;
  const JointLink tip{pose.linear(), pose.translation() / formula.length};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t joint = (formula.first + 3 + k) % 6;
    at.D[k] = formula.before[joint];
    if (joint == 0) at.D[k] = formula.tip * inverse(tip) * at.D[k];
  }
  PointOrPlane begin = formula.kept_before, end = formula.kept_behind;
  if (formula.is_backwards) {
    at.D = {inverse(at.D[3]), inverse(at.D[2]), inverse(at.D[1]), inverse(at.D[0])};
    std::swap(begin, end);
  }
  const bool is_point = formula.is_wrist;
  const PointOrPlane moving = moved(at.D[3], begin, is_point);
  at.v = moving.v;
  at.target = moved(inverse(at.D[0]), end, is_point);
  const auto& [R1, t1] = at.D[1];
  const auto& [R2, t2] = at.D[2];
  at.y << R2.col(2) * at.v.z(), R2.col(0) * at.v.x() + R2.col(1) * at.v.y(),
      R2.col(1) * at.v.x() - R2.col(0) * at.v.y();
  if (is_point) at.y.col(0) += t2;
  at.e = constraints_of(at.D[1]);
  const double along = (R1.transpose() * t1).z();
  at.f[0] = -t2.transpose() * at.y - along * at.y.row(2);
  at.f[1] = -R1(2, 2) * at.y.row(2);
  if (is_point) {
    const Eigen::Vector3d& p = at.target.v;
    at.f[0][0] += (p.squaredNorm() - t1.squaredNorm() - at.v.squaredNorm() + t2.squaredNorm()) / 2;
    at.f[1][0] += p.z() - t1.z();
  } else {
    at.f[0][0] += at.target.offset - moving.offset;
    at.f[1][0] += at.target.v.z();
  }
  return at;
}

/// The value of a row, or of a matrix's columns, at a turn of c.
template <class S>
S value_at(const Eigen::RowVector3d& row, const Turn<S>& c) {
  return row[0] + row[1] * c.c + row[2] * c.s;
}
template <class S>
Vector3<S> vector_at(const Eigen::Matrix3d& columns, const Turn<S>& c) {
  return {value_at<S>(columns.row(0), c), value_at<S>(columns.row(1), c),
          value_at<S>(columns.row(2), c)};
}

template <class S>
Vector3<S> product(const Eigen::Matrix3d& R, const Vector3<S>& v) {
  return {R(0, 0) * v.x() + R(0, 1) * v.y() + R(0, 2) * v.z(),
          R(1, 0) * v.x() + R(1, 1) * v.y() + R(1, 2) * v.z(),
          R(2, 0) * v.x() + R(2, 1) * v.y() + R(2, 2) * v.z()};
}

/// R and then about z.
template <class S>
Matrix3<S> then_turned(const Eigen::Matrix3d& R, const Turn<S>& by) {
  Matrix3<S> product;
  for (Eigen::Index k = 0; k < 3; ++k) {
    product(k, 0) = R(k, 0) * by.c + R(k, 1) * by.s;
    product(k, 1) = R(k, 1) * by.c - R(k, 0) * by.s;
    product(k, 2) = R(k, 2);
  }
  return product;
}

/// What the group must do.
template <class S>
struct Wanted {
  Matrix3<S> R;
  Vector3<S> t;
};

/// D_0 J_a D_1 J_b D_2 J_c D_3, backwards.
template <class S>
Wanted<S> wanted_of(const Outside& at, const std::array<Turn<S>, 3>& abc, bool is_backwards) {
  Matrix3<S> R = then_turned<S>(at.D[0].R, abc[0]);
  Vector3<S> t = at.D[0].t.cast<S>();
  for (std::size_t k = 1; k < 4; ++k) {
    t += R * at.D[k].t.cast<S>();
    const Matrix3<S> next =
        k < 3 ? then_turned<S>(at.D[k].R, abc[k]) : Matrix3<S>(at.D[k].R.cast<S>());
    R = (R * next).eval();
  }
  // Backwards the product is that of the inverse already.
  if (is_backwards) return {R, t};
  const Matrix3<S> back = R.transpose();
  return {back, -(back * t)};
}

template <class S>
void add(const GroupFormula& formula, const std::array<Turn<S>, 3>& group,
         const std::array<Turn<S>, 3>& abc, ProposedClosures& proposed) {
  constexpr bool is_real = std::is_same_v<S, double>;
  std::size_t& count = is_real ? proposed.reals : proposed.pair_count;
  if (count == ProposedClosures::kMost) return;
  const auto put = [&](auto& values) {
    for (std::size_t k = 0; k < 3; ++k) {
      values[static_cast<Eigen::Index>(formula.first + k)] = angle(group[k]);
      const std::size_t place = formula.is_backwards ? 2 - k : k;
      const S value = angle(abc[place]);
      const std::size_t joint = (formula.first + 3 + k) % 6;
      values[static_cast<Eigen::Index>(joint)] = formula.is_backwards ? -value : value;
    }
  };
  if constexpr (is_real) {
    put(proposed.real[count++]);
  } else {
    put(proposed.pairs[count++]);
  }
}

/// The group's joints: the middle one first.
template <class S>
void solve_group(const GroupFormula& formula, const Outside& at, const std::array<Turn<S>, 3>& abc,
                 ProposedClosures& proposed) {
  const Wanted<S> wanted = wanted_of<S>(at, abc, formula.is_backwards);
  const JointLink& to_middle = formula.before[formula.first + 1];
  const JointLink& to_last = formula.before[formula.first + 2];
  const Eigen::Matrix3d &R1 = to_middle.R, &R2 = to_last.R;
  const Eigen::Vector3d& t1 = to_middle.t;
  const bool is_wrist = formula.is_wrist;
  // Axis 3 in the frame of axis 1: its direction; or its place in the plane.
  const Eigen::Vector3d end = is_wrist ? Eigen::Vector3d(R2.col(2)) : to_last.t;
  const Vector3<S> there = is_wrist ? Vector3<S>(wanted.R.col(2)) : wanted.t;
  S A, B, C;
  if (is_wrist) {
    A = R1(2, 0) * end.x() + R1(2, 1) * end.y();
    B = R1(2, 1) * end.x() - R1(2, 0) * end.y();
    C = there.z() - R1(2, 2) * end.z();
  } else {
    const Eigen::Vector3d e = R1.transpose() * t1 - R1.row(2).transpose() * t1.z();
    A = e.x() * end.x() + e.y() * end.y();
    B = e.y() * end.x() - e.x() * end.y();
    C = (there.x() * there.x() + there.y() * there.y() - t1.head<2>().squaredNorm() -
         end.head<2>().squaredNorm()) /
        2.0;
  }
  for_each_turn(A, B, C, [&](const auto& middle) {
    using T = std::remove_cvref_t<decltype(middle.c)>;
    const std::array<Turn<T>, 3> others{in<T>(abc[0]), in<T>(abc[1]), in<T>(abc[2])};
    Vector3<T> from = product<T>(R1, turned<T>(middle, end.cast<T>()));
    if (!is_wrist) from += t1.cast<T>();
    const Turn<T> first = turn_between<T>(from, there.template cast<T>());
    // What the last joint does to its own x.
    const Turn<T> back{first.c, -first.s};
    Vector3<T> x = turned<T>(back, wanted.R.col(0).template cast<T>());
    x = turned<T>({middle.c, -middle.s}, product<T>(R1.transpose(), x));
    x = product<T>(R2.transpose(), x);
    add<T>(formula, {first, middle, Turn<T>{x.x(), x.y()}}, others, proposed);
  });
}

template <class S>
void solve_first(const GroupFormula& formula, const Outside& at, const Vector3<S>& y,
                 const Turn<S>& b, const Turn<S>& c, ProposedClosures& proposed) {
  Vector3<S> there = product<S>(at.D[1].R, turned<S>(b, y));
  if (formula.is_wrist) there += at.D[1].t.cast<S>();
  const Turn<S> a = turn_between<S>(there, at.target.v.cast<S>());
  solve_group<S>(formula, at, {a, b, c}, proposed);
}

/// e_1 and e_2 dependent: two quadratics.
void solve_dependent(const GroupFormula& formula, const Outside& at, ProposedClosures& proposed) {
  const std::size_t large = at.e[0].squaredNorm() > at.e[1].squaredNorm() ? 0 : 1;
  const Eigen::Vector2d& e = at.e[large];
  const double share = at.e[1 - large].dot(e) / e.squaredNorm();
  const Eigen::RowVector3d alone = at.f[1 - large] - share * at.f[large];
  for_each_turn(alone[1], alone[2], -alone[0], [&](const auto& c) {
    using S = std::remove_cvref_t<decltype(c.c)>;
    const Vector3<S> y = vector_at<S>(at.y, c);
    for_each_turn(S(e.x() * y.x() + e.y() * y.y()), S(e.y() * y.x() - e.x() * y.y()),
                  value_at<S>(at.f[large], c), [&](const auto& b) {
                    using T = std::remove_cvref_t<decltype(b.c)>;
                    solve_first<T>(formula, at, y.template cast<T>(), b, in<T>(c), proposed);
                  });
  });
}

/// Roots of a_0 + ... + a_4 t^4, by Aberth's iteration.
std::array<Complex, 4> quartic_roots(const std::array<double, 5>& a) {
  constexpr int kMost = 60;
  constexpr double kSettled = 1e-15;
  const double size = std::pow(std::abs(a[0] / a[4]), 0.25) + 1e-3;
  std::array<Complex, 4> roots;
  for (std::size_t k = 0; k < 4; ++k) {
    roots[k] = std::polar(size, 0.4 + std::numbers::pi / 2 * static_cast<double>(k));
  }
  for (int i = 0; i < kMost; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Complex t = roots[k];
      const Complex p = a[0] + t * (a[1] + t * (a[2] + t * (a[3] + t * a[4])));
      const Complex slope = a[1] + t * (2 * a[2] + t * (3 * a[3] + t * (4 * a[4])));
      Complex repelled = slope;
      for (std::size_t j = 0; j < 4; ++j) {
        if (j != k) repelled -= p / (t - roots[j]);
      }
      const Complex step = p / repelled;
      roots[k] -= step;
      largest = std::max(largest, std::norm(step) / (1 + std::norm(t)));
    }
    if (!(largest > kSettled * kSettled)) break;
  }
  return roots;
}

/// The quadratic form q of (1, cos, sin) that is 0: a quartic in the half-angle's tangent, counted
/// from where the form is not small opposite.
struct TangentQuartic {
  std::array<double, 5> a;
  Turn<double> zero;
};
TangentQuartic tangent_quartic(const Eigen::Matrix3d& q) {
  constexpr int kTried = 5;  // the form has four zeros
  TangentQuartic best{{}, {1, 0}};
  double largest = -1;
  for (int k = 0; k < kTried; ++k) {
    const double at = 2 * std::numbers::pi * k / kTried + 0.1;
    const Eigen::Vector3d opposite(1, -std::cos(at), -std::sin(at));
    const double size = std::abs(opposite.dot(q * opposite));
    if (size > largest) largest = size, best.zero = {std::cos(at), std::sin(at)};
  }
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.bottomRightCorner<2, 2>() << best.zero.c, -best.zero.s, best.zero.s, best.zero.c;
  const Eigen::Matrix3d t = turn.transpose() * q * turn;
  best.a = {t(0, 0) + t(1, 1) + 2 * t(0, 1), 4 * t(0, 2) + 4 * t(1, 2),
            2 * t(0, 0) - 2 * t(1, 1) + 4 * t(2, 2), 4 * t(0, 2) - 4 * t(1, 2),
            t(0, 0) + t(1, 1) - 2 * t(0, 1)};
  return best;
}

template <class S>
Turn<S> turn_of_tangent(const S& t, const Turn<double>& zero) {
  const S length = 1.0 + t * t;
  const S c = (1.0 - t * t) / length, s = 2.0 * t / length;
  return {zero.c * c - zero.s * s, zero.s * c + zero.c * s};
}

/// e_1 and e_2 independent: a quartic.
void solve_independent(const GroupFormula& formula, const Outside& at, ProposedClosures& proposed) {
  constexpr double kReal = 1e-8;
  Eigen::Matrix2d E;
  E << at.e[0].transpose(), at.e[1].transpose();
  Eigen::Matrix<double, 2, 3> f;
  f << at.f[0], at.f[1];
  const Eigen::Matrix<double, 2, 3> g = E.inverse() * f;
  const Eigen::Matrix<double, 2, 3> y = at.y.topRows<2>();
  const TangentQuartic quartic = tangent_quartic(g.transpose() * g - y.transpose() * y);
  const auto take = [&](const auto& t) {
    using S = std::remove_cvref_t<decltype(t)>;
    const Turn<S> c = turn_of_tangent<S>(t, quartic.zero);
    const Vector3<S> from = vector_at<S>(at.y, c);
    const Vector3<S> to{value_at<S>(g.row(0), c), value_at<S>(g.row(1), c), from.z()};
    solve_first<S>(formula, at, from, turn_between<S>(from, to), c, proposed);
  };
  for (const Complex& root : quartic_roots(quartic.a)) {
    if (std::abs(root.imag()) <= kReal * (1 + std::abs(root))) {
      take(root.real());
    } else if (root.imag() > 0) {
      take(root);
    }
  }
}

/// The point that all turns of a wrist leave, in the frame of its first joint.
Eigen::Vector3d meeting_point(const std::array<JointLink, 2>& behind) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  JointLink at;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) at = at * behind[k - 1];
    const Eigen::Vector3d axis = at.R.col(2);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
    sum += across;
    side += across * at.t;
  }
  return sum.inverse() * side;
}

void find_kept(GroupFormula& formula) {
  constexpr double kParallel = 1e-9;
  const std::array<JointLink, 2> behind{formula.before[formula.first + 1],
                                        formula.before[formula.first + 2]};
  const JointLink all = behind[0] * behind[1];
  const auto tilt = [](const JointLink& link) { return link.R.col(2).head<2>().norm(); };
  formula.is_wrist = tilt(behind[0]) > kParallel || tilt(behind[1]) > kParallel;
  if (formula.is_wrist) {
    formula.kept_before.v = meeting_point(behind);
    formula.kept_behind.v = all.R.transpose() * (formula.kept_before.v - all.t);
  } else {
    formula.kept_before = {Eigen::Vector3d::UnitZ(), 0};
    formula.kept_behind = {all.R.transpose() * Eigen::Vector3d::UnitZ(), -all.t.z()};
  }
}

}  // namespace

std::optional<GroupFormula> group_formula(const Arm& arm, const Cut& cut) {
  constexpr std::size_t kSix = 6;
  if (cut.kind != CutKind::three || arm.joints.size() != kSix) return std::nullopt;
  GroupFormula formula;
  formula.length = arm.length;
  formula.first = cut.inside.front();
  JointLink behind;  // what is behind the last joint's turn, in its frame
  for (std::size_t k = 0; k < kSix; ++k) {
    const ArmJoint& joint = arm.joints[k];
    if (joint.is_slide) return std::nullopt;
    const JointLink own = onto(joint.axis);
    formula.before[k] = behind * link_of(*joint.exact_before, arm.length) * own;
    behind = inverse(own);
  }
  formula.tip = behind * link_of(*arm.exact_tool, arm.length);
  find_kept(formula);
  // The pose is in the link before joint 0: where that is the one between the first two joints
  // outside, nothing is known of it.
  const auto dependent_at = [&](std::size_t joint) {
    return joint != 0 && are_dependent(constraints_of(formula.before[joint]));
  };
  const std::size_t b = (formula.first + 4) % kSix, c = (formula.first + 5) % kSix;
  formula.is_backwards = !dependent_at(b) && c != 0 &&
                         (b == 0 || are_dependent(constraints_of(inverse(formula.before[c]))));
  return formula;
}

ProposedClosures proposed_closures(const GroupFormula& formula, const Eigen::Isometry3d& pose) {
  ProposedClosures proposed;
  const Outside at = outside_of(formula, pose);
  if (are_dependent(at.e)) {
    solve_dependent(formula, at, proposed);
  } else {
    solve_independent(formula, at, proposed);
  }
  return proposed;
}

}  // namespace moivre

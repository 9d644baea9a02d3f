// SPDX-License-Identifier: MIT
// In which six-bars does a branch live for an instant only, and when exactly is it born and when
// does it die?
//
// A Watt or Stephenson chain with random joints, a random ground link and a driven neighbour.
// F(theta, tau) are its two loops, theta the four other links' angles and tau the driver's. One
// binary link is 1 + lambda times as long as drawn. lambda is sought where two dead points coincide
// (F_theta n = 0, v' F_theta = 0, |n| = |v| = 1):
//   island      v' [F_theta F_tau] = 0, its second derivative definite: two branches, between the
//               same dead points
//   gap         the same, not definite: the branches that are there before and after are apart for
//               a moment
//   fold-back   v' F_theta,theta n n = 0 (a cusp): a branch between two others, born where the one
//               dies that ends later
// From there lambda goes back until the dead points are `life` apart. They are zeros of [F, F_theta
// w, |w|^2 - 1], by Newton's method in extended precision, with the link as long as the file has
// it. Nothing of the program's own kinematics is used.
// theta: 4; y = (theta, tau): 5; F: 4; angles in radians, tau - start is the time in seconds.
// Source: [GolubitskySchaeffer85] has the three singularities by these names: isola, simple
// bifurcation, hysteresis.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "../mechanism/files.h"
#include "linkage_sketch.h"
#include "moivre/report/number_text.h"

namespace moivre::test {

using Fine = long double;
using FineVector = Eigen::Matrix<Fine, Eigen::Dynamic, 1>;
using FineMatrix = Eigen::Matrix<Fine, Eigen::Dynamic, Eigen::Dynamic>;

enum class BriefKind { island, gap, fold_back };

/// Two ternary links joined by three chains of binary ones, in a drawn pose.
struct SixBar {
  static constexpr std::size_t kLinks = 6;

  /// From link 0 to link 1: joints in turn, each beginning a new link. Three chains.
  struct Chain {
    std::vector<std::size_t> links;             ///< binary links on the way
    std::vector<std::array<double, 2>> joints;  ///< one more than these
  };
  std::array<Chain, 3> chains;
  std::size_t ground = 0;
  std::size_t driven = 1;
  std::size_t stretched = 2;  ///< the binary link whose length varies
  /// Where the stretched link has its second joint.
  std::array<double, 2> end{};

  /// Where it has its first one.
  const std::array<double, 2>& from() const {
    for (const Chain& chain : chains) {
      for (std::size_t k = 0; k < chain.links.size(); ++k) {
        if (chain.links[k] == stretched) return chain.joints[k];
      }
    }
    throw std::logic_error("the stretched link is no binary one");
  }
};

/// F and its derivatives at one point. Complex rows: two loops.
class SixBarLoops {
 public:
  explicit SixBarLoops(const SixBar& bar) {
    for (std::size_t link = 0; link < SixBar::kLinks; ++link) {
      if (link != bar.ground && link != bar.driven) order_.push_back(link);
    }
    order_.push_back(bar.driven);
    arm_.fill({Complex2(0, 0), Complex2(0, 0)});
    stretch_ = {Complex2(0, 0), Complex2(0, 0)};
    for (std::size_t c = 0; c < bar.chains.size(); ++c) add_chain(bar, c);
    ground_ = arm_[bar.ground];
    stretched_ = bar.stretched;
  }

  FineVector value(const FineVector& y, Fine lambda) const {
    std::array<Complex2, 2> sum = ground_;
    for (std::size_t k = 0; k < order_.size(); ++k) {
      for (std::size_t loop = 0; loop < 2; ++loop) sum[loop] += turned(k, y, lambda)[loop];
    }
    return rows(sum);
  }
  /// 4 x 5.
  FineMatrix jacobian(const FineVector& y, Fine lambda) const {
    return columns(y, lambda, Complex2(0, 1));
  }
  /// The second derivatives by y_k twice, 4 x 5; mixed ones are 0.
  FineMatrix second(const FineVector& y, Fine lambda) const {
    return columns(y, lambda, Complex2(-1, 0));
  }
  FineVector by_lambda(const FineVector& y) const { return value(y, 1) - value(y, 0); }

 private:
  using Complex2 = std::complex<Fine>;

  void add_chain(const SixBar& bar, std::size_t c) {
    const SixBar::Chain& chain = bar.chains[c];
    const auto at = [&](std::size_t k) { return Complex2(chain.joints[k][0], chain.joints[k][1]); };
    // The first chain is in both loops, the others in one each, the other way.
    const auto add = [&](std::size_t link, const Complex2& z, std::array<Complex2, 2>* extra) {
      for (std::size_t loop = 0; loop < 2; ++loop) {
        const Fine sign = c == 0 ? 1 : c == loop + 1 ? -1 : 0;
        (extra == nullptr ? arm_[link] : *extra)[loop] += sign * z;
      }
    };
    add(0, at(0), nullptr);
    for (std::size_t k = 0; k < chain.links.size(); ++k) {
      const std::size_t link = chain.links[k];
      add(link, at(k + 1) - at(k), nullptr);
      if (link != bar.stretched) continue;
      add(link, at(k + 1) - at(k), &stretch_);
    }
    add(1, -at(chain.links.size()), nullptr);
  }

  std::array<Complex2, 2> turned(std::size_t k, const FineVector& y, Fine lambda) const {
    const std::size_t link = order_[k];
    const Complex2 turn = std::polar<Fine>(1, y[static_cast<Eigen::Index>(k)]);
    std::array<Complex2, 2> z = arm_[link];
    for (std::size_t loop = 0; loop < 2; ++loop) {
      if (link == stretched_) z[loop] += lambda * stretch_[loop];
      z[loop] *= turn;
    }
    return z;
  }

  FineMatrix columns(const FineVector& y, Fine lambda, const Complex2& factor) const {
    FineMatrix J(4, 5);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      auto z = turned(k, y, lambda);
      for (Complex2& part : z) part *= factor;
      J.col(static_cast<Eigen::Index>(k)) = rows(z);
    }
    return J;
  }

  static FineVector rows(const std::array<Complex2, 2>& z) {
    FineVector r(4);
    r << z[0].real(), z[0].imag(), z[1].real(), z[1].imag();
    return r;
  }

  std::vector<std::size_t> order_;  ///< the link of each y_k
  std::array<std::array<Complex2, 2>, SixBar::kLinks> arm_{};
  std::array<Complex2, 2> stretch_{};
  std::array<Complex2, 2> ground_{};
  std::size_t stretched_ = 0;
};

/// Newton's method, with the least correction where the Jacobian is not square. nullopt: it does
/// not converge.
template <class System>
std::optional<FineVector> fine_newton(const System& system, FineVector x) {
  constexpr int kMostSteps = 60;
  constexpr Fine kConverged = 1e-17L;
  constexpr Fine kFar = 1e3L;
  Fine before = kFar;
  for (int k = 0; k < kMostSteps; ++k) {
    FineVector f;
    FineMatrix J;
    system(x, f, J);
    const FineVector step = J.completeOrthogonalDecomposition().solve(-f);
    x += step;
    const Fine size = step.norm();
    if (!(size < kFar)) return std::nullopt;
    // Converged, or no better for a rounding error.
    constexpr Fine kNearly = 1e-12L;
    if (size <= kConverged || (size <= kNearly && size >= before / 2)) return x;
    before = size;
  }
  return std::nullopt;
}

/// A six-bar with a short life, and the times of its two dead points.
struct BriefLife {
  SixBar bar;
  BriefKind kind = BriefKind::island;
  double start = 0;               ///< of the driver, rad
  std::array<double, 2> times{};  ///< of the dead points, seconds, ascending
};

/// The motion's duration: one turn of the driver at 1 rad/s.
inline constexpr double kTurn_s = 2 * std::numbers::pi;

class BriefLifeDrawer {
 public:
  explicit BriefLifeDrawer(Draw draw) : draw_(draw) {}

  /// Dead points that are `share` of the turn apart.
  BriefLife draw(BriefKind kind, double share) {
    for (;;) {
      draw_bar();
      const SixBarLoops loops(bar_);
      const auto centre = kind == BriefKind::fold_back ? cusp(loops) : meeting(loops, kind);
      if (!centre) continue;
      const auto pair = pair_of_life(loops, *centre, static_cast<Fine>(share * kTurn_s));
      if (!pair) continue;
      if (const auto brief = rounded(*pair, kind)) return *brief;
    }
  }

 private:
  /// Where two dead points coincide, and how they part: y +- e way, e small.
  struct Centre {
    bool is_cusp = false;
    FineVector y;
    Fine lambda = 0;
    FineVector way;
    Fine square = 0;  ///< lambda's change is square e^2; at a cusp not known
  };
  /// Two dead points at one lambda.
  struct Pair {
    Fine lambda = 0;
    std::array<FineVector, 2> y;
    Fine life() const { return std::abs(y[0][4] - y[1][4]); }
  };

  double coordinate() { return 2 * draw_.unit() - 1; }

  void draw_bar() {
    bar_ = {};
    const bool is_watt = draw_.unit() < 0.5;
    const std::array<std::size_t, 3> binaries =
        is_watt ? std::array<std::size_t, 3>{0, 2, 2} : std::array<std::size_t, 3>{1, 1, 2};
    std::array<std::vector<std::size_t>, SixBar::kLinks> beside;
    std::size_t link = 2;
    for (std::size_t c = 0; c < 3; ++c) {
      SixBar::Chain& chain = bar_.chains[c];
      for (std::size_t k = 0; k < binaries[c]; ++k) chain.links.push_back(link++);
      std::size_t last = 0;
      for (std::size_t k = 0; k <= chain.links.size(); ++k) {
        chain.joints.push_back({coordinate(), coordinate()});
        const std::size_t next = k < chain.links.size() ? chain.links[k] : 1;
        beside[last].push_back(next);
        beside[next].push_back(last);
        last = next;
      }
    }
    bar_.ground = draw_.below(SixBar::kLinks);
    bar_.driven = beside[bar_.ground][draw_.below(beside[bar_.ground].size())];
    do {
      bar_.stretched = 2 + draw_.below(SixBar::kLinks - 2);
    } while (bar_.stretched == bar_.ground);
    for (const SixBar::Chain& chain : bar_.chains) {
      for (std::size_t k = 0; k < chain.links.size(); ++k) {
        if (chain.links[k] == bar_.stretched) bar_.end = chain.joints[k + 1];
      }
    }
  }

  FineVector random_unit_vector(Eigen::Index size) {
    FineVector v(size);
    for (Eigen::Index k = 0; k < size; ++k) v[k] = coordinate();
    return v.normalized();
  }

  FineVector random_y() {
    FineVector y(5);
    for (Eigen::Index k = 0; k < 5; ++k) y[k] = std::numbers::pi * coordinate();
    return y;
  }

  /// x = (y, lambda, v): F, v' DF and |v|^2 - 1.
  std::optional<Centre> meeting(const SixBarLoops& loops, BriefKind kind) {
    const auto system = [&](const FineVector& x, FineVector& f, FineMatrix& J) {
      const FineVector y = x.head(5);
      const FineVector v = x.tail(4);
      const FineMatrix D = loops.jacobian(y, x[5]);
      f.resize(10);
      f << loops.value(y, x[5]), D.transpose() * v, v.squaredNorm() - 1;
      J = FineMatrix::Zero(10, 10);
      J.block(0, 0, 4, 5) = D;
      J.block(0, 5, 4, 1) = loops.by_lambda(y);
      J.block(4, 0, 5, 5) = (loops.second(y, x[5]).transpose() * v).asDiagonal();
      J.block(4, 5, 5, 1) = (loops.jacobian(y, 1) - loops.jacobian(y, 0)).transpose() * v;
      J.block(4, 6, 5, 4) = D.transpose();
      J.block(9, 6, 1, 4) = 2 * v.transpose();
    };
    FineVector x(10);
    x << random_y(), 0, random_unit_vector(4);
    const auto found = fine_newton(system, x);
    if (!found || !is_sane((*found)[5])) return std::nullopt;
    const FineVector y = found->head(5);
    const FineVector v = found->tail(4);
    const FineMatrix rows = loops.jacobian(y, (*found)[5]).transpose();
    const auto qr = rows.colPivHouseholderQr();
    if (qr.rank() != 3) return std::nullopt;
    const FineMatrix Z = (qr.householderQ() * FineMatrix::Identity(5, 5)).rightCols(2);
    const Eigen::Matrix<Fine, 2, 2> Q =
        Z.transpose() * (loops.second(y, (*found)[5]).transpose() * v).asDiagonal() * Z;
    const Fine g = v.dot(loops.by_lambda(y));
    const FineVector n = Z.row(4).transpose();
    const FineVector to = Q.inverse() * n;
    const Fine det = Q.determinant();
    const Fine reach = n.dot(to);
    const bool is_island = det > 0;
    if (is_island != (kind == BriefKind::island)) return std::nullopt;
    // Well formed: neither nearly a cusp nor nearly independent of the link.
    constexpr Fine kClear = 0.02L;
    if (std::abs(det) < kClear || std::abs(g) < kClear || n.norm() < kClear ||
        std::abs(reach) < kClear) {
      return std::nullopt;
    }
    // The dead points of z' Q z = c, c = -2 g (lambda - lambda*): z = +- Q^-1 n e with c = reach
    // e^2.
    return Centre{false, y, (*found)[5], Z * to, -reach / (2 * g)};
  }

  /// x = (y, lambda, n, v): F, F_theta n, v' F_theta, |n|^2 - 1, |v|^2 - 1, v' F_theta,theta n n.
  std::optional<Centre> cusp(const SixBarLoops& loops) {
    const auto system = [&](const FineVector& x, FineVector& f, FineMatrix& J) {
      f = cusp_value(loops, x);
      J.resize(f.size(), x.size());
      // The value is analytic: differences in extended precision leave Newton's method nearly
      // quadratic.
      constexpr Fine kStep = 1e-7L;
      for (Eigen::Index k = 0; k < x.size(); ++k) {
        const FineVector way = kStep * FineVector::Unit(x.size(), k);
        J.col(k) = (cusp_value(loops, x + way) - cusp_value(loops, x - way)) / (2 * kStep);
      }
    };
    FineVector x(14);
    x << random_y(), 0, random_unit_vector(4), random_unit_vector(4);
    const auto found = fine_newton(system, x);
    if (!found || !is_sane((*found)[5]) || cusp_value(loops, *found).norm() > 1e-14L)
      return std::nullopt;
    Centre centre{true, found->head(5), (*found)[5], FineVector::Zero(5), 0};
    centre.way.head(4) = found->segment(6, 4);
    return centre;
  }

  static FineVector cusp_value(const SixBarLoops& loops, const FineVector& x) {
    const FineVector y = x.head(5);
    const FineVector n = x.segment(6, 4);
    const FineVector v = x.tail(4);
    const FineMatrix D = loops.jacobian(y, x[5]).leftCols(4);
    const FineMatrix S = loops.second(y, x[5]).leftCols(4);
    FineVector f(15);
    f << loops.value(y, x[5]), D * n, D.transpose() * v, n.squaredNorm() - 1, v.squaredNorm() - 1,
        v.dot(S * n.cwiseAbs2());
    return f;
  }

  /// The stretched link is not turned round, nor much longer than drawn.
  static bool is_sane(Fine lambda) { return lambda > -0.7L && lambda < 2; }

  /// The dead point (y, lambda, w) beside y and lambda at which row . (y, lambda) = value.
  static std::optional<FineVector> fold(const SixBarLoops& loops, const FineVector& y, Fine lambda,
                                        const FineVector& row, Fine value) {
    const auto system = [&](const FineVector& x, FineVector& f, FineMatrix& J) {
      const FineVector at = x.head(5);
      const FineVector w = x.tail(4);
      const FineMatrix D = loops.jacobian(at, x[5]);
      f.resize(10);
      f << loops.value(at, x[5]), D.leftCols(4) * w, w.squaredNorm() - 1,
          row.dot(x.head(6)) - value;
      J = FineMatrix::Zero(10, 10);
      J.block(0, 0, 4, 5) = D;
      J.block(0, 5, 4, 1) = loops.by_lambda(at);
      J.block(4, 0, 4, 4) = loops.second(at, x[5]).leftCols(4) * w.asDiagonal();
      J.block(4, 5, 4, 1) = (loops.jacobian(at, 1) - loops.jacobian(at, 0)).leftCols(4) * w;
      J.block(4, 6, 4, 4) = D.leftCols(4);
      J.block(8, 6, 1, 4) = 2 * w.transpose();
      J.block(9, 0, 1, 6) = row.transpose();
    };
    FineVector x(10);
    const FineMatrix rows = loops.jacobian(y, lambda).leftCols(4).transpose();
    const FineMatrix null = rows.colPivHouseholderQr().householderQ() * FineMatrix::Identity(4, 4);
    x << y, lambda, null.col(3);
    return fine_newton(system, x);
  }

  static std::optional<FineVector> fold_at(const SixBarLoops& loops, const FineVector& y,
                                           Fine lambda) {
    return fold(loops, y, lambda, FineVector::Unit(6, 5), lambda);
  }

  /// Both dead points where what is small is e.
  static std::optional<Pair> pair_at(const SixBarLoops& loops, const Centre& centre, Fine e) {
    Pair pair;
    pair.lambda = centre.lambda + centre.square * e * e;
    std::array<FineVector, 2> guess{centre.y + e * centre.way, centre.y - e * centre.way};
    if (centre.is_cusp) {
      FineVector row(6);
      row << centre.way, 0;
      const auto first = fold(loops, guess[0], centre.lambda, row, centre.way.dot(centre.y) + e);
      if (!first) return std::nullopt;
      guess[0] = first->head(5);
      pair.lambda = (*first)[5];
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = fold_at(loops, guess[k], pair.lambda);
      if (!found || (found->head(5) - guess[k]).norm() > e * centre.way.norm()) return std::nullopt;
      pair.y[k] = found->head(5);
    }
    return pair;
  }

  /// The dead points that are `life` apart, within a part of it: what is small is changed until
  /// they are.
  static std::optional<Pair> pair_of_life(const SixBarLoops& loops, const Centre& centre,
                                          Fine life) {
    // Of what is small: the distance in time goes with its first power, with its third at a cusp.
    const Fine order = centre.is_cusp ? 3 : 1;
    constexpr int kMostTrials = 60;
    constexpr Fine kNearly = 0.05L;
    Fine e = 1e-2L;
    for (int k = 0; k < kMostTrials; ++k) {
      const auto pair = pair_at(loops, centre, e);
      if (!pair || !(pair->life() > 0)) return std::nullopt;
      if (std::abs(pair->life() / life - 1) < kNearly) return pair;
      e *= std::clamp<Fine>(std::pow(life / pair->life(), 1 / order), 0.1L, 2);
    }
    return std::nullopt;
  }

  /// With the stretched link as long as its rounded coordinates say, and its dead points.
  std::optional<BriefLife> rounded(const Pair& pair, BriefKind kind) {
    BriefLife brief{bar_, kind, 0, {}};
    const std::array<Fine, 2> first{brief.bar.from()[0], brief.bar.from()[1]};
    const std::array<Fine, 2> drawn{brief.bar.end[0], brief.bar.end[1]};
    std::array<Fine, 2> side{};
    for (std::size_t i = 0; i < 2; ++i) {
      brief.bar.end[i] = static_cast<double>(first[i] + (1 + pair.lambda) * (drawn[i] - first[i]));
      side[i] = static_cast<Fine>(brief.bar.end[i]) - first[i];
    }
    const Fine lambda =
        std::hypot(side[0], side[1]) / std::hypot(drawn[0] - first[0], drawn[1] - first[1]) - 1;
    const SixBarLoops loops(bar_);
    const double before = kTurn_s * (0.02 + 0.96 * draw_.unit());
    brief.start = static_cast<double>(pair.y[0][4]) - before;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = fold_at(loops, pair.y[k], lambda);
      if (!found) return std::nullopt;
      brief.times[k] = static_cast<double>((*found)[4] - brief.start);
    }
    if (brief.times[0] > brief.times[1]) std::swap(brief.times[0], brief.times[1]);
    return brief;
  }

  Draw draw_;
  SixBar bar_;
};

inline BriefLife random_brief_life(BriefKind kind, double share, std::uint64_t seed,
                                   std::uint64_t number) {
  return BriefLifeDrawer(Draw(seed, number)).draw(kind, share);
}

/// The file: every link with its joints as drawn, the driver turning by 1 rad/s from `start`.
inline std::string text_of(const BriefLife& brief) {
  std::string text;
  std::string joints;
  const auto name = [&](std::size_t link) {
    return link == brief.bar.ground ? std::string("ground") : "link" + std::to_string(link);
  };
  std::array<std::string, SixBar::kLinks> points;
  const auto add = [&](std::size_t link, std::size_t joint, const std::array<double, 2>& at) {
    points[link] +=
        "P" + std::to_string(joint) + " = [" + exact_text(at[0]) + ", " + exact_text(at[1]) + "]\n";
    return "\"" + name(link) + ".P" + std::to_string(joint) + "\"";
  };
  std::size_t number = 0;
  for (const SixBar::Chain& chain : brief.bar.chains) {
    std::size_t last = 0;
    for (std::size_t k = 0; k < chain.joints.size(); ++k) {
      const std::size_t next = k < chain.links.size() ? chain.links[k] : 1;
      const std::string a =
          add(last, number, last == brief.bar.stretched ? brief.bar.end : chain.joints[k]);
      const std::string b = add(next, number, chain.joints[k]);
      joints += "[[joint]]\ntype = \"revolute\"\nat = [" + a + ", " + b + "]\n";
      last = next;
      ++number;
    }
  }
  for (std::size_t link = 0; link < SixBar::kLinks; ++link) {
    text +=
        (link == brief.bar.ground ? "[ground.points]\n" : "[body." + name(link) + ".points]\n") +
        points[link];
  }
  return "[units]\nangle = \"rad\"\n" + text + joints + "[[driver]]\nangle = \"" +
         name(brief.bar.driven) + "\"\nstart = " + exact_text(brief.start) + "\nvelocity = 1\n";
}

inline Mechanism mechanism_of(const BriefLife& brief) { return typed(text_of(brief)); }

}  // namespace moivre::test

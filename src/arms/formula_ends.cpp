// SPDX-License-Identifier: MIT
// Newton's method from what is proposed; real closures in real numbers, of conjugate ones one.
#include "formula_ends.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

/// Radians: what the geometry that a file's digits stand for may move a closure.
constexpr double kMovedByMeaning = 0.2;
/// Closures that are nearer, radians, are not told apart here.
constexpr double kDifferent = 1e-5;
/// Of |step| |J^-1| K, where 1/2 would do.
constexpr double kContracts = 0.1;
/// What forward kinematics may be wrong by.
constexpr double kRounding = 1e-15;

/// Second derivatives in a neighbourhood, relative to the squares of the screws; 2 at the posture
/// itself.
constexpr double kNeighbourhood = 4;

using Matrix6 = Eigen::Matrix<Complex, 6, 6>;
using Vector = Eigen::Matrix<Complex, 3, 1>;

/// Eigen's conjugates complex numbers.
Vector cross(const Vector& a, const Vector& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// |J^-1 second derivatives|. Far from real both factors are large, and their product is not.
double bend(const Matrix6& screws, const Matrix6& inverse) {
  double squares = 0;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Vector axis = screws.col(i).tail<3>();
    for (Eigen::Index j = i; j < 6; ++j) {
      Velocity6<Complex> bracket;
      bracket << cross(axis, screws.col(j).head<3>()), cross(axis, screws.col(j).tail<3>());
      squares += (inverse * bracket).squaredNorm();
    }
  }
  return 2 * std::sqrt(squares);
}

/// What Kantorovich's theorem asks, with a margin, of a last step so long: by a bound of second
/// derivatives and of J^-1,
bool clearly_contracts(double step, double stiffness, double screws_square) {
  return step * kNeighbourhood * screws_square <= kContracts * stiffness;
}
/// or by what they are.
bool contracts(double step, const Matrix6& screws, const Matrix6& inverse) {
  return step * kNeighbourhood / 2 * bend(screws, inverse) <= kContracts;
}

bool settle(const Arm& arm, const Placement<Complex>& pose, ConjugatePair& pair) {
  constexpr int kMost = 6;
  constexpr double kSettled = 1e-7;
  const JointVector<Complex> start = pair.values;
  for (int k = 0; k < kMost; ++k) {
    const TipMotion<Complex> motion = tip_motion<Complex>(arm, pair.values);
    const Matrix6 screws = motion.screws;
    const Matrix6 inverse = screws.partialPivLu().inverse();
    const Velocity6<Complex> step = inverse * small_difference<Complex>(arm, pose, motion.tip);
    pair.accuracy = step.norm();
    pair.stiffness = 1 / inverse.norm();
    pair.values += step;
    if (!((pair.values - start).norm() <= kMovedByMeaning)) return false;
    const double step_size = pair.accuracy;
    if (step_size <= kSettled &&
        (clearly_contracts(step_size, pair.stiffness, screws.squaredNorm()) ||
         contracts(step_size, screws, inverse))) {
      pair.imaginary = pair.values.imag().cwiseAbs().maxCoeff();
      return pair.imaginary > kDifferent;
    }
  }
  return false;
}

std::optional<Polished> settled(const Arm& arm, const Eigen::Isometry3d& pose,
                                const JointVector<double>& start) {
  Polished polished = polish(arm, pose, start);
  if (!((polished.values - start).norm() <= kMovedByMeaning)) return std::nullopt;
  const double sigma = polished.smallest_singular_value;
  const double miss = polished.residual + kRounding;
  if (clearly_contracts(miss / sigma, sigma, polished.screws_square)) return polished;
  const Matrix6 screws = linearized(arm, pose, polished.values).screws.cast<Complex>();
  const Matrix6 inverse = screws.partialPivLu().inverse();
  if (!contracts(miss * inverse.norm(), screws, inverse)) return std::nullopt;
  return polished;
}

/// Of angles in (-pi, pi], or a little beyond.
template <class Values>
bool are_different(const Values& a, const Values& b) {
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double apart = std::abs(a[k] - b[k]);
    const double round = std::abs(std::abs(std::real(a[k] - b[k])) - 2 * std::numbers::pi);
    const double across = std::abs(std::imag(a[k]) - std::imag(b[k]));
    if (apart > kDifferent && (round > kDifferent || across > kDifferent)) return true;
  }
  return false;
}

bool are_all_different(const FoundClosures& found) {
  for (std::size_t k = 0; k < found.real.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (!are_different(found.real[j].values, found.real[k].values)) return false;
    }
  }
  for (std::size_t k = 0; k < found.pairs.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const JointVector<Complex> mirrored = found.pairs[k].values.conjugate();
      if (!are_different(found.pairs[j].values, found.pairs[k].values) ||
          !are_different(found.pairs[j].values, mirrored)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::optional<FoundClosures> closures_proposed(const ProposedClosures& proposed, const Arm& arm,
                                               const Eigen::Isometry3d& pose,
                                               std::size_t closures) {
  FoundClosures found;
  found.real.reserve(proposed.reals);
  found.pairs.reserve(proposed.pair_count);
  const Placement<Complex> wanted = complex_placement(pose);
  // Of more proposals than closures some lead to none.
  std::size_t expected = proposed.reals + 2 * proposed.pair_count;
  for (std::size_t k = 0; k < proposed.pair_count && expected >= closures; ++k) {
    ConjugatePair& pair = found.pairs.emplace_back();
    pair.values = proposed.pairs[k];
    if (settle(arm, wanted, pair)) {
      found.moved = std::max(found.moved, (pair.values - proposed.pairs[k]).norm());
      continue;
    }
    found.pairs.pop_back();
    expected -= 2;
  }
  for (std::size_t k = 0; k < proposed.reals && expected >= closures; ++k) {
    auto real = settled(arm, pose, proposed.real[k]);
    if (real) {
      found.moved = std::max(found.moved, (real->values - proposed.real[k]).norm());
      found.real.push_back(std::move(*real));
    } else {
      --expected;
    }
  }
  if (expected != closures) return std::nullopt;
  if (!are_all_different(found)) return std::nullopt;
  return found;
}

std::vector<ApproachEnd> ends_of(const FoundClosures& found) {
  std::vector<ApproachEnd> ends;
  const auto add = [&](const JointVector<Complex>& values, double accuracy) {
    ends.push_back({ApproachKind::regular, values, accuracy, 0});
  };
  for (const Polished& real : found.real) {
    add(real.values.cast<Complex>(), real.residual / real.smallest_singular_value);
  }
  for (const ConjugatePair& pair : found.pairs) {
    add(pair.values, pair.accuracy);
    add(pair.values.conjugate(), pair.accuracy);
  }
  return ends;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Unit displacements in double, forms from a singular value decomposition, coefficients term by term.
#include "pose_family.h"

#include <algorithm>
#include <cmath>

#include "equations.h"
#include "exact_displacement.h"
#include "moivre/factorization/svd.h"
#include "moivre/family/coefficients.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/random.h"
#include "random_values.h"

namespace moivre {
namespace {

using RealDisplacement = DualQuaternion<double>;
using RealColumn = Eigen::Matrix<double, 8, 1>;
/// Coefficients of the monomials in the tangents; bit k of the index is the exponent of t_k+1.
using RealExpansion = std::vector<RealDisplacement>;

/// Coefficients below this, beside the largest, are zeros of the arm's structure: rounding of sums of numbers near 1.
constexpr double kStructuralZero = 1e-13;
/// Random joint values at which coefficients are measured.
constexpr std::uint64_t kMeasured = 8;
constexpr std::uint64_t kFirstMeasured = 1000;

RealDisplacement real_part(const ComplexDisplacement& g) {
  RealDisplacement result{};
  for (std::size_t k = 0; k < g.size(); ++k) result[k] = g[k].real();
  return result;
}

RealColumn real_column(const RealDisplacement& g) { return Eigen::Map<const RealColumn>(g.data()); }

RealDisplacement unit(RealDisplacement g) {
  const double size = real_column(g).norm();
  for (double& part : g) part /= size;
  return g;
}

/// The pose's inverse, lengths in units of 2^exponent.
RealDisplacement back_from(const Eigen::Isometry3d& pose, int exponent) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d t = std::ldexp(0.5, -exponent) * pose.translation();
  const RealDisplacement turn{q.w(), q.x(), q.y(), q.z()};
  const RealDisplacement shift{1, 0, 0, 0, 0, t.x(), t.y(), t.z()};
  return conjugate(shift * turn);
}

/// What the joints inside can do, spanned.
std::vector<RealDisplacement> products_inside(const Loop& loop, const Cut& cut) {
  std::vector<RealDisplacement> products{RealDisplacement{1}};
  for (std::size_t i = 0; i < cut.inside.size(); ++i) {
    const LoopJoint& joint = loop.joints[cut.inside[i]];
    if (i > 0) {
      for (RealDisplacement& product : products) {
        product = product * real_part(joint.rounded_before);
      }
    }
    const std::size_t size = products.size();
    for (std::size_t k = 0; k < size; ++k) {
      products.push_back(products[k] * real_part(joint.rounded_step));
    }
  }
  return products;
}

/// An orthonormal basis of the forms that vanish on a space of dimension four.
std::vector<RealDisplacement> forms_of(const std::vector<RealDisplacement>& products) {
  Eigen::MatrixXd span(8, static_cast<Eigen::Index>(products.size()));
  for (std::size_t k = 0; k < products.size(); ++k) {
    span.col(static_cast<Eigen::Index>(k)) = real_column(unit(products[k]));
  }
  const Eigen::MatrixXd U = svd(span, SingularVectors::full).U;
  std::vector<RealDisplacement> forms(4);
  for (std::size_t k = 0; k < forms.size(); ++k) {
    Eigen::Map<RealColumn>(forms[k].data()) = U.col(static_cast<Eigen::Index>(4 + k));
  }
  return forms;
}

/// `count` random combinations.
std::vector<RealDisplacement> combinations(const std::vector<RealDisplacement>& forms,
                                           std::size_t count, std::uint64_t seed) {
  constexpr std::uint64_t kBehindOthers = 10000;
  std::vector<RealDisplacement> mixed(count);
  std::uint64_t number = 0;
  for (RealDisplacement& sum : mixed) {
    for (const RealDisplacement& form : forms) {
      const double weight = random_unit(seed, RandomStream::arm, kBehindOthers + number++) - 0.5;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * form[k];
    }
    sum = unit(sum);
  }
  return mixed;
}

/// The outside's product backwards: what the inside's must be.
RealExpansion real_outside_product(const Loop& loop, const Cut& cut) {
  RealExpansion terms{RealDisplacement{1}};
  for (const std::size_t joint : cut.outside) {
    const LoopJoint& own = loop.joints[joint];
    const RealDisplacement before = unit(real_part(own.rounded_before));
    const RealDisplacement step = real_part(own.rounded_step);
    for (RealDisplacement& term : terms) term = term * before;
    const std::size_t size = terms.size();
    for (std::size_t k = 0; k < size; ++k) terms.push_back(terms[k] * step);
  }
  const RealDisplacement first = unit(real_part(loop.joints[cut.first].rounded_before));
  for (RealDisplacement& term : terms) term = conjugate(term * first);
  return terms;
}

double coefficient(const RealDisplacement& form, const RealDisplacement& term) {
  return real_column(form).dot(real_column(term));
}

/// Sizes of all coefficients, the larger ones of some poses.
std::vector<std::vector<double>> measured_sizes(const Arm& arm, const PoseFamily& poses,
                                                std::uint64_t seed) {
  std::vector<std::vector<double>> sizes(poses.forms.size());
  for (std::uint64_t k = 0; k < kMeasured; ++k) {
    const Eigen::Isometry3d pose =
        forward_kinematics(arm, random_joint_values(arm, seed, kFirstMeasured + k));
    const RealExpansion terms = real_outside_product(loop_at(poses, pose), poses.cut);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      sizes[i].resize(terms.size());
      for (std::size_t j = 0; j < terms.size(); ++j) {
        sizes[i][j] = std::max(sizes[i][j], std::abs(coefficient(poses.forms[i], terms[j])));
      }
    }
  }
  return sizes;
}

/// The system of all terms that any pose has, coefficients of their sizes.
System typical_system(const std::vector<std::vector<double>>& sizes, PoseFamily& poses) {
  System system;
  for (const std::size_t joint : poses.cut.outside) {
    system.variables.push_back(std::string("t").append(std::to_string(joint + 1)));
  }
  for (const std::vector<double>& row : sizes) {
    const double largest = *std::max_element(row.begin(), row.end());
    TermMap map;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k] > kStructuralZero * largest) map[multilinear(k)] = exact_value(row[k]);
    }
    system.polynomials.push_back(to_polynomial(std::move(map)));
    std::vector<std::size_t>& terms = poses.terms.emplace_back();
    for (const Term& term : system.polynomials.back().terms) {
      std::size_t bits = 0;
      for (const Power& power : term.monomial) bits |= std::size_t{1} << power.variable;
      terms.push_back(bits);
    }
  }
  return system;
}

}  // namespace

std::optional<PoseFamily> learn_pose_family(const Arm& arm, const Tracker& tracker,
                                            const SolveOptions& options,
                                            const std::atomic<bool>& stop) {
  constexpr std::size_t kJoints = 6;
  if (arm.joints.size() != kJoints) return std::nullopt;
  PoseFamily poses;
  poses.loop = open_loop(arm, options.seed);
  poses.cut = choose_cut(poses.loop, CutPlace::away_from_pose);
  if (poses.cut.kind != CutKind::two && poses.cut.kind != CutKind::three) return std::nullopt;
  poses.tool = real_part(rounded(in_unit(arm.exact_tool, poses.loop.unit_exponent)));
  poses.forms = forms_of(products_inside(poses.loop, poses.cut));
  const std::size_t unknowns = poses.cut.outside.size();
  if (unknowns < poses.forms.size()) {
    poses.forms = combinations(poses.forms, unknowns, options.seed);
  }
  const System typical = typical_system(measured_sizes(arm, poses, options.seed), poses);
  SolveOptions learning = options;
  learning.start = StartKind::multihomogeneous;
  learning.eliminate = false;
  learning.progress = nullptr;
  poses.family = learn(coefficient_family(typical), tracker, learning, stop);
  if (!poses.family.learning.complete) return std::nullopt;
  return poses;
}

Loop loop_at(const PoseFamily& poses, const Eigen::Isometry3d& pose) {
  Loop loop = poses.loop;
  LoopJoint& first = loop.joints.front();
  const RealDisplacement closed =
      unit(poses.tool * back_from(pose, loop.unit_exponent) * real_part(first.rounded_before));
  for (std::size_t k = 0; k < closed.size(); ++k) first.rounded_before[k] = closed[k];
  return loop;
}

Point member_of(const PoseFamily& poses, const Loop& loop) {
  const RealExpansion terms = real_outside_product(loop, poses.cut);
  Point member;
  for (std::size_t i = 0; i < poses.forms.size(); ++i) {
    for (const std::size_t bits : poses.terms[i]) {
      member.emplace_back(coefficient(poses.forms[i], terms[bits]));
    }
  }
  return member;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// How is mobility counted? Rank twice, redundant rows by projection on the rows before them,
// neighbours by a step along R.
#include "moivre/kinematics/mobility.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "moivre/expression/counted.h"
#include "moivre/factorization/qr.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/followed_motion.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/kinematics/state.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Singular value relative to the largest, of the equilibrated matrix: below it, a warning.
constexpr double kNearSingular = 1e-5;
constexpr std::uint64_t kFollowSeed = 1;  // of a body's motion alone, in few coordinates
constexpr double kNegligible = 1e-9;      // share of a row in a combination: rounding
constexpr double kNeighbourStep =
    1e-2;  // step along R relative to the pose's size: far enough to see a rank, near enough
           // for Newton to come back to the same branch

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Rows of J that the rows before them already say, each with its combination.
std::vector<RedundantRow> redundant_rows(const Phi& joints, const MatrixXd& rows, Index rank,
                                         double tolerance) {
  std::vector<RedundantRow> found;
  const MatrixXd J = in_own_units(joints, rows);
  const VectorXd unit = joints.own_row_units();
  if (rank == J.rows()) return found;
  std::vector<Index> kept;
  for (Index i = 0; i < J.rows(); ++i) {
    std::vector<Index> tried = kept;
    tried.push_back(i);
    if (numerical_rank(J(tried, Eigen::all), tolerance) == static_cast<Index>(tried.size())) {
      kept = std::move(tried);
      continue;
    }
    RedundantRow row{i, joints.row_names()[static_cast<std::size_t>(i)], {}};
    const MatrixXd basis = J(kept, Eigen::all).transpose();
    const VectorXd share =
        basis.size() == 0 ? VectorXd() : PivotedQr<double>(basis).solve(J.row(i).transpose());
    for (Index k = 0; k < share.size(); ++k) {
      const Index source = kept[static_cast<std::size_t>(k)];
      const double part = std::abs(share[k]) * J.row(source).norm();
      if (part <= std::max(kNegligible, tolerance) * J.row(i).norm()) continue;
      row.combination.push_back({source, joints.row_names()[static_cast<std::size_t>(source)],
                                 share[k] * unit[i] / unit[source]});
    }
    found.push_back(std::move(row));
  }
  return found;
}

/// An assembled pose and the rank of the joints' Phi_q there.
struct RankedPose {
  Index rank = 0;
  VectorXd q;
};

/// Directions in which one group of coordinates moves alone, drivers held. Null vectors at a
/// singular pose may be no motions: `generic`, next to q or q itself, says how many are, and what
/// is followed along which.
std::vector<IdleFreedom> idle_freedoms(const Phi& phi, const VectorXd& q, double t,
                                       double tolerance, const VectorXd& generic) {
  std::vector<IdleFreedom> found;
  const MatrixXd J = in_own_units(phi, phi.jacobian(q, t));
  const MatrixXd nearby = in_own_units(phi, phi.jacobian(generic, t));
  const VectorXd unit = phi.own_units();
  for (std::size_t group = 0; group < phi.group_names().size(); ++group) {
    std::vector<Index> own;
    for (std::size_t k = 0; k < phi.coordinates().size(); ++k) {
      if (phi.coordinates()[k].group == group) own.push_back(static_cast<Index>(k));
    }
    const auto tell = [&](const MatrixXd& alone) {
      for (Index column = 0; column < alone.cols(); ++column) {
        VectorXd direction = VectorXd::Zero(J.cols());
        direction(own) = alone.col(column).cwiseProduct(unit(own)).normalized();
        found.push_back({phi.group_names()[group], direction});
      }
    };
    const MatrixXd here = null_space(J(Eigen::all, own), tolerance);
    const MatrixXd there = null_space(nearby(Eigen::all, own), tolerance);
    if (here.cols() <= there.cols()) {
      tell(here);
      continue;
    }
    std::vector<VectorXd> followed;
    if (there.cols() == 1) followed = followed_directions(phi, q, t, kFollowSeed, own);
    if (followed.empty()) {
      tell(there);
    } else {
      found.push_back({phi.group_names()[group], followed.front().normalized()});
    }
  }
  return found;
}

/// The assembled pose next to q, or q itself, that has the largest rank. Each coordinate that R
/// moves is held a step away (both ways) while Newton assembles the others: without holding one,
/// Newton would fall back onto a singular q.
RankedPose generic_next_to(const Phi& joints, const VectorXd& q, double t, const Mobility& m,
                           double fit) {
  constexpr double kMoves = 1e-2;  // share of a coordinate in R below which it hardly moves
  const double step = kNeighbourStep * std::max(1.0, q.lpNorm<Eigen::Infinity>());
  const double tolerance = rank_tolerance(joints, fit);
  const MatrixXd& R = m.null_space;
  RankedPose best = {m.rank, q};
  for (Index k = 0; k < q.size() && best.rank < joints.size(); ++k) {
    const VectorXd along = R * R.row(k).transpose();
    if (along[k] < kMoves) continue;
    NewtonOptions hold;
    hold.held = {k};
    for (const double side : {step, -step}) {
      const NewtonResult neighbour = newton(joints, q + side * along, t, hold);
      const bool is_near =
          neighbour.status == NewtonStatus::no_solution && misfit(joints, neighbour.q, t) <= fit;
      if (neighbour.status != NewtonStatus::converged && !is_near) continue;
      const Index rank = rank_of(joints, joints.jacobian(neighbour.q, t), tolerance);
      if (rank > best.rank) best = {rank, neighbour.q};
    }
  }
  return best;
}

std::vector<std::string> warnings_of(const Mobility& m) {
  std::vector<std::string> warnings;
  if (!m.is_assembled) {
    warnings.emplace_back(
        "the pose is not assembled: these figures hold where Phi = 0, assemble it first");
  }
  if (m.rank != m.rank_by_svd) {
    warnings.push_back("QR finds rank " + std::to_string(m.rank) + ", the singular values " +
                       std::to_string(m.rank_by_svd) + ": the rank is doubtful here");
  }
  if (m.is_singular) {
    warnings.push_back(
        "singular pose: rank " + std::to_string(m.rank) + " here, " +
        std::to_string(m.rank_nearby) + " next to it; away from here the mechanism has " +
        counted(m.coordinates - m.rank_nearby, "degree of freedom", "degrees of freedom"));
  } else if (m.is_near_singular) {
    warnings.push_back("near a singular pose: the smallest counted singular value is " +
                       number_text(m.singular_values[m.rank - 1] / m.singular_values[0]) +
                       " of the largest");
  }
  if (m.gruebler != m.degrees_of_freedom) {
    warnings.push_back("Gruebler's count says " + std::to_string(m.gruebler) + ", the rank says " +
                       std::to_string(m.degrees_of_freedom) + ": " +
                       std::to_string(m.degrees_of_freedom - m.gruebler) + " redundant constraint" +
                       (m.degrees_of_freedom - m.gruebler == 1 ? "" : "s"));
  }
  for (std::size_t k = 0; k < m.idle.size(); ++k) {
    if (k > 0 && m.idle[k].name == m.idle[k - 1].name) continue;
    warnings.push_back("'" + m.idle[k].name + "' can move while everything else stands still");
  }
  return warnings;
}

}  // namespace

double rank_tolerance(const Phi& joints, double fit) {
  if (!(fit >= 0) || !std::isfinite(fit)) {
    throw InvalidInput("fit must be a finite length, 0 or more");
  }
  const double slack = std::sqrt(static_cast<double>(joints.size())) * fit / joints.length();
  return std::max(kRankTolerance, slack);
}

std::string to_text(const RedundantRow& redundant) {
  std::string text = redundant.name + " =";
  if (redundant.combination.empty()) return text + " 0";
  bool is_first = true;
  for (const RowShare& share : redundant.combination) {
    const double size = std::abs(share.coefficient);
    const char* sign = share.coefficient < 0 ? " - " : is_first ? " " : " + ";
    const bool is_one = std::abs(size - 1) < kNegligible;
    text += sign + (is_one ? "" : number_text(size) + " ") + "[" + share.name + "]";
    is_first = false;
  }
  return text;
}

ConstraintRank constraint_rank(const Phi& phi, const VectorXd& q, double t, double fit) {
  require_place(phi, q, t);
  const Phi joints = phi.without_drivers();
  const double tolerance = rank_tolerance(joints, fit);
  const MatrixXd J = joints.jacobian(q, t);
  const Index rank = rank_of(joints, J, tolerance);
  return {rank, J.cols() - rank, redundant_rows(joints, J, rank, tolerance)};
}

Mobility mobility(const Phi& phi, const VectorXd& q, double t, double fit) {
  require_place(phi, q, t);
  const Phi joints = phi.without_drivers();
  const MatrixXd J = joints.jacobian(q, t);
  const double tolerance = rank_tolerance(joints, fit);
  Mobility m;
  m.coordinates = joints.dimension();
  m.constraints = joints.size();
  m.drivers = phi.driver_size();
  m.rank = rank_of(joints, J, tolerance);
  m.degrees_of_freedom = m.coordinates - m.rank;
  m.gruebler = m.coordinates - m.constraints;
  m.driven_freedoms = m.coordinates - rank_of(phi, phi.jacobian(q, t), tolerance);
  if (J.size() != 0) m.singular_values = singular_values(equilibrated(in_own_units(joints, J)));
  const double floor = m.singular_values.size() == 0 ? 0 : tolerance * m.singular_values[0];
  m.rank_by_svd = (m.singular_values.array() > floor).count();
  m.redundant = redundant_rows(joints, J, m.rank, tolerance);
  m.null_space = null_space_of(joints, J, tolerance);
  m.left_null_space = left_null_space_of(joints, J, tolerance);
  m.force_directions = -J.transpose();
  m.independent = independent_columns(in_own_units(joints, J), m.rank);
  m.row_names = joints.row_names();
  m.is_near_singular =
      m.rank > 0 && m.singular_values[m.rank - 1] < kNearSingular * m.singular_values[0];
  m.misfit = misfit(phi, q, t);
  m.is_assembled = residual_by_size(joints, q, t) <= kAssembled || m.misfit <= fit;
  const RankedPose generic =
      m.is_assembled ? generic_next_to(joints, q, t, m, fit) : RankedPose{m.rank, q};
  m.rank_nearby = generic.rank;
  m.is_singular = m.rank_nearby > m.rank;
  m.idle = idle_freedoms(phi, q, t, tolerance, generic.q);
  m.warnings = warnings_of(m);
  return m;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// How are velocity and acceleration solved from one factorization, appended or partitioned?
#include "moivre/kinematics/state.h"

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <string>

#include "moivre/expression/counted.h"
#include "moivre/factorization/qr.h"
#include "moivre/kinematics/own_units.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

MatrixXd columns(const MatrixXd& A, const std::vector<Index>& chosen) {
  return A(Eigen::all, chosen);
}

void require_usable(const Phi& joints, const Partition& partition) {
  if (!partition.is_usable()) throw InvalidInput(partition.refusal);
  std::vector<Index> all = partition.dependent;
  all.insert(all.end(), partition.independent.begin(), partition.independent.end());
  std::sort(all.begin(), all.end());
  std::vector<Index> each(static_cast<std::size_t>(joints.dimension()));
  std::iota(each.begin(), each.end(), Index{0});
  if (all != each) {
    throw InvalidInput("a partition has each of " + std::to_string(each.size()) +
                       " coordinates once");
  }
}

void require_rates(const Partition& partition, const VectorXd& rates, const std::string& name) {
  if (rates.size() == std::ssize(partition.independent) && rates.allFinite()) return;
  throw InvalidInput("the independent " + name + " is " +
                     std::to_string(partition.independent.size()) + " finite numbers");
}

/// Smallest over largest pivot of the equilibrated matrix; 1 for an empty one.
double pivot_ratio(const MatrixXd& A) {
  if (A.size() == 0) return 1;
  const VectorXd pivots = PivotedQr<double>(equilibrated(A)).pivots();
  return pivots[0] > 0 ? pivots[pivots.size() - 1] / pivots[0] : 0;
}

std::vector<Index> complement(const std::vector<Index>& chosen, Index size) {
  std::vector<Index> rest;
  for (Index k = 0; k < size; ++k) {
    if (std::find(chosen.begin(), chosen.end(), k) == chosen.end()) rest.push_back(k);
  }
  return rest;
}

std::string names_of(const Phi& phi, const std::vector<Index>& chosen) {
  std::string text;
  for (const Index k : chosen) {
    text += (text.empty() ? "" : ", ") + phi.coordinates()[static_cast<std::size_t>(k)].name;
  }
  return text;
}

}  // namespace

MotionState motion_state(const Phi& phi, const VectorXd& q, double t,
                         const LinearOptions& options) {
  require_place(phi, q, t);
  const MatrixXd J = phi.jacobian(q, t);
  const Factorization factors = factorization_of(phi, J, options);
  MotionState state;
  state.factorizations = 1;
  state.q = q;
  state.method = factors.method();
  state.rank = factors.rank();
  state.is_determined = state.rank == phi.dimension();
  const VectorXd velocity_rhs = phi.velocity_rhs(q, t);
  state.velocity = factors.solve(velocity_rhs);
  state.velocity_residual = largest(J * state.velocity - velocity_rhs);
  const VectorXd gamma = phi.acceleration_rhs(q, state.velocity, t);
  state.acceleration = factors.solve(gamma);
  state.acceleration_residual = largest(J * state.acceleration - gamma);
  return state;
}

std::vector<Index> independent_columns(const MatrixXd& J, Index rank) {
  const Eigen::VectorXi order = PivotedQr<double>(equilibrated(J)).order();
  std::vector<Index> independent(order.begin() + rank, order.end());
  std::sort(independent.begin(), independent.end());
  return independent;
}

Partition choose_partition(const Phi& joints, const VectorXd& q, double t) {
  require_place(joints, q, t);
  const MatrixXd J = in_own_units(joints, joints.jacobian(q, t));
  return make_partition(joints, q, independent_columns(J, numerical_rank(J)), t);
}

Partition make_partition(const Phi& joints, const VectorXd& q, std::vector<Index> independent,
                         double t) {
  require_place(joints, q, t);
  std::sort(independent.begin(), independent.end());
  const bool twice =
      std::adjacent_find(independent.begin(), independent.end()) != independent.end();
  const bool outside =
      !independent.empty() && (independent.front() < 0 || independent.back() >= joints.dimension());
  if (twice || outside) {
    throw InvalidInput("independent coordinates must be distinct indices below " +
                       std::to_string(joints.dimension()));
  }
  Partition partition;
  partition.independent = std::move(independent);
  partition.dependent = complement(partition.independent, joints.dimension());
  const MatrixXd J = in_own_units(joints, joints.jacobian(q, t));
  const Index freedoms = joints.dimension() - numerical_rank(J);
  const auto chosen = static_cast<Index>(partition.independent.size());
  const MatrixXd Phi_u = columns(J, partition.dependent);
  partition.smallest_pivot = pivot_ratio(Phi_u);
  if (chosen != freedoms) {
    partition.refusal = std::to_string(chosen) +
                        " independent coordinates were chosen, the pose has " +
                        counted(freedoms, "degree of freedom", "degrees of freedom");
  } else if (numerical_rank(Phi_u) < Phi_u.cols()) {
    partition.refusal = "Phi_u is singular: " + names_of(joints, partition.independent) +
                        " cannot be chosen freely at this pose";
  }
  return partition;
}

NewtonResult solve_positions(const Phi& joints, const Partition& partition, const VectorXd& guess,
                             double t, const NewtonOptions& options) {
  require_usable(joints, partition);
  NewtonOptions dependent_only = options;
  dependent_only.held = partition.independent;
  return newton(joints, guess, t, dependent_only);
}

MotionState partitioned_state(const Phi& joints, const Partition& partition, const VectorXd& q,
                              const VectorXd& independent_velocity,
                              const VectorXd& independent_acceleration, double t) {
  require_usable(joints, partition);
  require_place(joints, q, t);
  require_rates(partition, independent_velocity, "velocity");
  require_rates(partition, independent_acceleration, "acceleration");
  const MatrixXd J = joints.jacobian(q, t);
  const MatrixXd Phi_v = columns(J, partition.independent);
  LinearOptions options;
  options.row_units = joints.own_row_units();
  options.column_units = joints.own_units()(partition.dependent);
  const Factorization factors(columns(J, partition.dependent), options);
  MotionState state;
  state.factorizations = 1;
  state.q = q;
  state.method = factors.method();
  state.rank = factors.rank();
  state.is_determined = state.rank == static_cast<Index>(partition.dependent.size());
  state.velocity = VectorXd::Zero(q.size());
  state.acceleration = VectorXd::Zero(q.size());
  const VectorXd velocity_rhs = joints.velocity_rhs(q, t);
  state.velocity(partition.independent) = independent_velocity;
  state.velocity(partition.dependent) = factors.solve(velocity_rhs - Phi_v * independent_velocity);
  const VectorXd gamma = joints.acceleration_rhs(q, state.velocity, t);
  state.acceleration(partition.independent) = independent_acceleration;
  state.acceleration(partition.dependent) = factors.solve(gamma - Phi_v * independent_acceleration);
  state.velocity_residual = largest(J * state.velocity - velocity_rhs);
  state.acceleration_residual = largest(J * state.acceleration - gamma);
  return state;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// How often were velocity, acceleration and a factorization asked for? Counters on the calls
// between modules; include once.
//
// The names are those that g++ and clang++ give Phi::velocity_rhs, Phi::acceleration_rhs and
// Factorization's constructor.
// The two that return an Eigen vector get its place as their first argument.
#pragma once

#include "counted_calls.h"
#include "moivre/kinematics/linear.h"
#include "moivre/mechanism/phi.h"

namespace moivre::test {

inline CallCounter velocities;
inline CallCounter accelerations;
inline CallCounter factorizations;

}  // namespace moivre::test

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

Vector real_velocity(const moivre::Phi* phi, const Vector& q, double t) __asm__(
    "__real__ZNK6moivre3Phi12velocity_rhsERKN5Eigen6MatrixIdLin1ELi1ELi0ELin1ELi1EEEd");
Vector wrap_velocity(const moivre::Phi* phi, const Vector& q, double t) __asm__(
    "__wrap__ZNK6moivre3Phi12velocity_rhsERKN5Eigen6MatrixIdLin1ELi1ELi0ELin1ELi1EEEd");
Vector wrap_velocity(const moivre::Phi* phi, const Vector& q, double t) {
  moivre::test::velocities.raise();
  return real_velocity(phi, q, t);
}

Vector
real_acceleration(const moivre::Phi* phi, const Vector& q, const Vector& qdot, double t) __asm__(
    "__real__ZNK6moivre3Phi16acceleration_rhsERKN5Eigen6MatrixIdLin1ELi1ELi0ELin1ELi1EEES5_d");
Vector
wrap_acceleration(const moivre::Phi* phi, const Vector& q, const Vector& qdot, double t) __asm__(
    "__wrap__ZNK6moivre3Phi16acceleration_rhsERKN5Eigen6MatrixIdLin1ELi1ELi0ELin1ELi1EEES5_d");
Vector wrap_acceleration(const moivre::Phi* phi, const Vector& q, const Vector& qdot, double t) {
  moivre::test::accelerations.raise();
  return real_acceleration(phi, q, qdot, t);
}

void real_factorization(moivre::Factorization* self, const Matrix& A, const moivre::LinearOptions& options) __asm__(
    "__real__ZN6moivre13FactorizationC1ERKN5Eigen6MatrixIdLin1ELin1ELi0ELin1ELin1EEERKNS_"
    "13LinearOptionsE");
void wrap_factorization(moivre::Factorization* self, const Matrix& A, const moivre::LinearOptions& options) __asm__(
    "__wrap__ZN6moivre13FactorizationC1ERKN5Eigen6MatrixIdLin1ELin1ELi0ELin1ELin1EEERKNS_"
    "13LinearOptionsE");
void wrap_factorization(moivre::Factorization* self, const Matrix& A,
                        const moivre::LinearOptions& options) {
  moivre::test::factorizations.raise();
  real_factorization(self, A, options);
}

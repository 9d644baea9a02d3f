// SPDX-License-Identifier: MIT
// Which systems have roots that are all known exactly? Products of lines in turned coordinates,
// with rational roots.
//
//   u = A x, A integer with determinant 1;  F_i = prod_k (u_i - r_ik - s_ik u_{i-1}),  u_0 = 0
//
// so that u_1 is one of r_1k, u_2 one of r_2k + s_2k u_1, ...: as many roots as the product of the
// degrees, with multiplicity.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "moivre/certify/certificate.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/system.h"

namespace moivre::test {

using ExactPoint = std::vector<Coefficient>;

struct Planted {
  System f;
  std::vector<ExactPoint> roots;          ///< distinct
  std::vector<std::size_t> multiplicity;  ///< of each
};

/// What F_i's factors are like.
enum class Factors {
  real,             ///< real roots
  conjugate_pairs,  ///< real polynomials, roots in conjugate pairs besides real ones
  complex,
  repeated  ///< real, and the first factor of some F_i twice
};

Planted planted(std::uint64_t seed, std::uint32_t dimension, Factors kind);

System system_of(const std::string& text);
System problem(const std::string& name);

Point to_double(const ExactPoint& x);
/// |x_j - m_j| <= reach_j for all j, in exact arithmetic.
bool lies_within(const ExactPoint& x, const Certificate& c,
                 double (Certificate::*reach)(std::size_t) const);
/// |a - b|_inf.
double distance(const Point& a, const Point& b);

/// Nothing where all that the certificate says is true of the planted roots; else what is not.
std::string untruth(const Certificate& c, const Planted& p, const Point& given, double accuracy);

}  // namespace moivre::test

// SPDX-License-Identifier: MIT
// Which system has exactly as many roots as the degrees allow, all of them known? G_j = c1_j
// x_j^{d_j} - c2_j.
//
//   c1_j, c2_j: random on the unit circle (the gamma trick);  roots: x_j = (c2_j/c1_j)^{1/d_j} by
//   De Moivre's theorem, z^{1/d} = |z|^{1/d} (cos((theta + 2 pi k)/d) + i sin((theta + 2 pi k)/d)),
//   theta = atan2(Im z, Re z), k = 0..d-1.
//   Path number = sum_j k_j d_0...d_{j-1}: mixed radix in the degrees, so that start points are
//   computed, never stored.
//
// Edges: an equation of degree 0 has no start root; a Bezout number beyond 64 bits is refused
// (std::overflow_error).
// Source: [Morgan87, ch. 3], [Chang07, p30-p31]. The slides' k = 0, 2, ..., d and atan are wrong; k
// = 0..d-1 and atan2 here.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The d roots of z by De Moivre's theorem, k-th one. d >= 1, 0 <= k < d.
Complex de_moivre_root(Complex z, std::uint64_t d, std::uint64_t k);

struct TotalDegreeStart {
  std::vector<std::uint64_t> degrees;  ///< d_j >= 1
  std::vector<Complex> c1;
  std::vector<Complex> c2;
  std::uint64_t paths = 0;  ///< Bezout number
};

/// Throws std::invalid_argument when a degree is 0, std::overflow_error when the Bezout number
/// leaves 64 bits.
TotalDegreeStart total_degree_start(const std::vector<std::uint64_t>& degrees, std::uint64_t seed);

/// G as a system in the same variables; its coefficients are the doubles c1, c2 exactly.
System start_system(const TotalDegreeStart& start, const std::vector<std::string>& variables);

/// Start point of path `number` in homogeneous coordinates: (x_1, ..., x_n, 1).
Point start_point(const TotalDegreeStart& start, std::uint64_t number);

}  // namespace moivre

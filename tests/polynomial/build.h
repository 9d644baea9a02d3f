// SPDX-License-Identifier: MIT
// Polynomials for tests, written as they are on paper, and exact evaluation at exact points.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre::build {

using Point = std::vector<Coefficient>;

Polynomial constant(const Rational& re, const Rational& im = 0);
Polynomial variable(std::uint32_t j);
Polynomial power(const Polynomial& p, int exponent);
/// Unknowns named x1 ... xn.
System system(std::size_t unknowns, std::vector<Polynomial> polynomials);
Coefficient value(const Polynomial& p, const Point& x);
Point value(const System& f, const Point& x);
/// Gaussian rational with numerators up to 9 and denominators up to 5.
Coefficient random_number(std::mt19937_64& random);
/// The same with both parts integers, or real only.
Coefficient random_integer(std::mt19937_64& random, bool is_real);
Point random_point(std::size_t n, std::mt19937_64& random);
/// A dense polynomial of degree 2 or less with random coefficients; `degree` 1 or 2.
Polynomial random_polynomial(std::uint32_t unknowns, int degree, std::mt19937_64& random);
/// p without its value at x: a polynomial with that zero.
Polynomial through(const Polynomial& p, const Point& x);
/// Exact rank of the matrix with these rows.
std::size_t rank(std::vector<Point> rows);
System katsura(std::uint32_t n);
System cyclic(std::uint32_t n);
/// x_i (x_1^2 + ... without x_i^2) - 1.1 x_i + 1
System noon(std::uint32_t n);
System eco(std::uint32_t n);

}  // namespace moivre::build

// SPDX-License-Identifier: MIT
// The total-degree start system of the course notes and its roots by De Moivre's theorem.
#include "moivre/start/total_degree.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "exact_coefficient.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"

namespace moivre {

Complex de_moivre_root(Complex z, std::uint64_t d, std::uint64_t k) {
  const double theta = std::arg(z);
  const double turn = 2 * std::numbers::pi * static_cast<double>(k);
  return std::polar(std::pow(std::abs(z), 1 / static_cast<double>(d)),
                    (theta + turn) / static_cast<double>(d));
}

TotalDegreeStart total_degree_start(const std::vector<std::uint64_t>& degrees, std::uint64_t seed) {
  TotalDegreeStart start;
  start.degrees = degrees;
  for (std::size_t j = 0; j < degrees.size(); ++j) {
    if (degrees[j] == 0) {
      throw InvalidInput("equation " + std::to_string(j + 1) + " is a constant");
    }
    start.c1.push_back(random_phase(seed, RandomStream::start_system, 2 * j));
    start.c2.push_back(random_phase(seed, RandomStream::start_system, 2 * j + 1));
  }
  const auto paths = total_degree(degrees);
  if (!paths) throw std::overflow_error("the Bezout number does not fit into 64 bits");
  start.paths = *paths;
  return start;
}

System start_system(const TotalDegreeStart& start, const std::vector<std::string>& variables) {
  System g;
  g.variables = variables;
  for (std::uint32_t j = 0; j < start.degrees.size(); ++j) {
    TermMap terms;
    terms[Monomial{{j, static_cast<std::uint32_t>(start.degrees[j])}}] =
        exact_coefficient(start.c1[j]);
    terms[Monomial{}] = exact_coefficient(-start.c2[j]);
    g.polynomials.push_back(to_polynomial(terms));
  }
  return g;
}

Point start_point(const TotalDegreeStart& start, std::uint64_t number) {
  Point x;
  x.reserve(start.degrees.size() + 1);
  for (std::size_t j = 0; j < start.degrees.size(); ++j) {
    const std::uint64_t d = start.degrees[j];
    x.push_back(de_moivre_root(start.c2[j] / start.c1[j], d, number % d));
    number /= d;
  }
  x.push_back(1);
  return x;
}

}  // namespace moivre

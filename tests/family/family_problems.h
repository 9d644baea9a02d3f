// SPDX-License-Identifier: MIT
// Which families of kinematics are measured and tested? With their published numbers of roots, and
// random members.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "moivre/family/coefficients.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/read.h"

namespace moivre {

struct FamilyProblem {
  std::string name;
  std::size_t roots;
  Family family;
  std::function<Point(std::size_t)> member;
};

inline double random_number(std::size_t member, std::size_t index) {
  return 2 * random_unit(11, RandomStream::test, 1000 * member + index) - 1;
}

/// Crank r at the angle of w, coupler l, rocker m, base d: r w + l u = d + m v, and its conjugate.
inline FamilyProblem four_bar_problem() {
  Family family = unlearned_family(
      read_system({"four-bar", "2 8\nr*w + l*u - m*v - d; r*W*u*v + l*v - m*u - d*u*v;\n"}),
      {{"r"}, {"l"}, {"m"}, {"d"}, {"w"}, {"W"}});
  return {"four-bar", 2, std::move(family), [](std::size_t k) {
            const Complex w = std::polar(1.0, 3 * random_number(k, 0));
            return Point{1 + 0.3 * random_number(k, 1),
                         3 + random_number(k, 2),
                         3 + random_number(k, 3),
                         3 + random_number(k, 4),
                         w,
                         std::conj(w)};
          }};
}

/// Jansen's leg: three dyads, the third on the first two; v and e are directions of the triangle
/// and of the lower rocker.
///   r w + j a = p + b v,  r w + k c = p + l e,  d v + f g = l e + m h,  and their conjugates
inline FamilyProblem jansen_problem() {
  const std::vector<std::string> names{"r", "j", "b", "k", "l", "f", "m",
                                       "p", "q", "d", "D", "w", "W"};
  std::vector<NamedParameter> parameters;
  for (const std::string& name : names) parameters.push_back({name});
  Family family = unlearned_family(read_system({"jansen",
                                                "6 19\n"
                                                "r*w + j*a - p - b*v; (r*W - q)*a*v + j*v - b*a;\n"
                                                "r*w + k*c - p - l*e; (r*W - q)*c*e + k*e - l*c;\n"
                                                "d*v + f*g - l*e - m*h;\n"
                                                "D*e*g*h + f*v*e*h - l*v*g*h - m*v*e*g;\n"}),
                                   parameters);
  family.nonzero = true;
  return {"jansen", 8, std::move(family), [](std::size_t k) {
            const std::vector<double> lengths{15, 50, 41.5, 61.9, 39.3, 39.4, 36.7};
            Point p;
            for (std::size_t i = 0; i < lengths.size(); ++i) {
              p.push_back(lengths[i] * (1 + 0.1 * random_number(k, i)));
            }
            for (const Complex z : {Complex(-38, -7.8), Complex(2.61, 40.0),
                                    std::polar(1.0, 3 * random_number(k, 7))}) {
              p.push_back(z);
              p.push_back(std::conj(z));
            }
            return p;
          }};
}

/// Three loops of a seven-link Assur structure, each with one link that is in no other loop: its
/// direction is eliminated,
///   (a_0 + a_j t_j + a_k t_k) (A_0 + A_j / t_j + A_k / t_k) = l^2;  a and A, a coefficient and its
///   conjugate, are two parameters.
/// `shared`: the directions in each loop.
inline FamilyProblem seven_link_problem(std::size_t roots,
                                        const std::vector<std::vector<int>>& shared) {
  std::string equations;
  std::vector<NamedParameter> parameters;
  for (std::size_t loop = 0; loop < shared.size(); ++loop) {
    std::string side[2];
    std::string denominator = "1";
    for (int is_conjugate = 0; is_conjugate < 2; ++is_conjugate) {
      const std::string name = (is_conjugate ? "A" : "a") + std::to_string(loop + 1);
      std::string all;
      for (const int j : shared[loop]) all += "*t" + std::to_string(j);
      std::string sum = name + "_0" + (is_conjugate ? all : "");
      parameters.push_back({name + "_0"});
      for (const int j : shared[loop]) {
        const std::string coefficient = name + "_" + std::to_string(j);
        parameters.push_back({coefficient});
        std::string others;
        for (const int k : shared[loop]) others += k == j ? "" : "*t" + std::to_string(k);
        sum += " + " + coefficient + (is_conjugate ? others : "*t" + std::to_string(j));
      }
      side[is_conjugate].append("(").append(sum).append(")");
      denominator = all;
    }
    const std::string length = "L" + std::to_string(loop + 1);
    parameters.push_back({length});
    equations += side[0] + "*" + side[1] + " - " + length + denominator + ";\n";
  }
  const std::string text = "3 " + std::to_string(3 + parameters.size()) + "\n" + equations;
  Family family = unlearned_family(read_system({"seven-link", text}), parameters);
  family.nonzero = true;
  const std::vector<std::string> names = family.parameter_names();
  return {"seven-link-" + std::to_string(roots), roots, std::move(family), [names](std::size_t k) {
            Point p;
            for (std::size_t j = 0; j < names.size(); ++j) {
              const Complex c(1.5 * random_number(k, 2 * j), 1.5 * random_number(k, 2 * j + 1));
              const auto twin = std::find(names.begin(), names.end(), "a" + names[j].substr(1));
              const bool is_conjugate = names[j][0] == 'A';
              p.push_back(names[j][0] == 'L' ? 1 + 0.5 * c.real()
                          : is_conjugate
                              ? std::conj(p[static_cast<std::size_t>(twin - names.begin())])
                              : c);
            }
            return p;
          }};
}

/// z_2 to z_5: unit axes, z_1 = e_z; twists and offsets of one arm; parameters: the last axis Z and
/// the way P to it.
inline FamilyProblem six_r_problem() {
  const std::string text =
      "11 17\n"
      "x2^2 + y2^2 - 0.84; x3^2 + y3^2 + z3^2 - 1; x4^2 + y4^2 + z4^2 - 1; x5^2 + y5^2 + z5^2 - "
      "1;\n"
      "x2*x3 + y2*y3 + 0.4*z3 - 0.3; x3*x4 + y3*y4 + z3*z4 + 0.2; x4*x5 + y4*y5 + z4*z5 - 0.5;\n"
      "x5*X + y5*Y + z5*Z - 0.1;\n"
      "-0.7*y2 + 0.3*x2 + 0.9*(y2*z3 - 0.4*y3) + 0.2*x3 + 0.5*(y3*z4 - z3*y4) - 0.4*x4\n"
      " + 0.8*(y4*z5 - z4*y5) + 0.6*x5 + 0.3*(y5*Z - z5*Y) - A;\n"
      "0.7*x2 + 0.3*y2 + 0.9*(0.4*x3 - x2*z3) + 0.2*y3 + 0.5*(z3*x4 - x3*z4) - 0.4*y4\n"
      " + 0.8*(z4*x5 - x4*z5) + 0.6*y5 + 0.3*(z5*X - x5*Z) - B;\n"
      "0.12 + 0.9*(x2*y3 - y2*x3) + 0.2*z3 + 0.5*(x3*y4 - y3*x4) - 0.4*z4\n"
      " + 0.8*(x4*y5 - y4*x5) + 0.6*z5 + 0.3*(x5*Y - y5*X) - C;\n";
  Family family =
      unlearned_family(read_system({"6R", text}), {{"X"}, {"Y"}, {"Z"}, {"A"}, {"B"}, {"C"}});
  return {"6R", 16, std::move(family), [](std::size_t k) {
            Point p;
            for (std::size_t j = 0; j < 6; ++j) p.push_back(random_number(k, j));
            const double size = std::sqrt(std::norm(p[0]) + std::norm(p[1]) + std::norm(p[2]));
            for (std::size_t j = 0; j < 3; ++j) p[j] /= size;
            return p;
          }};
}

/// Dietmaier's platform; the square of each leg moved by -p_i.
inline FamilyProblem stewart_problem() {
  System system = read_system(read_source(MOIVRE_SOURCE_DIR "/problems/polynomials/dietmaier.phc"));
  const auto variable = [&](const std::string& name) {
    const auto found = std::find(system.variables.begin(), system.variables.end(), name);
    return unknown(static_cast<std::uint32_t>(found - system.variables.begin()));
  };
  Polynomial norm = constant({1, 0});
  for (const char* name : {"q1", "q2", "q3"}) norm = norm + variable(name) * variable(name);
  std::vector<NamedParameter> parameters;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const auto place = static_cast<std::uint32_t>(system.variables.size());
    system.variables.push_back(std::string("p").append(std::to_string(i + 1)));
    system.polynomials[i] = system.polynomials[i] + unknown(place) * norm;
    parameters.push_back({system.variables.back()});
  }
  return {"stewart", 40, unlearned_family(system, parameters), [](std::size_t k) {
            Point p;
            for (std::size_t j = 0; j < 6; ++j) p.push_back(0.3 * random_number(k, j));
            return p;
          }};
}

inline std::vector<FamilyProblem> family_problems() {
  std::vector<FamilyProblem> problems;
  problems.push_back(four_bar_problem());
  problems.push_back(jansen_problem());
  problems.push_back(seven_link_problem(14, {{1, 2}, {2, 3}, {1, 3}}));
  problems.push_back(seven_link_problem(16, {{1, 2}, {2, 3}, {1, 2, 3}}));
  problems.push_back(seven_link_problem(18, {{1, 2, 3}, {1, 2, 3}, {1, 3}}));
  problems.push_back(six_r_problem());
  problems.push_back(stewart_problem());
  return problems;
}

}  // namespace moivre

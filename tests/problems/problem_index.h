// SPDX-License-Identifier: MIT
// What does problems/polynomials/index.json say of a system? The index as structs, for tests over
// every problem.
//
// The field "about" at the head of the index says what each count means. Include it with
// <index folder> = MOIVRE_SOURCE_DIR "/problems/polynomials".
#pragma once

#include <complex>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace moivre::problems {

/// `points` isolated finite roots of one multiplicity.
struct MultiplicityCount {
  std::uint64_t multiplicity = 1;
  std::uint64_t points = 0;
};

/// A root known exactly (rounded to double).
struct KnownPoint {
  std::vector<std::complex<double>> x;
  std::uint64_t multiplicity = 1;
};

/// Isolated finite roots.
struct RootCounts {
  std::uint64_t with_multiplicity = 0;
  std::uint64_t distinct = 0;
  std::uint64_t regular = 0;
  std::uint64_t far = 0;
  std::uint64_t real = 0;
  std::uint64_t with_zero_coordinates = 0;
  std::vector<MultiplicityCount> multiplicities;
};

struct Problem {
  std::string name;
  std::string file;
  std::string format;
  std::string same_as;
  std::vector<std::string> citations;
  std::vector<std::string> verified;
  std::uint64_t variables = 0;
  std::vector<std::uint64_t> degrees;
  std::uint64_t total_degree = 0;
  std::uint64_t terms = 0;
  bool has_real_coefficients = true;
  int dimension = 0;
  RootCounts roots;
  std::optional<std::uint64_t> at_infinity;
  std::vector<KnownPoint> points;
};

inline RootCounts read_root_counts(const nlohmann::json& entry) {
  RootCounts roots;
  entry.at("with_multiplicity").get_to(roots.with_multiplicity);
  entry.at("distinct").get_to(roots.distinct);
  entry.at("regular").get_to(roots.regular);
  entry.at("far").get_to(roots.far);
  entry.at("real").get_to(roots.real);
  entry.at("with_zero_coordinates").get_to(roots.with_zero_coordinates);
  for (const nlohmann::json& count : entry.at("multiplicities")) {
    roots.multiplicities.push_back(
        {count.at("multiplicity").get<std::uint64_t>(), count.at("points").get<std::uint64_t>()});
  }
  return roots;
}

inline KnownPoint read_known_point(const nlohmann::json& entry) {
  KnownPoint point;
  for (const nlohmann::json& z : entry.at("x")) {
    point.x.emplace_back(z.at(0).get<double>(), z.at(1).get<double>());
  }
  entry.at("multiplicity").get_to(point.multiplicity);
  return point;
}

inline Problem read_problem(const nlohmann::json& entry) {
  Problem p;
  entry.at("name").get_to(p.name);
  entry.at("file").get_to(p.file);
  entry.at("format").get_to(p.format);
  p.same_as = entry.value("same_as", "");
  entry.at("citations").get_to(p.citations);
  entry.at("verified").get_to(p.verified);
  entry.at("variables").get_to(p.variables);
  entry.at("degrees").get_to(p.degrees);
  entry.at("total_degree").get_to(p.total_degree);
  entry.at("terms").get_to(p.terms);
  entry.at("real_coefficients").get_to(p.has_real_coefficients);
  entry.at("dimension").get_to(p.dimension);
  p.roots = read_root_counts(entry.at("roots"));
  if (!entry.at("at_infinity").is_null()) {
    p.at_infinity = entry.at("at_infinity").get<std::uint64_t>();
  }
  for (const nlohmann::json& point : entry.value("points", nlohmann::json::array())) {
    p.points.push_back(read_known_point(point));
  }
  return p;
}

/// Every problem, in the order of the index. Throws when a field is missing.
inline std::vector<Problem> read_index(const std::string& folder) {
  std::ifstream file(folder + "/index.json");
  if (!file) throw std::runtime_error("no index.json in " + folder);
  std::vector<Problem> problems;
  const nlohmann::json index = nlohmann::json::parse(file);
  for (const nlohmann::json& entry : index.at("problems")) problems.push_back(read_problem(entry));
  return problems;
}

}  // namespace moivre::problems

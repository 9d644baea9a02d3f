// SPDX-License-Identifier: MIT
// Sentences from counts of degrees.
#include "elimination_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace moivre::elimination {
namespace {

/// Number of equations of each degree.
using DegreeCount = std::map<std::uint64_t, std::size_t>;

DegreeCount count_degrees(const std::vector<std::uint64_t>& degrees) {
  DegreeCount count;
  for (std::uint64_t d : degrees) ++count[d];
  return count;
}

/// What `a` holds more than `b`.
DegreeCount difference(DegreeCount a, const DegreeCount& b) {
  for (const auto& [d, count] : b) {
    const auto at = a.find(d);
    if (at != a.end()) at->second -= std::min(at->second, count);
  }
  std::erase_if(a, [](const auto& entry) { return entry.second == 0; });
  return a;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string degree_name(std::uint64_t d) {
  static const std::array<std::string, 5> names{"constant", "linear", "quadratic", "cubic",
                                                "quartic"};
  return d < names.size() ? names[d] : std::string("degree-").append(std::to_string(d));
}

/// "3 quadratic and 1 linear"
std::string to_text(const DegreeCount& count) {
  std::vector<std::string> parts;
  for (auto at = count.rbegin(); at != count.rend(); ++at) {
    parts.push_back(std::to_string(at->second).append(" ").append(degree_name(at->first)));
  }
  return joined(parts);
}

bool is_single(const DegreeCount& count) { return count.size() == 1 && count.begin()->second == 1; }

std::string total_degree_text(const std::vector<std::uint64_t>& degrees) {
  const auto total = total_degree(degrees);
  return total ? std::to_string(*total) : "over 64 bits";
}

}  // namespace

Omission told_combination(const std::vector<std::uint64_t>& before,
                          const std::vector<std::uint64_t>& after,
                          const std::vector<std::uint64_t>& left) {
  const DegreeCount lost = difference(count_degrees(before), count_degrees(after));
  const DegreeCount gained = difference(count_degrees(after), count_degrees(before));
  return {to_text(lost) + (is_single(lost) ? " equation" : " equations") + " combined to " +
              to_text(gained) + (is_single(gained) ? " one" : " ones"),
          "their highest terms cancel: total degree " + total_degree_text(before) + " -> " +
              total_degree_text(left)};
}

std::vector<bool> appears(const System& f) {
  std::vector<bool> result(f.variables.size(), false);
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      for (const Power& power : term.monomial) result[power.variable] = true;
    }
  }
  return result;
}

std::vector<Omission> account(const State& s, const System& reduced, const System& f) {
  std::vector<Omission> sentences = s.combinations;
  std::vector<std::string> names;
  for (const Substitution& substitution : s.substitutions) {
    names.push_back(f.variables[substitution.variable]);
  }
  if (names.size() == 1) {
    sentences.push_back({names[0] + " eliminated", "a linear equation gives it"});
  } else if (!names.empty()) {
    sentences.push_back({joined(names) + " eliminated",
                         std::to_string(names.size()) + " linear equations give them"});
  }
  for (std::size_t origin : s.dependent) {
    sentences.push_back({"equation " + std::to_string(origin + 1),
                         "it follows from the others (0 = 0): it is redundant"});
  }
  if (s.contradiction) {
    sentences.push_back({"all paths", "equation " + std::to_string(*s.contradiction + 1) +
                                          " contradicts the others: no root"});
  }
  const std::vector<bool> used = appears(reduced);
  for (std::size_t j = 0; j < used.size(); ++j) {
    if (!used[j]) sentences.push_back({reduced.variables[j], "no remaining equation contains it"});
  }
  const std::vector<std::uint64_t> left = degrees(reduced);
  const auto linear = std::count(left.begin(), left.end(), std::uint64_t{1});
  if (linear > 0 && !s.contradiction) {
    sentences.push_back(
        {"the elimination of " + std::to_string(linear) +
             (linear == 1 ? " linear equation" : " linear equations"),
         "substitution would make the other equations longer than an unknown fewer is worth"});
  }
  return sentences;
}

}  // namespace moivre::elimination

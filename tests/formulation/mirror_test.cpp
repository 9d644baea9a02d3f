// SPDX-License-Identifier: MIT
// Is the mirror image of a root a root, exactly? Proofs that a closure is real rest on it
// (moivre/closures/root_proofs.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../mechanism/files.h"
#include "moivre/formulation/formulation.h"

namespace moivre {
namespace {

/// x -> conj(p(conj(mirrored x))): what p says of the mirror image.
Polynomial mirrored(const Polynomial& p, const std::vector<std::size_t>& mirror) {
  TermMap terms;
  for (const Term& term : p.terms) {
    Monomial image;
    for (const Power& power : term.monomial) {
      image.push_back({static_cast<std::uint32_t>(mirror[power.variable]), power.exponent});
    }
    std::sort(image.begin(), image.end());
    terms.emplace(std::move(image), Coefficient{term.coefficient.re, -term.coefficient.im});
  }
  return to_polynomial(std::move(terms));
}

/// p = c q with a number c.
bool is_multiple(const Polynomial& p, const Polynomial& q) {
  if (p.terms.empty() || q.terms.empty()) return p.terms.empty() && q.terms.empty();
  return q.terms.front().coefficient * p == p.terms.front().coefficient * q;
}

std::string first_broken(const Formulation& formulation) {
  const auto& all = formulation.system.polynomials;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Polynomial image = mirrored(all[i], formulation.mirror);
    const bool is_kept = std::any_of(all.begin(), all.end(),
                                     [&](const Polynomial& p) { return is_multiple(image, p); });
    if (!is_kept) return formulation.equation_names[i];
  }
  return "";
}

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  const std::string folder = std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The planar and spatial mechanisms of problems/mechanisms at the time of the file and at times
/// where no angle is a whole quarter.
TEST(Mirror, MapsTheClosurePolynomialsOfEveryMechanismToThemselves) {
  for (const std::string& name : example_names()) {
    const Mechanism mechanism = test::example(name);
    for (const double time : {0.0, 0.37, 1.93}) {
      EXPECT_EQ(first_broken(formulate(mechanism, time)), "") << name << " at " << time;
    }
  }
}

TEST(Mirror, UndoesItself) {
  for (const std::string& name : example_names()) {
    const std::vector<std::size_t> mirror = formulate(test::example(name), 0).mirror;
    for (std::size_t v = 0; v < mirror.size(); ++v) EXPECT_EQ(mirror[mirror[v]], v) << name;
  }
}

TEST(Mirror, SeesAnEquationThatItDoesNotKeep) {
  Formulation formulation = formulate(test::example("four-bar"), 0);
  Polynomial& p = formulation.system.polynomials.back();
  p.terms.front().coefficient.im += Rational(1, 7);
  EXPECT_NE(first_broken(formulation), "");
}

}  // namespace
}  // namespace moivre

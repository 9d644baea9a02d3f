// SPDX-License-Identifier: MIT
// Are systems, coefficients, parameters and families refused by name where they cannot be meant?
#include <cmath>
#include <limits>

#include "moivre/bounds/root_bounds.h"
#include "moivre/certify/certifier.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/solver/solve.h"
#include "refused.h"

namespace moivre::test {
namespace {

/// x^2 - p
Family learned_square_root() {
  const auto [x, p] = unknowns<2>();
  const System f = make_system({"x", "p"}, {x * x - p});
  return learn(unlearned_family(f, {{"p", 1}}), cvode());
}

TEST(MisuseTest, ACoefficientThatIsNoNumberIsRefused) {
  const auto [x, y] = unknowns<2>();
  expect_refused([&, x = x] { return kNaN * x; }, "finite, not nan");
  expect_refused([&, x = x] { return x - kInfinity; }, "finite, not inf");
  expect_refused([] { return Rational(-kInfinity); }, "finite, not -inf");
  expect_refused([] { return Coefficient(Complex(1, kNaN)); }, "finite, not nan");
  expect_refused([&, x = x] { return x / 0; }, "by zero");
}

TEST(MisuseTest, AParameterThatIsNoNumberHasNoRoots) {
  const Family family = learned_square_root();
  for (const double p : {kNaN, kInfinity, -kInfinity}) {
    const std::vector<Point> members{{Complex(1)}, {Complex(p)}};
    expect_refused([&] { return solve_members(family, members, cvode()); },
                   "member 1 has a parameter that is not finite");
    expect_refused([&] { return exact_values({Complex(0, p)}); }, "finite");
  }
  const std::vector<Point> members{{Complex(4)}};
  EXPECT_EQ(solve_members(family, members, cvode()).front().roots.size(), 2U);
}

TEST(MisuseTest, EveryBrokenRuleOfASystemIsNamed) {
  System f{{"x", "x", ""}, {}};
  f.polynomials = {{{{1, {{7, 1}}}, {1, {{0, 0}}}}},
                   {{{0, {{0, 1}}}, {1, {{1, 1}, {0, 1}}}}},
                   {{{1, {}}, {2, {}}}}};
  f.groups = {{{0, 9}, false}, {{0}, false}};
  try {
    solve(f, cvode());
    FAIL() << "it was solved";
  } catch (const InvalidInput& refusal) {
    const std::vector<std::string> expected{
        "two unknowns are called 'x'",
        "unknown 3 has no name",
        "term 1 of equation 1 has unknown 7, counted from 0, of 3",
        "term 2 of equation 1 has an exponent 0: exponents are 1 or more",
        "term 1 of equation 2 has the coefficient 0",
        "term 2 of equation 2 has unknowns that are not in their order, each once",
        "the terms of equation 3 are not sorted by their monomials, each once (to_polynomial "
        "sorts them)",
        "group 1 has unknown 9, counted from 0, of 3",
        "unknown 'x' is in two groups",
        "an unknown is in no group"};
    EXPECT_EQ(refusal.broken_rules(), expected);
  }
}

TEST(MisuseTest, EveryEntryRefusesAVariableThatIsNotThere) {
  const System f{{"x"}, {{{{1, {{3, 2}}}}}}};
  const auto refuse = [](const auto& call) { expect_refused(call, "has unknown 3"); };
  refuse([&] { return solve(f, cvode()); });
  refuse([&] { return make_certify_program(f); });
  refuse([&] { return root_bounds(f, {}); });
  refuse([&] { return reference_roots(f, {{1.0}}, 30, 1); });
  refuse([&] { return unlearned_family(f, {{"x", 1}}); });
  refuse([&] { return make_system(f.variables, f.polynomials); });
}

TEST(MisuseTest, ASystemInCodeHasNamesThatAFileCanHold) {
  const auto of_name = [](const char* name) { return make_system({name}, {unknown(0) - 1}); };
  for (const char* name : {"2x", "x y", "x-1", "x_{1}", "f(x)"}) {
    expect_refused([&] { return of_name(name); },
                   "'" + std::string(name) + "' is no name of an unknown");
  }
  for (const char* name : {"i", "I", "pi", "\u03c0"}) {
    expect_refused([&] { return of_name(name); }, "has a meaning of its own");
  }
  for (const char* name : {"x", "_x", "x[1]", "x_1", "\u03b8\u2081", "p_crank"}) {
    EXPECT_EQ(of_name(name).variables, std::vector<std::string>{name});
  }
  // A result of Bertini's file has it.
  EXPECT_EQ(solve(System{{"i"}, {unknown(0) - 1}}, cvode()).solutions.size(), 1U);
}

TEST(MisuseTest, AFamilyThatWasChangedIsRefused) {
  Family family = learned_square_root();
  family.roots[0] = {Complex(kNaN)};
  family.roots[1] = {Complex(1), Complex(2)};
  const auto refuse = [&](const auto& call) {
    expect_refused(call, "root 0 has a number that is not finite; root 1 has 2 numbers, not 1");
  };
  refuse([&] { return solve_member(family, {1}, cvode()); });
  const std::vector<Point> members{{Complex(1)}};
  refuse([&] { return solve_members(family, members, cvode()); });
  refuse([&] { return trace_test(family, cvode()); });
  family.generic = {};
  expect_refused([&] { return solve_member(family, {1}, cvode()); },
                 "the generic member has 0 numbers, not 1");
  family.sizes = {0};
  expect_refused([&] { return learn(family, cvode()); }, "must be finite and above 0");
}

TEST(MisuseTest, APairOfMonodromyIsFinite) {
  const auto [x, p] = unknowns<2>();
  const Family family = unlearned_family(make_system({"x", "p"}, {x * x - p}), {{"p", 1}});
  expect_refused([&] { return learn_by_monodromy(family, {{kNaN}, {1.0}}, cvode()); }, "finite");
  MonodromyOptions options;
  options.threads = -3;
  expect_refused(
      [&] {
        return learn_by_monodromy(family, {{1.0}, {1.0}}, cvode(), options);
      },
      "threads");
}

TEST(MisuseTest, PowersAreNotNegative) {
  const Polynomial x = unknown(0);
  expect_refused([&] { return pow(x, -1); }, "no power -1");
  EXPECT_EQ(pow(x + 1, 0), constant(1));
  EXPECT_THROW(pow(unknown(0) * pow(x, 1 << 30), 1 << 30), std::overflow_error);
}

}  // namespace
}  // namespace moivre::test

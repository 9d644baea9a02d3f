// SPDX-License-Identifier: MIT
// Is a root refuted that does not meet a condition of the file, said to be on the boundary where
// that is all that can be told, and missed nowhere where it was not asked for?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "moivre/certify/certifier.h"
#include "moivre/polynomial/read.h"
#include "results.h"

namespace moivre::test {
namespace {

/// Roots 1 and 2 of plane.json are (2, 1, 1) and (1, 2, 1), 3 and 4 are not real.
Judgement plane_where(const std::string& conditions, const Json& result = honest("plane")) {
  System f = system_of_result("plane");
  f.conditions = read_conditions({"conditions", conditions}, f.variables);
  return check(f, read_claims({"result", result.dump()}, f.variables));
}

const ClaimTally* inequalities(const Judgement& judgement) {
  const auto& claims = judgement.claims;
  const auto found = std::find_if(claims.begin(), claims.end(), [](const ClaimTally& tally) {
    return tally.claim == ClaimKind::inequality;
  });
  return found == claims.end() ? nullptr : &*found;
}

TEST(CheckConditions, ARootThatDoesNotMeetOneIsRefutedByItsNumber) {
  const Judgement judgement = plane_where("x > y");
  EXPECT_FALSE(refutes(judgement, ClaimKind::inequality, 1)) << lines(judgement.refuted);
  EXPECT_TRUE(refutes(judgement, ClaimKind::inequality, 2)) << lines(judgement.refuted);
  EXPECT_NE(lines(judgement.refuted).find("root 2, inequality: does not meet x > y"),
            std::string::npos);
}

TEST(CheckConditions, ARootThatIsNotRealMeetsNone) {
  const Judgement judgement = plane_where("z > -100");
  EXPECT_TRUE(refutes(judgement, ClaimKind::inequality, 3));
  EXPECT_TRUE(refutes(judgement, ClaimKind::inequality, 4));
  EXPECT_EQ(judgement.refuted.size(), 2U) << lines(judgement.refuted);
}

TEST(CheckConditions, EveryConditionIsJudgedAtEveryRoot) {
  Json real = honest("plane");
  real["solutions"].erase(3);
  real["solutions"].erase(2);
  const Judgement judgement = plane_where("x > 0; y < 3/2", real);
  ASSERT_NE(inequalities(judgement), nullptr);
  EXPECT_EQ(inequalities(judgement)->holds, 3U);
  EXPECT_EQ(inequalities(judgement)->refuted, 1U);
  EXPECT_EQ(inequalities(plane_where("")), nullptr) << "a file without conditions claims none";
}

TEST(CheckConditions, ARationalRootOnTheBoundaryIsDecidedExactly) {
  const Judgement closed = plane_where("x*y <= 2");
  EXPECT_FALSE(refutes(closed, ClaimKind::inequality, 1)) << lines(closed.refuted);
  EXPECT_EQ(inequalities(closed)->holds, 2U);
  EXPECT_TRUE(refutes(plane_where("x*y < 2"), ClaimKind::inequality, 1));
}

/// x = sqrt(2), as double has it.
Judgement root_of_two(const std::string& condition, double accuracy) {
  System f = read_system({"f", "x^2 - 2;"});
  f.conditions = read_conditions({"conditions", condition}, f.variables);
  Claims claims;
  claims.system = SystemClaim{{"x"}, {2}, 2};
  RootClaim root;
  root.path = 0;
  root.x = {1.4142135623730951};
  root.real = true;
  root.accuracy = accuracy;
  root.singular = false;
  claims.roots = {root};
  return check(f, claims);
}

TEST(CheckConditions, ARootOnTheBoundaryAsFarAsCanBeToldIsSaidSo) {
  for (const char* condition : {"x^2 <= 2", "x^2 < 2", "x^2 >= 2"}) {
    const Judgement judgement = root_of_two(condition, 2e-16);
    EXPECT_FALSE(refutes(judgement, ClaimKind::inequality, 1)) << condition;
    EXPECT_NE(lines(judgement.open)
                  .find("root 1, inequality: on the boundary of " + std::string(condition) +
                        ", as far as the accuracy tells"),
              std::string::npos)
        << lines(judgement.open);
    EXPECT_TRUE(judgement.proofs_hold()) << "no proof is claimed of a condition";
  }
}

TEST(CheckConditions, ACertificateTellsMoreThanTheAccuracyThatIsStated) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  EXPECT_EQ(inequalities(root_of_two("x > 1.4142135", 1e-6))->holds, 1U);
  EXPECT_TRUE(refutes(root_of_two("x < 1.4142135", 1e-6), ClaimKind::inequality, 1));
}

TEST(CheckConditions, AClusterIsNotTakenForTheExactRootInIt) {
  System f = read_system({"f", "(x - 1)^2;"});
  f.conditions = read_conditions({"conditions", "x >= 1"}, f.variables);
  Claims claims;
  claims.system = SystemClaim{{"x"}, {2}, 2};
  RootClaim root;
  root.path = 0;
  root.x = {1.0};
  root.real = root.singular = root.cluster = true;
  root.multiplicity = 2;
  root.accuracy = 1e-7;
  claims.roots = {root};
  EXPECT_EQ(inequalities(check(f, claims))->open, 1U);
  claims.roots[0].cluster = false;
  EXPECT_EQ(inequalities(check(f, claims))->holds, 1U);
}

// Two double roots 7e-9 apart, beside a line: neither exact algebra nor a certificate tells them.
TEST(CheckMultiplicities, ThatAreNoClustersAreClaimsOfAProof) {
  const System f =
      read_system({"f", "(x - y - 5)*((x^2 - 2)^2 - 1/10^16); (x - y - 5)*(y^2 - 3)^2*(x + 7);"});
  Claims claims;
  claims.system = SystemClaim{{"x", "y"}, {5, 6}, 30};
  RootClaim root;
  root.path = 0;
  root.x = {std::sqrt(2.0), std::sqrt(3.0)};
  root.real = root.singular = true;
  root.multiplicity = 4;
  root.accuracy = 3e-8;
  for (const bool is_cluster : {true, false}) {
    root.cluster = is_cluster;
    claims.roots = {root};
    const Judgement judgement = check(f, claims);
    EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
    EXPECT_EQ(judgement.proofs_hold(), is_cluster);
  }
}

TEST(CheckConditions, OfTwoRootsAtOneDoubleTheExactOneIsNotTakenForTheOther) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  System f = read_system({"f", "(x - 1)*(x - 1 - 1e-17);"});
  f.conditions = read_conditions({"conditions", "x > 1"}, f.variables);
  Claims claims;
  claims.system = SystemClaim{{"x"}, {2}, 2};
  RootClaim root;
  root.x = {1.0};
  root.real = true;
  root.singular = false;
  root.accuracy = 1e-16;
  for (const std::uint64_t path : {0U, 1U}) {
    root.path = path;
    claims.roots.push_back(root);
  }
  const Judgement judgement = check(f, claims);
  EXPECT_EQ(judgement.roots.distinct, 2U) << lines(judgement.open);
  EXPECT_EQ(inequalities(judgement)->refuted, 1U) << "1 + 1e-17 meets x > 1";
}

/// Root 1 of plane.json alone, the three others as not asked for; the bound that all meet is named.
Json one_of_four() {
  Json result = honest("plane");
  while (result["solutions"].size() > 1) result["solutions"].erase(1);
  result["solutions"][0]["certified"] = true;
  result["filtered"] = 3;
  result["completeness"] = "proved";
  result["bound"] = {{"kind", "total degree"}, {"value", 4}};
  return result;
}

TEST(CheckLeftOut, RootsThatWereNotAskedForAreMissingNowhere) {
  const Judgement judgement = judged("plane", one_of_four());
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
}

TEST(CheckLeftOut, ThatThereIsNoOtherRootIsNotVerifiedWhereSomeAreNotListed) {
  const Judgement judgement = judged("plane", one_of_four());
  EXPECT_EQ(judgement.unverified_proofs, 1U) << lines(judgement.open);
  EXPECT_FALSE(judgement.proofs_hold());
}

TEST(CheckLeftOut, FewerThanExactAlgebraCountsAreRefuted) {
  Json result = one_of_four();
  result["filtered"] = 2;
  const Judgement judgement = judged("plane", result);
  EXPECT_TRUE(refutes(judgement, ClaimKind::complete)) << lines(judgement.refuted);
  EXPECT_TRUE(refutes(judgement, ClaimKind::bound)) << lines(judgement.refuted);
}

TEST(CheckConditions, AListOfPhcpackKnowsNone) {
  System f = system_of_result("eco-6");
  f.conditions = {{unknown(0), true, "x1 > 0"}};
  const std::string text = result_text("eco-6.out");
  const std::string list = text.substr(text.rfind("THE SOLUTIONS"));
  EXPECT_EQ(inequalities(check(f, read_claims({"list", list}, f.variables))), nullptr);
}

}  // namespace
}  // namespace moivre::test

// SPDX-License-Identifier: MIT
// Is each of these lies found, by the name of the claim and the root's number; and does what is
// honest pass?
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "moivre/certify/certifier.h"
#include "results.h"

namespace moivre::test {
namespace {

struct Lie {
  const char* name;
  const char* result;  ///< of tests/check/results
  std::function<void(Json&)> plant;
  ClaimKind claim;
  std::size_t root = 0;  ///< number of the root that must be named; 0: none
};

void PrintTo(const Lie& lie, std::ostream* out) { *out << lie.name; }

Json& root(Json& result, std::size_t number) { return result["solutions"][number - 1]; }
Json& part(Json& result, std::size_t number, std::size_t j, std::size_t im = 0) {
  return root(result, number)["x"][j][im];
}

double scale_of(const Json& root) {
  double scale = 1;
  for (const Json& xj : root["x"]) {
    scale = std::max(scale, std::abs(std::complex<double>(xj[0], xj[1])));
  }
  return scale;
}

void move_by_accuracies(Json& result, std::size_t number, std::size_t j, double times) {
  Json& r = root(result, number);
  part(result, number, j) =
      part(result, number, j).get<double>() + times * r["accuracy"].get<double>() * scale_of(r);
}

/// One root less, with sums that fit: nothing but a bound or a conjugate can tell.
void leave_out(Json& result, std::size_t number) {
  const auto m = root(result, number)["multiplicity"].get<std::uint64_t>();
  result["solutions"].erase(number - 1);
  result["paths"]["finite"] = result["paths"]["finite"].get<std::uint64_t>() - m;
  result["paths"]["at_infinity"] = result["paths"]["at_infinity"].get<std::uint64_t>() + m;
}

/// The root once more under the number of a path at infinity, with sums that fit.
void double_root(Json& result, std::size_t number) {
  Json again = root(result, number);
  again["path"] = result["paths"]["tracked"];
  const auto m = again["multiplicity"].get<std::uint64_t>();
  result["solutions"].push_back(again);
  for (const char* key : {"tracked", "finite"}) {
    result["paths"][key] = result["paths"][key].get<std::uint64_t>() + m;
  }
  result["start"]["paths"] = result["paths"]["tracked"];
}

void raise(Json& count) { count = count.get<std::uint64_t>() + 1; }

/// Number of the first root that is real, or is not.
std::size_t first_root(const Json& result, bool real) {
  for (std::size_t k = 0; k < result["solutions"].size(); ++k) {
    if (result["solutions"][k]["real"] == real) return k + 1;
  }
  throw std::logic_error("no such root");
}

// Of plane.json: roots 1 and 2 are real, 3 and 4 conjugates; of doubles.json: roots 1 and 3 are
// double.
const Lie kLies[] = {
    {"a root moved by ten accuracies", "plane", [](Json& r) { move_by_accuracies(r, 3, 2, 10); },
     ClaimKind::accuracy, 3},
    {"a root of many unknowns moved by ten accuracies", "eco-6",
     [](Json& r) { move_by_accuracies(r, 5, 1, 10); }, ClaimKind::accuracy, 5},
    {"an ill-scaled root moved by ten accuracies", "cassou",
     [](Json& r) { move_by_accuracies(r, 2, 0, 10); }, ClaimKind::accuracy, 2},
    {"a root moved by a ten-thousandth", "plane", [](Json& r) { part(r, 1, 0) = 2.0001; },
     ClaimKind::root, 1},
    {"a root made up", "cassou",
     [](Json& r) {
       for (std::size_t j = 0; j < 4; ++j) part(r, 7, j) = 0.5 + static_cast<double>(j);
     },
     ClaimKind::root, 7},
    {"coordinates exchanged", "plane",
     [](Json& r) { std::swap(root(r, 1)["x"][0], root(r, 1)["x"][2]); }, ClaimKind::root, 1},
    {"coordinates exchanged, which makes another root", "plane",
     [](Json& r) { std::swap(root(r, 1)["x"][0], root(r, 1)["x"][1]); }, ClaimKind::distinct, 2},
    {"a root twice", "plane", [](Json& r) { double_root(r, 2); }, ClaimKind::distinct, 5},
    {"a root twice, a little beside itself", "eco-6",
     [](Json& r) {
       double_root(r, 3);
       move_by_accuracies(r, 17, 0, 0.5);
     },
     ClaimKind::distinct, 17},
    {"a double root twice", "doubles", [](Json& r) { double_root(r, 1); }, ClaimKind::distinct, 5},
    {"more roots than Bezout's number", "doubles", [](Json& r) { double_root(r, 1); },
     ClaimKind::multiplicity},
    {"a root left out, and the sums as before", "plane", [](Json& r) { r["solutions"].erase(3); },
     ClaimKind::paths},
    {"a root left out where the bound proves it", "eco-6",
     [](Json& r) {
       r["completeness"] = "proved";
       leave_out(r, first_root(r, true));
     },
     ClaimKind::completeness},
    {"a root left out where exact algebra counts it", "cassou",
     [](Json& r) { leave_out(r, first_root(r, true)); }, ClaimKind::complete},
    {"completeness proved with multiple roots that no line tells", "crossed-surds",
     [](Json& r) { r["completeness"] = "proved"; }, ClaimKind::completeness},
    {"a multiplicity that the exponents do not allow", "powers",
     [](Json& r) {
       root(r, 1)["multiplicity"] = 5;
       root(r, 2)["multiplicity"] = 7;
     },
     ClaimKind::multiplicity, 1},
    {"a root of powers called regular", "powers", [](Json& r) { root(r, 1)["singular"] = false; },
     ClaimKind::multiplicity, 1},
    {"a root of powers moved", "powers",
     [](Json& r) { root(r, 1)["x"][0][0] = root(r, 1)["x"][0][0].get<double>() + 1e-3; },
     ClaimKind::root, 1},
    {"a conjugate left out", "plane", [](Json& r) { leave_out(r, 4); }, ClaimKind::complete, 3},
    {"a real root called not real", "plane", [](Json& r) { root(r, 1)["real"] = false; },
     ClaimKind::real, 1},
    {"a root that is not real called real", "plane", [](Json& r) { root(r, 3)["real"] = true; },
     ClaimKind::real, 3},
    {"a real double root called not real", "doubles", [](Json& r) { root(r, 1)["real"] = false; },
     ClaimKind::real, 1},
    {"a count of real roots", "plane",
     [](Json& r) {
       r["counts"] = {{"real", 3}};
     },
     ClaimKind::real},
    {"a count of roots", "plane",
     [](Json& r) {
       r["counts"] = {{"complex", 5}};
     },
     ClaimKind::complete},
    {"tracked", "plane", [](Json& r) { raise(r["paths"]["tracked"]); }, ClaimKind::paths},
    {"finite", "plane", [](Json& r) { raise(r["paths"]["finite"]); }, ClaimKind::paths},
    {"at infinity", "cassou", [](Json& r) { raise(r["paths"]["at_infinity"]); }, ClaimKind::paths},
    {"failed", "plane", [](Json& r) { raise(r["paths"]["failed"]); }, ClaimKind::complete},
    {"failed paths that are not listed", "plane", [](Json& r) { raise(r["paths"]["failed"]); },
     ClaimKind::paths},
    {"on sets", "doubles", [](Json& r) { raise(r["paths"]["on_positive_dimensional"]); },
     ClaimKind::paths},
    {"excess", "three", [](Json& r) { raise(r["excess"]); }, ClaimKind::paths},
    {"multiplicity too high", "doubles",
     [](Json& r) {
       root(r, 1)["multiplicity"] = 3;
       root(r, 1)["winding"] = {3};
     },
     ClaimKind::paths},
    {"a regular root called double", "plane",
     [](Json& r) {
       root(r, 1)["multiplicity"] = 2;
       root(r, 1)["singular"] = true;
     },
     ClaimKind::multiplicity, 1},
    {"a regular root called singular", "plane", [](Json& r) { root(r, 2)["singular"] = true; },
     ClaimKind::multiplicity, 2},
    {"a root that is not singular, of multiplicity 2", "plane",
     [](Json& r) { root(r, 2)["multiplicity"] = 2; }, ClaimKind::multiplicity, 2},
    {"a random point called a double root", "doubles",
     [](Json& r) { part(r, 1, 0) = 1.3, part(r, 1, 1) = 0.7; }, ClaimKind::root, 1},
    {"a double root moved by ten accuracies", "doubles",
     [](Json& r) { move_by_accuracies(r, 3, 1, 10); }, ClaimKind::root, 3},
    {"windings that do not add up", "doubles", [](Json& r) { root(r, 1)["winding"] = {1}; },
     ClaimKind::paths, 1},
    {"a path that ends at two roots", "plane", [](Json& r) { root(r, 2)["path"] = 0; },
     ClaimKind::paths, 2},
    {"a path that was not tracked", "plane", [](Json& r) { root(r, 4)["path"] = 4; },
     ClaimKind::paths, 4},
    {"a residual too large", "plane", [](Json& r) { root(r, 1)["residual"] = 1e-3; },
     ClaimKind::residual, 1},
    {"a residual too small", "doubles",
     [](Json& r) {
       part(r, 2, 0) = -2.0000001;
       root(r, 2)["accuracy"] = 1e-6;
       root(r, 2)["real"] = false;
     },
     ClaimKind::residual, 2},
    {"an accuracy too good", "eco-6", [](Json& r) { root(r, 4)["accuracy"] = 1e-20; },
     ClaimKind::accuracy, 4},
    {"an accuracy below zero", "plane", [](Json& r) { root(r, 1)["accuracy"] = -1e-16; },
     ClaimKind::accuracy, 1},
    {"a condition far too good", "cassou", [](Json& r) { root(r, 1)["condition"] = 1.0; },
     ClaimKind::condition, 1},
    {"a certificate of a point that is no root", "plane",
     [](Json& r) {
       part(r, 1, 0) = 2.5;
       root(r, 1)["certified"] = true;
     },
     ClaimKind::certified, 1},
    {"a certificate of a double root called simple", "doubles",
     [](Json& r) {
       root(r, 1)["multiplicity"] = 1;
       root(r, 1)["singular"] = false;
       root(r, 1)["certified"] = true;
     },
     ClaimKind::certified, 1},
    {"another file by its unknowns", "plane",
     [](Json& r) {
       r["system"]["variables"] = {"x", "y", "w"};
     },
     ClaimKind::system},
    {"another order of the unknowns", "plane",
     [](Json& r) {
       r["system"]["variables"] = {"y", "x", "z"};
     },
     ClaimKind::system},
    {"a degree", "plane",
     [](Json& r) {
       r["system"]["degrees"] = {2, 3, 1};
     },
     ClaimKind::system},
    {"Bezout's number", "plane", [](Json& r) { r["system"]["total_degree"] = 6; },
     ClaimKind::system},
    {"what was tracked", "plane",
     [](Json& r) {
       r["reduced"]["degrees"] = {2, 4};
     },
     ClaimKind::reduced},
    {"the total degree of what was tracked", "cassou",
     [](Json& r) { raise(r["start"]["counts"]["total_degree"]); }, ClaimKind::start},
    {"the mixed volume", "eco-6", [](Json& r) { raise(r["start"]["counts"]["mixed_volume"]); },
     ClaimKind::start},
    {"the multihomogeneous number", "eco-6",
     [](Json& r) { raise(r["start"]["counts"]["multihomogeneous"]); }, ClaimKind::start},
    {"the paths of the start", "cassou", [](Json& r) { raise(r["start"]["paths"]); },
     ClaimKind::start},
    {"complete, with a failed path", "cassou",
     [](Json& r) {
       raise(r["paths"]["failed"]);
       raise(r["paths"]["tracked"]);
       r["failures"].push_back({{"path", 3}});
     },
     ClaimKind::complete},
    {"a digit beyond double", "plane-40",
     [](Json& r) { root(r, 3)["x_digits"][0][1] = "2.236067977499789696409173668731276235450"; },
     ClaimKind::digits, 3},
    {"a root left out of more equations than unknowns", "three", [](Json& r) { leave_out(r, 1); },
     ClaimKind::complete},
    {"a simple root left out beside a curve", "beside-a-curve", [](Json& r) { leave_out(r, 1); },
     ClaimKind::complete},
    {"a proof without a bound", "crossed-surds",
     [](Json& r) {
       r["completeness"] = "proved";
       r["bound"] = nullptr;
     },
     ClaimKind::completeness},
    {"two roots that double does not part called a double one", "near-pairs",
     [](Json& r) {
       r["solutions"].erase(1);
       root(r, 1).update({{"multiplicity", 2}, {"singular", true}, {"winding", {2}}});
       root(r, 1)["certified"] = nullptr;
       r["completeness"] = "shown";
       r["bound"] = nullptr;
     },
     ClaimKind::multiplicity, 1},
    {"two roots 1e-31 apart called a double one known to 1e-7", "pairs-256",
     [](Json& r) {
       r["solutions"].erase(4);
       root(r, 1).update({{"multiplicity", 2}, {"singular", true}, {"winding", {2}}});
       root(r, 1).update({{"certified", false}, {"accuracy", 1.1e-7}});
       r["completeness"] = "shown";
       r["bound"] = nullptr;
     },
     ClaimKind::multiplicity, 1},
    {"a bound of another value", "near-pairs", [](Json& r) { raise(r["bound"]["value"]); },
     ClaimKind::bound},
    {"a bound of another kind", "near-pairs", [](Json& r) { r["bound"]["kind"] = "elimination"; },
     ClaimKind::bound},
    {"a bound that there is not", "near-pairs", [](Json& r) { r["bound"]["kind"] = "intuition"; },
     ClaimKind::bound},
    {"a bound that rests on less than is said", "near-pairs",
     [](Json& r) { r["bound"]["certainty"] = "conviction"; }, ClaimKind::bound},
    {"a bound of powers without their exponents", "powers",
     [](Json& r) { r["bound"]["value"] = 2; }, ClaimKind::bound},
    {"a bound beside a completeness that is shown", "near-pairs",
     [](Json& r) { r["completeness"] = "shown"; }, ClaimKind::bound},
    {"a proof, and a root that is moved and no longer certified", "near-pairs",
     [](Json& r) {
       part(r, 1, 0) = 1.01 * part(r, 1, 0).get<double>() + 0.01;
       root(r, 1)["certified"] = false;
       root(r, 1)["accuracy"] = 0.1;
     },
     ClaimKind::completeness},
    {"an excess root of the combinations called one of the file", "three",
     [](Json& r) { part(r, 1, 0) = -part(r, 1, 0).get<double>(); }, ClaimKind::root, 1},
};

class PlantedLies : public testing::TestWithParam<Lie> {};

TEST_P(PlantedLies, AreFoundByTheNameOfTheClaim) {
  const Lie& lie = GetParam();
  if (lie.claim == ClaimKind::digits && !proves_beyond_double()) {
    GTEST_SKIP() << "needs more digits";
  }
  Json result = honest(lie.result);
  lie.plant(result);
  const std::string name = lie.result;
  const Judgement judgement = judged(name == "plane-40" ? "plane" : name, result);
  EXPECT_FALSE(judgement.holds());
  EXPECT_TRUE(refutes(judgement, lie.claim, lie.root)) << lines(judgement.refuted);
}

INSTANTIATE_TEST_SUITE_P(All, PlantedLies, testing::ValuesIn(kLies));

TEST(Check, HonestResultsPass) {
  for (const char* name :
       {"plane", "doubles", "three", "cassou", "eco-6", "powers", "beside-a-curve"}) {
    const Judgement judgement = judged(name, honest(name));
    EXPECT_TRUE(judgement.holds()) << name << '\n' << lines(judgement.refuted);
    EXPECT_TRUE(judgement.proofs_hold()) << name << '\n' << lines(judgement.open);
  }
  EXPECT_TRUE(judged("plane", honest("plane-40")).holds());
}

// Two and two roots 2e-20 apart are the same doubles. The third one at a place is one too many.
TEST(Check, RootsThatDoubleDoesNotTellApartAreAsManyAsThereAre) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  Json result = honest("near-pairs");
  const Judgement judgement = judged("near-pairs", result);
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
  EXPECT_EQ(judgement.roots.distinct, 4U);
  EXPECT_EQ(judgement.proved_by, BoundKind::bezout);
  double_root(result, 1);
  EXPECT_TRUE(refutes(judged("near-pairs", result), ClaimKind::distinct, 5));
}

TEST(Check, TellsWhatIsProved) {
  const Judgement plane = judged("plane", honest("plane"));
  EXPECT_EQ(plane.roots.certified, 4U);
  EXPECT_EQ(plane.roots.distinct, 4U);
  EXPECT_EQ(plane.roots.real, 2U);
  EXPECT_EQ(plane.roots.not_real, 2U);
  EXPECT_EQ(plane.proved_by, BoundKind::bezout);
  EXPECT_TRUE(plane.open.empty()) << lines(plane.open);
  EXPECT_EQ(judged("eco-6", honest("eco-6")).proved_by, BoundKind::stable_mixed_volume);
  const Judgement cassou = judged("cassou", honest("cassou"));
  EXPECT_EQ(cassou.roots.distinct, 16U);
  EXPECT_EQ(cassou.proved_by, BoundKind::quotient_ring);
}

TEST(Check, HonestClaimsOfProofsHold) {
  for (const char* name : {"plane", "eco-6"}) {
    Json result = honest(name);
    result["completeness"] = "proved";
    for (Json& solution : result["solutions"]) solution["certified"] = true;
    const Judgement judgement = judged(name, result);
    EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
    EXPECT_TRUE(judgement.open.empty()) << lines(judgement.open);
  }
}

TEST(Check, RepeatsWhatItCannotVerify) {
  const auto is_open = [](const Judgement& judgement, ClaimKind claim) {
    return std::any_of(judgement.open.begin(), judgement.open.end(),
                       [claim](const Finding& f) { return f.claim == claim; });
  };
  Json result = honest("crossed-surds");
  result["completeness"] = "shown";
  EXPECT_TRUE(is_open(judged("crossed-surds", result), ClaimKind::completeness));
  result["completeness"] = "open";
  EXPECT_FALSE(is_open(judged("crossed-surds", result), ClaimKind::completeness));
  const auto open_multiplicities = [](const Judgement& judgement) {
    return std::count_if(judgement.open.begin(), judgement.open.end(),
                         [](const Finding& f) { return f.claim == ClaimKind::multiplicity; });
  };
  // Roots of x = 1 are counted by their local rings, those of x = sqrt(2) by the quotient ring
  // where it has them in one direction, else by nobody.
  EXPECT_EQ(open_multiplicities(judged("doubles", honest("doubles"))), 0);
  EXPECT_EQ(open_multiplicities(judged("surds", honest("surds"))), 0);
  EXPECT_EQ(open_multiplicities(judged("crossed-surds", honest("crossed-surds"))), 4);
}

// A run that is interrupted on two threads has followed paths of any number.
TEST(Check, AnInterruptedRunHasFollowedSomeOfItsPaths) {
  Json result = honest("cassou");
  result["complete"] = false;
  result["message"] = "interrupted: what is finished is reported";
  while (result["solutions"].size() > 2) result["solutions"].erase(1);
  result["paths"]["tracked"] = result["paths"]["finite"] = 2;
  result["paths"]["at_infinity"] = 0;
  root(result, 2)["path"] = 23;
  const Judgement judgement = judged("cassou", result);
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
  root(result, 2)["path"] = 24;
  EXPECT_TRUE(refutes(judged("cassou", result), ClaimKind::paths, 2));
}

// (x - 1)^2 = 1e-36 in a file of its own: the roots are one number of double.
TEST(Check, AProofThatIsNotFoundAgainIsNotCalledFalse) {
  const System f = system_of_result("near-pairs");
  Json result = honest("near-pairs");
  // Points so far from the roots that no certificate is found near them, and none that there is no
  // root.
  for (Json& solution : result["solutions"]) {
    for (Json& xj : solution["x"]) xj[0] = xj[0].get<double>() * (1 + 1e-5);
    solution["accuracy"] = 1e-3;
    solution["condition"] = 1e16;
  }
  const Judgement judgement = judged("near-pairs", result);
  EXPECT_FALSE(judgement.proofs_hold());
  EXPECT_FALSE(refutes(judgement, ClaimKind::completeness)) << lines(judgement.refuted);
}

TEST(Check, AStopEndsTheJudgementWithWhatWasJudged) {
  const System f = system_of_result("eco-6");
  const Claims claims = read_claims({"result", honest("eco-6").dump()}, f.variables);
  const std::atomic<bool> stop{true};
  const Judgement judgement = check(f, claims, stop);
  EXPECT_TRUE(judgement.interrupted);
  EXPECT_TRUE(judgement.holds()) << lines(judgement.refuted);
  EXPECT_FALSE(judgement.proofs_hold());
}

TEST(Check, JudgesTheSumsOfAnotherFileButNotItsRoots) {
  const System f = system_of_result("plane");
  const Judgement judgement =
      check(f, read_claims({"result", honest("cassou").dump()}, f.variables));
  EXPECT_FALSE(judgement.is_judged_whole);
  EXPECT_EQ(lines(judgement.refuted),
            "system: another file: its unknowns are b c d e, the system's x y z\n");
}

}  // namespace
}  // namespace moivre::test

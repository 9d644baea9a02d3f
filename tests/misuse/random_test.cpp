// SPDX-License-Identifier: MIT
// Does anything that is put together at random, and put together wrongly, do worse than being
// refused?
//
// Systems, families, mechanisms and arms are changed in one to three random places and handed to
// the entries of the library. Each may be refused (InvalidInput, or std::overflow_error where paths
// or exponents are too many) or answered with finite numbers, and nothing else; what was given a
// number that is not finite is refused.
// MOIVRE_MISUSES sets how many are tried of each kind, MOIVRE_MISUSE_SEED from which seed on; the
// sanitizers see what reads or writes beyond its place.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

#include "moivre/arms/arm_closures.h"
#include "moivre/arms/pose_table.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/rules.h"
#include "moivre/arms/turns.h"
#include "moivre/bounds/root_bounds.h"
#include "moivre/certify/certifier.h"
#include "moivre/closures/closures.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/family/parameter_homotopy.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/own_newton.h"
#include "moivre/mechanism/builder.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/mechanism/rules.h"
#include "moivre/motion/motion.h"
#include "moivre/multiprecision/reference_roots.h"
#include "moivre/polynomial/read.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"
#include "refused.h"

namespace moivre::test {
namespace {

int misuses() {
  const char* wanted = std::getenv("MOIVRE_MISUSES");
  return wanted != nullptr ? std::atoi(wanted) : 300;
}

/// The seed of misuse k. MOIVRE_MISUSE_SEED=<seed> MOIVRE_MISUSES=1 shows one fault again.
std::uint64_t seed_of(int k) {
  const char* first = std::getenv("MOIVRE_MISUSE_SEED");
  return (first != nullptr ? std::strtoull(first, nullptr, 10) : 0) + static_cast<std::uint64_t>(k);
}

/// Random slips from a seed.
class Slips {
 public:
  explicit Slips(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double number() {
    const double odd[] = {0, -1, 5, 1e-9, 1e9, 1e60, 1e300, kNaN, kInfinity, -kInfinity, 0.5, 2};
    return odd[below(std::size(odd))];
  }
  std::size_t index() {
    const std::size_t odd[] = {
        0, 1, 2, 3, 7, 9, 1'000'000'000, std::numeric_limits<std::size_t>::max()};
    return odd[below(std::size(odd))];
  }
  std::string name() {
    const char* odd[] = {"",   "x", "y", "a b",  "ground", "crank.A",
                         "\"", "A", "B", "\xff", "1",      "#"};
    return odd[below(std::size(odd))];
  }
  Eigen::VectorXd vector() {
    Eigen::VectorXd v(static_cast<Eigen::Index>(below(13)));
    for (double& x : v) x = one_in(3) ? number() : 0.3;
    return v;
  }

 private:
  std::mt19937_64 random_;
};

struct Tally {
  int refused = 0;
  int answered = 0;
};

bool is_number(const Eigen::VectorXd& v) { return v.allFinite(); }
bool is_number(const std::vector<Complex>& v) {
  return std::all_of(v.begin(), v.end(), [](const Complex& z) { return is_finite(z); });
}
bool are_numbers(std::initializer_list<double> all) {
  return std::all_of(all.begin(), all.end(), [](double x) { return std::isfinite(x); });
}

/// Calls; what is thrown must be a refusal, and one must be where numbers were given that are none.
template <class Call>
void attempt(Tally& tally, const Call& call, bool has_numbers = true) {
  try {
    call();
    ++tally.answered;
    EXPECT_TRUE(has_numbers) << "NaN or infinity was answered";
  } catch (const InvalidInput& refusal) {
    EXPECT_FALSE(refusal.broken_rules().empty());
    EXPECT_EQ(std::string(refusal.what()).find("--"), std::string::npos) << refusal.what();
    ++tally.refused;
  } catch (const std::overflow_error&) {
    ++tally.refused;
  } catch (const std::exception& other) {
    ADD_FAILURE() << other.what();
  }
}

System random_system(Slips& slips) {
  const std::size_t n = 1 + slips.below(3);
  const std::vector<Polynomial> x = unknowns(n);
  System f;
  for (std::size_t i = 0; i < n; ++i) {
    f.variables.push_back("x" + std::to_string(i));
    Polynomial p = constant(static_cast<int>(slips.below(7)) + 1);
    for (int terms = 0; terms < 4; ++terms) {
      p += (static_cast<int>(slips.below(9)) - 4) * x[slips.below(n)] *
           pow(x[slips.below(n)], static_cast<int>(slips.below(2)));
    }
    f.polynomials.push_back(p);
  }
  return f;
}

void spoil(System& f, Slips& slips) {
  Polynomial& p = f.polynomials[slips.below(f.polynomials.size())];
  Term* term = p.terms.empty() ? nullptr : &p.terms[slips.below(p.terms.size())];
  switch (slips.below(12)) {
    case 0:
      if (term != nullptr) term->monomial.push_back({static_cast<std::uint32_t>(slips.index()), 1});
      break;
    case 1:
      if (term != nullptr && !term->monomial.empty()) term->monomial[0].exponent = 0;
      break;
    case 2:
      if (term != nullptr) term->coefficient = 0;
      break;
    case 3:
      std::reverse(p.terms.begin(), p.terms.end());
      break;
    case 4:
      if (term != nullptr) p.terms.push_back(Term(*term));
      break;
    case 5:
      f.variables[slips.below(f.variables.size())] = slips.name();
      break;
    case 6:
      f.groups.push_back({{static_cast<std::uint32_t>(slips.index())}, slips.one_in(2)});
      break;
    case 7:
      f.variables.push_back(slips.name());
      break;
    case 8:
      p = {};
      break;
    case 9:
      f.denominators.push_back({{{1, {{static_cast<std::uint32_t>(slips.index()), 1}}}}});
      break;
    case 10:
      if (term != nullptr && !term->monomial.empty()) {
        term->monomial[0].exponent = static_cast<std::uint32_t>(slips.index());
      }
      break;
    default:
      f.polynomials.push_back(p);
  }
}

/// Large degrees are of no interest here, and take long.
bool is_small(const System& f) {
  std::uint64_t sum = 0;
  for (const std::uint64_t d : degrees(f)) sum += d;
  return sum <= 9;
}

SolveOptions random_options(Slips& slips) {
  SolveOptions options;
  options.threads = 1;
  if (slips.one_in(8)) options.threads = slips.one_in(2) ? -1 : 1 << 20;
  if (slips.one_in(20)) options.tolerance_level = -1;
  if (slips.one_in(10)) options.slice = true;
  if (slips.one_in(20)) options.start = StartKind::polyhedral;
  return options;
}

TEST(RandomMisuse, OfSystemsIsRefusedOrAnswered) {
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    System f = random_system(slips);
    for (std::size_t times = 1 + slips.below(3); times > 0; --times) spoil(f, slips);
    const bool is_broken = !broken_rules(f).empty();
    attempt(tally, [&] { make_certify_program(f); });
    const Point near(slips.below(4), slips.number());
    attempt(
        tally, [&] { reference_roots(f, {near}, 20, 1); }, is_number(near));
    const double size = slips.number();
    attempt(
        tally,
        [&] {
          unlearned_family(f, {{slips.name(), size}, {"x1", 1}});
        },
        std::isfinite(size));
    if (!is_broken && (!is_small(f) || !slips.one_in(10))) continue;
    attempt(tally, [&] { root_bounds(f, {}); });
    attempt(tally, [&] {
      for (const Solution& root : solve(f, lanes(), random_options(slips)).solutions) {
        EXPECT_TRUE(is_number(root.x));
      }
    });
  }
  EXPECT_GT(tally.refused, tally.answered);
  RecordProperty("refused", tally.refused);
}

TEST(RandomMisuse, OfNumbersAndPowersIsRefusedOrAnswered) {
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    const Polynomial x = unknown(static_cast<std::uint32_t>(slips.below(3)));
    const double a = slips.number(), b = slips.number(), c = slips.number();
    attempt(
        tally, [&] { (void)(a * x + b - x / c); }, are_numbers({a, b, c}));
    attempt(tally, [&] { (void)pow(x, static_cast<int>(slips.below(5)) - 2); });
    attempt(
        tally, [&] { (void)Coefficient(Complex(a, b)); }, are_numbers({a, b}));
    attempt(tally, [&] { (void)make_system({slips.name(), slips.name()}, {x * x - 1, x}); });
  }
  EXPECT_GT(tally.refused, 0);
}

TEST(RandomMisuse, OfFamiliesIsRefusedOrAnswered) {
  const auto [x, p] = unknowns<2>();
  const System f = make_system({"x", "p"}, {x * x - p});
  const Family learned = learn(unlearned_family(f, {{"p", 1}}), lanes());
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    Family family = learned;
    const std::size_t slip = slips.below(6);
    const double number = slips.number();
    if (slip == 0) family.generic.assign(slips.below(3), Complex(number));
    if (slip == 1) family.roots.emplace_back(slips.below(3), Complex(1, number));
    if (slip == 2) family.sizes.assign(slips.below(3), number);
    const bool is_whole = is_number(family.generic) && is_number(family.roots.back()) &&
                          (slip != 2 || family.sizes.empty() || std::isfinite(number));
    if (slip == 3) family.system.polynomials.clear();
    if (slip == 4) {
      spoil(family.system, slips);
      family.learning.bound.reset();  // it was proved of another system
    }
    const std::vector<Complex> members(slips.below(3), Complex(slips.number(), slips.number()));
    SolveOptions options;
    options.threads = 1;
    attempt(
        tally, [&] { solve_member_table(family, members, lanes(), options); },
        is_whole && is_number(members));
    attempt(
        tally, [&] { solve_member(family, ParameterValues(slips.below(3)), lanes(), options); },
        is_whole);
    const ParameterProblem problem{
        f, {slips.one_in(3) ? slips.name() : "p"}, {4}, {Point(slips.below(3), slips.number())}};
    attempt(
        tally, [&] { track(problem, ParameterValues(slips.below(3), 1), lanes(), 1); },
        is_number(problem.roots[0]));
  }
  EXPECT_GT(tally.refused, tally.answered / 4);
}

Mechanism base_mechanism(Slips& slips) {
  const char* files[] = {"four-bar.toml", "slider-crank.toml", "rssr.toml"};
  return read_mechanism(read_source(std::string(MOIVRE_SOURCE_DIR "/problems/mechanisms/") +
                                    files[slips.below(std::size(files))]));
}

void spoil_joint(Joint& joint, Slips& slips) {
  switch (slips.below(9)) {
    case 0:
      joint.at[slips.below(2)].body = slips.index();
      break;
    case 1:
      joint.at[slips.below(2)].point = slips.index();
      break;
    case 2:
      joint.type = all_joint_types()[slips.below(all_joint_types().size())].type;
      break;
    case 3:
      joint.axis[slips.below(2)] = {slips.number(), slips.number(), slips.number()};
      break;
    case 4:
      joint.name = slips.name();
      break;
    case 5:
      joint.length = joint.radius = joint.pitch = slips.number();
      break;
    case 6:
      joint.gear.carrier = slips.index();
      joint.gear.teeth[0] = static_cast<int>(slips.below(3)) - 1;
      break;
    case 7:
      joint.limits = Limits{slips.number(), slips.number()};
      break;
    default:
      joint.turn_rad = slips.number();
  }
}

void spoil_driver(Driver& driver, Slips& slips) {
  switch (slips.below(7)) {
    case 0:
      driver.kind = static_cast<DriverKind>(slips.below(6));
      break;
    case 1:
      driver.bodies[slips.below(2)] = slips.index();
      break;
    case 2:
      driver.joint = slips.index();
      break;
    case 3:
      driver.point = {slips.index(), slips.index()};
      break;
    case 4:
      driver.law = Parabola{slips.number(), slips.number(), 0};
      break;
    case 5:
      driver.law = Spline{{slips.number(), 1}, {slips.number()}, {}};
      break;
    default:
      driver.law = TypedLaw{{static_cast<Formula::Kind>(slips.below(17)), slips.number(),
                             slips.index(), std::vector<Formula>(slips.below(3))},
                            slips.number()};
  }
}

void spoil(Mechanism& mechanism, Slips& slips) {
  Body& body = mechanism.bodies[slips.below(mechanism.bodies.size())];
  switch (slips.below(9)) {
    case 0:
    case 1:
      return spoil_joint(mechanism.joints[slips.below(mechanism.joints.size())], slips);
    case 2:
      if (!mechanism.drivers.empty()) spoil_driver(mechanism.drivers[0], slips);
      break;
    case 3:
      if (!body.points.empty()) {
        body.points[slips.below(body.points.size())].at[static_cast<int>(slips.below(3))] =
            slips.number();
      }
      break;
    case 4:
      body.name = slips.name();
      break;
    case 5:
      mechanism.bodies.push_back({slips.name(), {}, {}});
      break;
    case 6:
      mechanism.guess[slips.name()] = slips.number();
      break;
    case 7:
      mechanism.unknowns.push_back({slips.name(), false, {}});
      break;
    default:
      body.points.clear();
  }
}

TEST(RandomMisuse, OfMechanismsIsRefusedOrAnswered) {
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    Mechanism mechanism = base_mechanism(slips);
    for (std::size_t times = 1 + slips.below(3); times > 0; --times) spoil(mechanism, slips);
    const double t = slips.one_in(4) ? slips.number() : 0;
    const Eigen::VectorXd q = slips.one_in(2) ? slips.vector() : Eigen::VectorXd::Constant(9, 0.2);
    (void)broken_rules(mechanism);
    attempt(tally, [&] { Phi(mechanism).jacobian(q, t); });
    attempt(
        tally, [&] { (void)initial_guess(mechanism, t); }, std::isfinite(t));
    attempt(
        tally,
        [&] {
          point_position(mechanism, {slips.index(), slips.index()}, q);
        },
        is_number(q));
    attempt(
        tally, [&] { (void)orientation(mechanism, slips.index(), q); }, is_number(q));
    if (!broken_form(mechanism).empty()) {
      attempt(tally, [&] { find_closures(mechanism, lanes()); });
      attempt(tally, [&] { find_motion(mechanism, lanes()); });
    } else if (broken_rules(mechanism).empty() && slips.one_in(20)) {
      ClosureOptions options;
      options.time = t;
      options.solve.threads = 1;
      attempt(
          tally,
          [&] {
            for (const Closure& one : find_closures(mechanism, lanes(), options).closures) {
              EXPECT_TRUE(is_number(one.q));
            }
          },
          std::isfinite(t));
      const double fit = slips.number();
      attempt(
          tally, [&] { mobility(Phi(mechanism), q, t, fit); },
          is_number(q) && are_numbers({t, fit}));
      attempt(tally, [&] { newton(Phi(mechanism), initial_guess(mechanism)); });
    }
  }
  EXPECT_GT(tally.refused, tally.answered);
}

TEST(RandomMisuse, OfTheBuilderIsRefusedOrAnswered) {
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    MechanismBuilder built(slips.name(), slips.one_in(3) ? Space::spatial : Space::planar);
    if (slips.one_in(2)) built.units(slips.one_in(2) ? "mm" : slips.name(), "deg");
    const double y = slips.number(), lower = slips.number(), upper = slips.number();
    const double start = slips.number(), guess = slips.number();
    const bool is_guessed = slips.one_in(3);
    built.ground({{slips.one_in(4) ? slips.name() : "A", {0, y}}, {"D", {1, 0}}});
    built.body(slips.one_in(3) ? slips.name() : "crank",
               {{"A", std::vector<double>(slips.below(4), 0.5)}, {slips.name(), {1, 0}}});
    built.joint(slips.one_in(4) ? slips.name() : "revolute",
                {slips.one_in(4) ? slips.name() : "ground.A", "crank.A"},
                {{slips.one_in(3) ? slips.name() : "limits", {lower, upper}}});
    built.driver(slips.one_in(4) ? slips.name() : "angle", "crank", {{"start", start}});
    if (is_guessed) built.guess(slips.name(), guess);
    if (slips.one_in(6)) built.equation(slips.name(), slips.name());
    attempt(
        tally, [&] { (void)built.build(); },
        are_numbers({y, lower, upper, start}) && (!is_guessed || std::isfinite(guess)));
  }
  EXPECT_GT(tally.refused, tally.answered);
}

void spoil(Arm& arm, Slips& slips) {
  ArmJoint& joint = arm.joints[slips.below(arm.joints.size())];
  switch (slips.below(6)) {
    case 0:
      joint.axis = {slips.number(), slips.number(), slips.number()};
      break;
    case 1:
      joint.before.matrix()(static_cast<int>(slips.below(4)), static_cast<int>(slips.below(4))) =
          slips.number();
      break;
    case 2:
      joint.limits = Limits{slips.number(), slips.number()};
      break;
    case 3:
      joint.exact_before = {};
      break;
    case 4:
      joint.exact_length = slips.number();
      break;
    default:
      arm.joints.resize(slips.below(3));
  }
}

TEST(RandomMisuse, OfArmsIsRefusedOrAnswered) {
  const Robot robot = read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf"));
  const Arm whole = make_arm(robot, {});
  const Eigen::Isometry3d reached = forward_kinematics(whole, Eigen::VectorXd::Constant(6, 0.3));
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    const Eigen::VectorXd values = slips.vector();
    const bool has_numbers = is_number(values);
    attempt(
        tally, [&] { forward_kinematics(whole, values); }, has_numbers);
    attempt(
        tally, [&] { posture_of(whole, values); }, has_numbers);
    attempt(
        tally, [&] { all_turns(whole, values); }, has_numbers);
    attempt(
        tally, [&] { nearest_turns(whole, values, Eigen::VectorXd::Zero(6)); }, has_numbers);
    attempt(
        tally,
        [&] {
          Eigen::VectorXd placed = values;
          place_in_limits(whole, placed);
        },
        has_numbers);
    attempt(tally, [&] { poses_of(std::vector<double>(slips.below(40))); });
    Arm arm = whole;
    if (slips.one_in(2)) spoil(arm, slips);
    Eigen::Isometry3d pose = reached;
    pose.matrix()(static_cast<int>(slips.below(4)), static_cast<int>(slips.below(4))) =
        slips.number();
    const bool is_pose = pose.matrix().allFinite();
    const bool is_broken = !broken_rules(arm).empty();
    if (!is_broken && !slips.one_in(5)) continue;
    attempt(
        tally,
        [&] {
          const ArmResult result = find_arm_closures(arm, pose, lanes(), random_options(slips));
          for (const ArmClosure& one : result.closures) EXPECT_TRUE(is_number(one.in_limits));
        },
        is_pose);
    attempt(
        tally,
        [&] {
          tabulate_arm_closures(arm, {reached, pose}, lanes());
        },
        is_pose);
  }
  EXPECT_GT(tally.refused, tally.answered / 4);
}

TEST(RandomMisuse, OfRobotsIsRefusedOrAnswered) {
  const Robot whole = read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf"));
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    Robot robot = whole;
    RobotJoint& joint = robot.joints[slips.below(robot.joints.size())];
    RobotLink& link = robot.links[slips.below(robot.links.size())];
    const std::size_t slip = slips.below(9);
    if (slip == 0) joint.parent = slips.index();
    if (slip == 1) joint.child = slips.index();
    if (slip == 2) joint.axis = {0, 0, 0};
    const double a = slips.number(), b = slips.number(), held = slips.number();
    if (slip == 3) joint.limits = Limits{a, b};
    if (slip == 4) joint.mimic = Mimic{slips.index(), a, b};
    const bool has_numbers = (slip != 3 && slip != 4) || are_numbers({a, b});
    if (slip == 5) link.children.push_back(slips.index());
    if (slip == 6) link.joint = slips.index();
    if (slip == 7) robot.root = slips.index();
    if (slip == 8) joint.name = link.name = slips.name();
    attempt(
        tally,
        [&] {
          make_arm(robot, {slips.name(), {}, {{slips.name(), held}}});
        },
        has_numbers && std::isfinite(held));
    attempt(
        tally, [&] { make_arm(robot, {}); }, has_numbers);
    attempt(
        tally, [&] { (void)mechanism_text(robot, slips.name()); }, has_numbers);
  }
  EXPECT_GT(tally.refused, tally.answered);
}

TEST(RandomMisuse, OfOwnFunctionsIsRefusedOrAnswered) {
  Tally tally;
  for (int k = 0; k < misuses(); ++k) {
    SCOPED_TRACE(seed_of(k));
    Slips slips(seed_of(k));
    const OwnFunction f{[&](const Eigen::VectorXd&) { return slips.vector(); },
                        [&](const Eigen::VectorXd& q) -> Eigen::MatrixXd {
                          return slips.vector() * q.transpose();
                        }};
    const Eigen::VectorXd guess = slips.vector();
    attempt(
        tally, [&] { newton(slips.one_in(9) ? OwnFunction{} : f, guess); }, is_number(guess));
  }
  EXPECT_GT(tally.refused, 0);
}

}  // namespace
}  // namespace moivre::test

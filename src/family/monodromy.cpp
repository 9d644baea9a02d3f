// SPDX-License-Identifier: MIT
// A family from one pair: to a generic member, round loops, and the verdict of the trace test.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "certified_members.h"
#include "family_sentences.h"
#include "known_counts.h"
#include "loops.h"
#include "moivre/expression/counted.h"
#include "moivre/factorization/qr.h"
#include "moivre/family/learn.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/tape.h"

namespace moivre {
namespace {

constexpr std::uint64_t kPairNumber = 1'000'000'000;
// Other components are looked for among roots of size 1, 10, ..., 10^5.
constexpr int kDecades = 6;

/// All that loops and chance have found.
struct Search {
  RootSet roots;
  LoopCount count;
  int components = 1;  ///< at most: a root that loops have lost counts as one
};

/// F and its Jacobian in all its variables.
class JointSystem {
 public:
  explicit JointSystem(const System& f)
      : tape_(make_tape(f)),
        c_(complex_coefficients(tape_, f)),
        registers_(tape_.register_count()),
        value_(tape_.equations),
        entries_(tape_.jacobian.size()) {}

  void evaluate_at(const Point& z) {
    evaluate<Complex, Complex>(tape_, c_, z, registers_, value_, entries_);
    jacobian_.setZero(tape_.equations, tape_.variables);
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      jacobian_(tape_.jacobian[e].row, tape_.jacobian[e].column) = entries_[e];
    }
  }
  Eigen::Map<const Eigen::VectorXcd> value() const {
    return {value_.data(), static_cast<Eigen::Index>(value_.size())};
  }
  const Eigen::MatrixXcd& jacobian() const { return jacobian_; }

 private:
  Tape tape_;
  std::vector<Complex> c_;
  Point registers_, value_, entries_;
  Eigen::MatrixXcd jacobian_;
};

/// From z the shortest corrections, in units of `sizes`, until F(z) = 0; false where they do not
/// come to an end, or creep to one, as they do to multiple roots.
bool correct(JointSystem& f, const Eigen::VectorXd& sizes, Point& z) {
  constexpr int kMostSteps = 100;
  constexpr double kLargest = 1e6;
  constexpr double kConverged = 1e-13;
  constexpr double kNear = 1e-4;
  constexpr double kCreeping = 0.1;
  const auto units = sizes.asDiagonal();
  Eigen::Map<Eigen::VectorXcd> at(z.data(), sizes.size());
  double last = kLargest;
  for (int step = 0; step < kMostSteps; ++step) {
    f.evaluate_at(z);
    const Eigen::MatrixXcd J = f.jacobian() * units;
    const Eigen::VectorXcd dz = shortest_solution(J, -f.value());
    at += units * dz;
    const double size = at.cwiseQuotient(sizes).lpNorm<Eigen::Infinity>();
    if (!(size <= kLargest)) return false;
    const double length = dz.lpNorm<Eigen::Infinity>() / size;
    if (length <= kConverged) return true;
    if (last <= kNear && length > kCreeping * last) return false;
    last = length;
  }
  return false;
}

/// But for rounding.
bool has_vanishing_coordinate(const Point& x) {
  const double nothing = 1e-9 * std::max(1.0, max_norm(x));
  return std::any_of(x.begin(), x.end(),
                     [&](const Complex& xj) { return std::abs(xj) <= nothing; });
}

void require_pair(const Family& family, const KnownPair& pair) {
  require_unbroken(broken_rules_of_unlearned(family));
  if (!std::isfinite(max_norm(pair.x)) || !std::isfinite(max_norm(pair.p))) {
    throw InvalidInput("a pair has a number that is not finite");
  }
  if (pair.x.size() == family.unknowns() && pair.p.size() == family.parameters()) return;
  throw InvalidInput("a pair has a number for each of the " +
                     counted(family.unknowns(), "unknown") + " and " +
                     counted(family.parameters(), "parameter"));
}

/// What is known about the number of roots.
std::string standing_of(const Learning& learning, const TraceTest& test, const Search& search,
                        bool was_stopped) {
  const int strays = search.components - 1;
  if (learning.bound) return standing_by_bound_of_loops(learning.bound->kind, strays);
  if (search.count.was_cut && !test.was_made) return standing_of_cut_loops(search.count.loops);
  if (strays > 0) return standing_with_strays(strays);
  if (was_stopped) return standing_of_interrupted(search.count.loops);
  if (!test.was_made) return standing_without_trace_test(search.count.loops, test.lost);
  return standing_by_trace_test(test.holds, test.points);
}

/// Random roots of random members, small and large, belong to other components where they come to
/// roots that no loop leads to.
void look_elsewhere(const Family& family, const LoopSearch& loops, const Follower& follower,
                    Search& search) {
  for (int k = 1; k <= loops.options.other_pairs && !follower.stop; ++k) {
    const std::uint64_t seed =
        random_bits(family.seed, RandomStream::family, kPairNumber + static_cast<std::uint64_t>(k));
    const auto pair = random_pair(family, seed, std::pow(10.0, k % kDecades));
    if (!pair) continue;
    auto end = follow_roots(family.system, pair->p, family.generic, {pair->x}, follower).front();
    ++search.count.paths;
    if (!end || !search.roots.add(std::move(*end))) continue;
    ++search.components;
    search.count += go_round_loops(family.system, family.generic, loops, follower, search.roots);
  }
}

}  // namespace

std::optional<KnownPair> random_pair(const Family& family, std::uint64_t seed, double size) {
  std::vector<std::string> broken = broken_rules_of_unlearned(family);
  if (!(size > 0) || !std::isfinite(size)) {
    broken.emplace_back("the size of a random pair must be finite and above 0");
  }
  require_unbroken(broken);
  constexpr std::uint64_t kMostTrials = 64;
  constexpr double kLeastRank = 1e-8;
  const std::size_t n = family.unknowns();
  const auto rows = static_cast<Eigen::Index>(n);
  JointSystem f(family.system);
  Eigen::VectorXd sizes =
      Eigen::VectorXd::Constant(rows + static_cast<Eigen::Index>(family.parameters()), size);
  sizes.tail(static_cast<Eigen::Index>(family.parameters())) = Eigen::Map<const Eigen::VectorXd>(
      family.sizes.data(), static_cast<Eigen::Index>(family.parameters()));
  for (std::uint64_t trial = 0; trial < kMostTrials; ++trial) {
    Point z;
    for (std::size_t j = 0; j < family.system.variables.size(); ++j) {
      const std::uint64_t index = ((kPairNumber + trial) << 8) + 2 * j;
      z.push_back(sizes[static_cast<Eigen::Index>(j)] *
                  (0.5 + random_unit(seed, RandomStream::family, index)) *
                  random_phase(seed, RandomStream::family, index + 1));
    }
    if (!correct(f, sizes, z)) continue;
    f.evaluate_at(z);
    const PivotedQr<Complex> in_unknowns(f.jacobian().leftCols(rows));
    if (in_unknowns.rank(kLeastRank) < rows) continue;
    const auto parameters = z.begin() + static_cast<std::ptrdiff_t>(n);
    KnownPair pair{Point(z.begin(), parameters), Point(parameters, z.end())};
    if (!family.nonzero || !has_vanishing_coordinate(pair.x)) return pair;
  }
  return std::nullopt;
}

std::vector<std::string> validate(const MonodromyOptions& options) {
  std::vector<std::string> broken;
  if (options.threads < 1) broken.emplace_back("threads must be 1 or more");
  if (options.quiet_loops < 1) broken.emplace_back("quiet_loops must be 1 or more");
  if (options.most_loops < 1) broken.emplace_back("most_loops must be 1 or more");
  if (options.other_pairs < 0) broken.emplace_back("other_pairs must be 0 or more");
  return broken;
}

Family learn_by_monodromy(Family unlearned, const KnownPair& pair, const Tracker& tracker,
                          const MonodromyOptions& options, const std::atomic<bool>& stop) {
  require_pair(unlearned, pair);
  require_unbroken(validate(options));
  Family family = std::move(unlearned);
  family.seed = options.seed;
  family.generic = generic_member(family, options.seed);
  const Follower follower{tracker, stop, options.threads, options.observations};
  const auto first =
      follow_roots(family.system, pair.p, family.generic, {pair.x}, follower).front();
  if (!first && !stop) {
    throw InvalidInput("the pair is no regular root of a member of the family");
  }
  Search search;
  if (first) search.roots.add(*first);
  const LoopSearch loops{family.sizes, 1, options};
  search.count = go_round_loops(family.system, family.generic, loops, follower, search.roots);
  look_elsewhere(family, loops, follower, search);
  family.roots = search.roots.roots();
  Learning& learning = family.learning;
  learning.start = "monodromy";
  learning.paths = search.count.paths;
  if (options.certify) learning.certified = certified_roots(family, options.threads, stop);
  std::optional<std::uint64_t> by_algebra;
  if (learning.certified == family.roots.size() && !stop) {
    const KnownCounts known = known_counts(family, family.generic, &stop);
    learning.bound = known.met;
    by_algebra = known.by_algebra;
  }
  TraceTest test;
  if (options.test && !learning.bound && family.roots.size() <= options.most_tested) {
    test = trace_test(family, tracker, options, stop);
  }
  const bool lacks_roots = by_algebra > family.roots.size();
  learning.complete =
      learning.bound || (test.holds && search.components == 1 && !lacks_roots && !stop);
  learning.standing = lacks_roots ? standing_refuted_by_algebra(*by_algebra)
                                  : standing_of(learning, test, search, stop);
  return family;
}

}  // namespace moivre

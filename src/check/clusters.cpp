// SPDX-License-Identifier: MIT
// Is a singular root what it is said to be? Where it is known exactly, or the quotient ring tells
// all roots, exact algebra counts its multiplicity; elsewhere that is numerical, but a regular root
// in its place, or none near, is not.
#include <algorithm>
#include <cmath>
#include <optional>

#include "bench.h"
#include "moivre/algebra/local_multiplicity.h"
#include "moivre/algebra/quotient_ring.h"
#include "moivre/certify/distinct.h"
#include "moivre/certify/ring_points.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/random.h"
#include "moivre/numeric/simplest.h"
#include "moivre/polynomial/digits.h"
#include "moivre/polynomial/exclusion.h"

namespace moivre {
namespace {

// Newton's method is begun at so many points of the disc for each root that it may hold.
constexpr std::uint64_t kTriesPerRoot = 2;
constexpr std::uint64_t kMostFound = 12;
// A multiple root keeps every precision busy; two that are proved distinct differ in this one.
constexpr int kClusterBits = 4 * kFirstArbBits;
// Beyond this a disc says nothing of where a root is.
constexpr double kWidestDisc = 1e-2;
// The prime of the ring is another one than the solver's; ten seconds at most.
constexpr std::uint64_t kRingSeed = 103;
constexpr std::uint64_t kTermsOfRing = 1'000'000'000;

/// Certified roots within the entry's disc that no other entry lists: a certificate each, distinct.
std::size_t regular_roots_within(Bench& bench, Certifier& certifier, const Entry& entry,
                                 std::uint64_t multiplicity) {
  std::vector<Certificate> found;
  const std::uint64_t tries = 1 + kTriesPerRoot * std::min(multiplicity, kMostFound);
  for (std::uint64_t t = 0; t < tries; ++t) {
    Point x = entry.x;
    for (std::size_t j = 0; t > 0 && j < x.size(); ++j) {
      x[j] += entry.reach * random_phase(bench.claims.seed, RandomStream::check, t * x.size() + j);
    }
    Certificate c = certifier.certify(x);
    if (!c.holds_root()) continue;
    if (sharp_distance(certifier, c, entry.x, entry.reach).most <= entry.reach) {
      found.push_back(std::move(c));
    }
  }
  if (found.empty()) return 0;
  const std::size_t own = found.size();
  for (const Entry& other : bench.entries) {
    if (other.is_regular && other.certificate.holds_root()) found.push_back(other.certificate);
  }
  const Distinctness d = tell_apart(certifier, found);
  std::vector<std::size_t> firsts;
  for (std::size_t k = 0; k < own; ++k) {
    const bool is_listed =
        std::any_of(d.first_of.begin() + static_cast<std::ptrdiff_t>(own), d.first_of.end(),
                    [&](std::size_t first) { return first == d.first_of[k]; });
    if (!is_listed && d.first_of[k] == k) firsts.push_back(k);
  }
  return firsts.size();
}

/// All roots, each with its multiplicity; none where the ring does not tell them.
std::vector<RingPoint> points_of_ring(const System& f, const std::atomic<bool>& stop) {
  const QuotientRing ring = quotient_ring(f, {.stop = &stop, .seed = kRingSeed});
  const bool is_small = ring.verdict == QuotientRing::Verdict::finite &&
                        ring.dimension <= kMostRingPoints && coefficient_errors(f).empty();
  if (!is_small) return {};
  auto points = ring_points(f, {.most_terms = kTermsOfRing, .stop = &stop, .seed = kRingSeed});
  const bool are_known = points && are_multiplicities(*points, ring.dimension);
  return are_known ? std::move(*points) : std::vector<RingPoint>{};
}

/// Asks for the ring where it is first needed.
class RingMultiplicities {
 public:
  explicit RingMultiplicities(const Bench& bench) : bench_(bench) {}

  /// Of the one root within the entry's reach; 0 where there is none or several, or nothing is
  /// known.
  std::uint64_t at(const Entry& entry) {
    if (!points_) points_ = points_of_ring(bench_.stand_in.system, bench_.stop);
    std::uint64_t multiplicity = 0;
    for (const RingPoint& point : *points_) {
      if (!is_within(point, entry)) continue;
      if (multiplicity > 0) return 0;
      multiplicity = point.exponent;
    }
    return multiplicity;
  }

 private:
  static bool is_within(const RingPoint& point, const Entry& entry) {
    for (std::size_t j = 0; j < entry.x.size(); ++j) {
      if (!(std::abs(point.x[j].front() - entry.x[j]) <= entry.reach)) return false;
    }
    return true;
  }

  const Bench& bench_;
  std::optional<std::vector<RingPoint>> points_;
};

void judge_cluster(Bench& bench, Certifier& certifier, RingMultiplicities& multiplicities,
                   Entry& entry, const RootClaim& root, std::size_t number) {
  Verdicts& verdicts = bench.verdicts;
  const std::uint64_t m = root.multiplicity;
  if (has_no_root_within(bench.stand_in.system, entry.x, entry.reach, m)) {
    entry.is_refuted = true;
    return verdicts.refute(ClaimKind::root, "no root lies within " + rough(entry.reach), number);
  }
  LocalRing ring = exact_ring(bench.stand_in.system, entry.x, entry.reach);
  if (ring.dimension == 0 && !root.cluster) {
    if (const std::uint64_t count = multiplicities.at(entry); count > 1) {
      ring.dimension = count;
      ring.is_isolated = true;
    }
  }
  const bool is_counted = ring.is_isolated && ring.dimension > 1;
  const bool may_be_several = root.cluster && (!is_counted || ring.dimension <= m);
  if (!may_be_several && (is_counted || (!ring.is_isolated && ring.dimension > m))) {
    const bool holds = is_counted && ring.dimension == m;
    if (holds) {
      verdicts.judgement().roots.counted += m;
      ++verdicts.judgement().roots.counted_points;
    }
    return verdicts.judge(
        ClaimKind::multiplicity, holds,
        "exact algebra counts this root " + std::string(is_counted ? "" : "at least ") +
            std::to_string(ring.dimension) + " times, " + std::to_string(m) + " is claimed",
        number);
  }
  const bool is_narrow = entry.reach <= kWidestDisc * std::max(1.0, max_norm(entry.x));
  const std::size_t regular = is_narrow ? regular_roots_within(bench, certifier, entry, m) : 0;
  if (root.cluster) {
    if (regular == m && m <= kMostFound) return verdicts.hold(ClaimKind::multiplicity);
    return verdicts.leave_open(ClaimKind::multiplicity,
                               "a cluster: " + std::to_string(regular) + " of " +
                                   counted(m, "root") + " proved within " + rough(entry.reach),
                               number);
  }
  // No other entry lists them: else they would be a cluster.
  if (regular > 0) {
    return verdicts.refute(ClaimKind::multiplicity,
                           counted(regular, "root") + " of multiplicity 1 proved within " +
                               rough(entry.reach) + ", a singular one of multiplicity " +
                               std::to_string(m) + " is claimed",
                           number);
  }
  // What is not said to be a cluster is said to be proved.
  verdicts.leave_proof_open(ClaimKind::multiplicity,
                            "a singular root and its multiplicity are numerical", number);
}

}  // namespace

LocalRing exact_ring(const System& f, const Point& x, double reach) {
  const double error = reach / std::max(1.0, max_norm(x));
  const auto here = local_ring(f, simplest(x, 0));
  return here ? *here : local_ring(f, simplest(x, error)).value_or(LocalRing{});
}

void judge_clusters(Bench& bench) {
  if (bench.is_list()) return;
  CertifyOptions options;
  options.most_bits = kClusterBits;
  options.decide_reality = false;
  options.accuracy = kWidestDisc;
  Certifier certifier(make_certify_program(bench.stand_in.system), options);
  RingMultiplicities multiplicities(bench);
  for (std::size_t k = 0; k < bench.entries.size(); ++k) {
    bench.require_time();
    const RootClaim& root = bench.claims.roots[k];
    if (root.singular == false) {
      bench.verdicts.judge(ClaimKind::multiplicity, root.multiplicity == 1,
                           "a root that is not singular has multiplicity 1, not " +
                               std::to_string(root.multiplicity),
                           k + 1);
    }
    if (root.multiplicity == 0) {
      bench.verdicts.refute(ClaimKind::multiplicity, "a root has multiplicity 1 at least", k + 1);
    }
    if (!bench.entries[k].is_regular && !bench.entries[k].is_refuted) {
      judge_cluster(bench, certifier, multiplicities, bench.entries[k], root, k + 1);
    }
  }
}

}  // namespace moivre

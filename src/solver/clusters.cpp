// SPDX-License-Identifier: MIT
// Starts around each cluster, and what its paths end at.
#include "clusters.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <span>

#include "certificates.h"
#include "completeness.h"
#include "ends.h"
#include "exact_roots.h"
#include "judge.h"
#include "moivre/algebra/local_multiplicity.h"
#include "moivre/algebra/numerical_multiplicity.h"
#include "moivre/certify/distinct.h"
#include "moivre/numeric/random.h"
#include "settle.h"

namespace moivre {
namespace {

using Proofs = std::vector<std::shared_ptr<const Certificate>>;

// Of a true multiple root each bit takes a step or more, and each step what a certificate does: no
// more bits than one step of precisions beyond double. The certifier takes more where it sees a
// simple root.
constexpr int kBits = 128;
// Newton's method goes so many times the cluster's radius at most.
constexpr double kWay = 4;
// Starts around a cluster that is shown to be none, beside two a root.
constexpr std::size_t kMostStarts = 32;

// Two pairs of opposite ones: of simple roots Newton's method comes to one.
constexpr std::size_t kStartsInVain = 4;
// In vain they take so much longer that so many clusters go first.
constexpr int kMoreBits[] = {512, kMostArbBits};
constexpr std::size_t kFirstClusters = 2;

/// x + r turn d, r the cluster's radius.
Point beside(const Root& end, const Point& d, Complex turn) {
  const double radius = end.tolerance * std::max(1.0, max_norm(end.point.x));
  Point x = end.point.x;
  for (std::size_t j = 0; j < x.size(); ++j) x[j] += product(radius * turn, d[j]);
  return x;
}

/// Where F changes least. At the cluster itself J may be singular, beside it never is.
Point softest_direction(const Setting& setting, const Root& end) {
  Point d;
  for (std::size_t j = 0; j < end.point.x.size(); ++j) {
    d.push_back(random_phase(setting.options.seed, RandomStream::cluster, j));
  }
  return Refiner(setting.refiner_program).softest(beside(end, d, 1), d);
}

/// Different roots proved beside the end that no other path holds; no more are looked for than
/// there are paths. How well it is known does not matter: a root that no path holds is one that
/// these have missed.
Proofs roots_beside(const Run& run, const Root& end, std::size_t paths, int bits) {
  const Setting& setting = run.setting;
  const Point d = softest_direction(setting, end);
  Prover prover(setting.certify_program, kWay * end.tolerance, kBits);
  const std::size_t starts = std::min(2 * paths, kMostStarts);
  Proofs found;
  for (std::size_t k = 0; k < starts && found.size() < paths && !setting.stop; ++k) {
    if (k == kStartsInVain && found.empty()) break;
    const double turn =
        static_cast<double>(k / 2 + k % 2 * (starts / 2)) / static_cast<double>(starts);
    const Point x = beside(end, d, std::polar(1.0, 2 * std::numbers::pi * turn));
    auto proof = bits > kBits ? prover.prove_slowly(x, bits) : prover.prove(x);
    if (!proof || is_held(run, *proof)) continue;
    found.push_back(std::move(proof));
    if (proved_roots(setting, found) < found.size()) found.pop_back();
  }
  return found;
}

/// What is known of a cluster: different roots that are proved beside it, or that it is none, or
/// nothing.
struct Finding {
  Proofs roots;
  bool is_refuted = false;
  bool is_on_curve = false;
};

/// Of the first of the fractions near the end that are a root, unless that is a simple one, another
/// one beside it. nullopt: none is, or nothing can be said.
std::optional<LocalRing> exact_ring(const System& f, const Root& end) {
  for (const auto& candidate : fractions_near(end.point.x, end.tolerance)) {
    const auto ring = local_ring(f, candidate);
    if (ring && ring->dimension > 1) return ring;
  }
  return std::nullopt;
}

/// The roots that the end may be have a local ring of as many dimensions as paths end there, and it
/// does not grow; or nothing can be said.
bool is_shown(const System& f, const Root& end, std::size_t paths) {
  const double error = end.point.accuracy * std::max(1.0, max_norm(end.point.x));
  const auto ring = local_ring_near(f, end.point.x, error);
  if (!ring) return true;
  return ring->is_isolated ? ring->dimension == paths : ring->dimension <= paths;
}

Finding look_into(const Run& run, const Root& end, std::size_t paths) {
  const auto ring = exact_ring(run.setting.f, end);
  if (ring && ring->is_isolated && ring->dimension == paths) return {};
  Finding finding;
  const bool is_refuted = ring && (ring->is_isolated || ring->dimension > paths);
  finding.is_on_curve = is_refuted && ring->grows_steadily;
  if (!finding.is_on_curve) finding.roots = roots_beside(run, end, paths, kBits);
  finding.is_refuted =
      is_refuted || !finding.roots.empty() || (!ring && !is_shown(run.setting.f, end, paths));
  return finding;
}

/// Groups of ends at which no simple root was found, that are isolated, and that exact algebra has
/// not counted.
PathGroups clusters_of(const Run& run) {
  PathGroups clusters;
  for (const auto& [group, ground] : judge(run).roots) {
    if (ground == Ground::whole_cycles) clusters.add(group);
  }
  return clusters;
}

/// One for each cluster, on all threads. Throws Interrupted.
template <class Find>
std::vector<Finding> findings_of(const Run& run, const PathGroups& clusters, Find find) {
  std::vector<Finding> findings(clusters.size());
  for_each_parallel(clusters.size(), run.setting.threads, [&](std::size_t k) {
    run.require_time();
    findings[k] = find(run.table.roots().at(clusters[k].front()), clusters[k].size());
  });
  run.require_time();  // what a stop cut short is no finding
  return findings;
}

/// False where it stays what it was.
bool conclude(Run& run, Refiner& refiner, PathGroups::Group cluster, const Finding& finding) {
  if (!finding.is_refuted) return false;
  const Proofs& proofs = finding.roots;
  // What two clusters came to, one of them has missed.
  const bool are_new = std::none_of(proofs.begin(), proofs.end(),
                                    [&](const auto& proof) { return is_held(run, *proof); });
  const bool are_all = are_new && proofs.size() == cluster.size();
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    if (finding.is_on_curve) {
      run.table.tell_curve(cluster[i]);
    } else if (are_all) {
      run.table.enter_root(cluster[i], proved_root(refiner, proofs[i]));
    } else {
      run.table.refute(cluster[i]);
    }
  }
  return true;
}

/// Paths that come to a simple root after another one: in double they may have another one beside
/// it. And places at which exact algebra does not count as many roots as paths end there.
PathGroups uncounted_clusters(Run& run) {
  PathGroups clusters;
  for (const auto& [path, question] : judge(run).open) {
    const auto root = run.table.roots().find(path);
    const bool has_root = root != run.table.roots().end() && root->second.certificate;
    if (question == Question::jumped && has_root) clusters.add(path);
  }
  clusters.add(clusters_at(run));
  if (clusters.empty()) return clusters;
  const std::vector<ExactRoot> exact = exact_roots(run);
  PathGroups uncounted;
  for (const PathGroups::Group cluster : clusters) {
    const Root& end = run.table.roots().at(cluster.front());
    if (!is_counted_by(exact, end, cluster.size())) uncounted.add(cluster);
  }
  return uncounted;
}

}  // namespace

void part_clusters(Run& run) {
  const PathGroups clusters = clusters_of(run);
  if (clusters.empty() || are_as_counted(run)) return;
  const auto findings = findings_of(run, clusters, [&](const Root& end, std::size_t paths) {
    return look_into(run, end, paths);
  });
  Refiner refiner(run.setting.refiner_program);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    conclude(run, refiner, clusters[k], findings[k]);
  }
}

void part_clusters_in_more_bits(Run& run) {
  Refiner refiner(run.setting.refiner_program);
  for (const int bits : kMoreBits) {
    const PathGroups clusters = uncounted_clusters(run);
    std::size_t together = kFirstClusters;
    for (std::size_t first = 0; first < clusters.size(); first += together, together *= 2) {
      PathGroups ahead;
      const std::size_t behind = std::min(first + together, clusters.size());
      for (std::size_t k = first; k < behind; ++k) ahead.add(clusters[k]);
      const auto findings = findings_of(run, ahead, [&](const Root& end, std::size_t paths) {
        Finding finding{roots_beside(run, end, paths, bits)};
        finding.is_refuted = finding.roots.size() == paths;
        return finding;
      });
      bool has_helped = false;
      for (std::size_t k = 0; k < ahead.size(); ++k) {
        has_helped = conclude(run, refiner, ahead[k], findings[k]) || has_helped;
      }
      if (!has_helped) break;
    }
    if (is_settled(run)) return;
  }
}

bool is_held(const Run& run, const Certificate& proof) {
  return std::any_of(run.table.roots().begin(), run.table.roots().end(), [&](const auto& entry) {
    const auto& known = entry.second.certificate;
    return known && relation(*known, proof) != Relation::distinct;
  });
}

bool is_exactly_isolated(const System& f, const Root& end) {
  const auto ring = exact_ring(f, end);
  return ring && ring->is_isolated;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Starts around each cluster, and what its paths end at.
#include "clusters.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "certificates.h"
#include "coincidence.h"
#include "ends.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Proofs = std::vector<std::shared_ptr<const Certificate>>;

// Newton's method goes so many times the cluster's radius at most.
constexpr double kWay = 4;
// Starts around a cluster that is shown to be none, beside two a root.
constexpr std::size_t kMostStarts = 32;

/// The k-th of `count` points around the end, in one random direction.
Point beside(const Root& end, std::uint64_t seed, std::size_t k, std::size_t count) {
  const double turn = static_cast<double>(k) / static_cast<double>(count);
  const Complex step =
      std::polar(end.tolerance * std::max(1.0, max_norm(end.point.x)), 2 * std::numbers::pi * turn);
  Point x = end.point.x;
  for (std::size_t j = 0; j < x.size(); ++j) {
    x[j] += product(step, random_phase(seed, RandomStream::cluster, j));
  }
  return x;
}

class Cluster {
 public:
  Cluster(const Setting& setting, const Root& end, std::size_t paths)
      : setting_(setting),
        end_(end),
        paths_(paths),
        prover_(setting.certify_program, kWay * end.tolerance) {}

  /// The different roots that are proved within it; no more are looked for than there are paths.
  Proofs roots() {
    try_start(0, 2);
    try_start(1, 2);
    if (found_.empty()) return found_;
    const std::size_t starts = std::min(2 * paths_, kMostStarts);
    for (std::size_t k = 0; k < starts && found_.size() < paths_; ++k) try_start(k, starts);
    return found_;
  }

 private:
  void try_start(std::size_t k, std::size_t count) {
    if (setting_.stop) return;
    auto proof = prover_.prove(beside(end_, setting_.options.seed, k, count));
    if (!proof || relative_distance(end_.point.x, proof->midpoint) > end_.tolerance) return;
    found_.push_back(std::move(proof));
    if (proved_roots(setting_, found_) < found_.size()) found_.pop_back();
  }

  const Setting& setting_;
  const Root& end_;
  std::size_t paths_;
  Prover prover_;
  Proofs found_;
};

/// Groups of ends at which no simple root was found, and that are isolated.
std::vector<std::vector<std::uint64_t>> clusters_of(const Run& run) {
  std::vector<std::vector<std::uint64_t>> clusters;
  for (auto& group : groups_of(run)) {
    const bool is_cluster = std::none_of(group.begin(), group.end(), [&](std::uint64_t path) {
      return run.ledger.roots().at(path).point.simple;
    });
    if (!is_cluster || is_on_set(run, run.ledger.roots().at(group.front()))) continue;
    clusters.push_back(std::move(group));
  }
  return clusters;
}

void enter(Run& run, Refiner& refiner, std::uint64_t path,
           const std::shared_ptr<const Certificate>& proof) {
  Root root;
  root.point = refiner.take(*proof, std::numeric_limits<double>::infinity());
  root.tolerance = simple_tolerance(root.point);
  root.certificate = proof;
  run.ledger.enter_root(path, std::move(root));
}

}  // namespace

void part_clusters(Run& run) {
  const Setting& setting = run.setting;
  if (!setting.certify_program || run.interrupted) return;
  const auto clusters = clusters_of(run);
  std::vector<Proofs> proofs(clusters.size());
  for_each_parallel(clusters.size(), setting.threads, [&](std::size_t k) {
    const Root& end = run.ledger.roots().at(clusters[k].front());
    proofs[k] = Cluster(setting, end, clusters[k].size()).roots();
  });
  if (setting.stop) run.interrupted = true;
  if (run.interrupted) return;
  Refiner refiner(setting.refiner_program);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (proofs[k].empty()) continue;
    const bool are_all = proofs[k].size() == clusters[k].size();
    for (std::size_t i = 0; i < clusters[k].size(); ++i) {
      const std::uint64_t path = clusters[k][i];
      run.ledger.strike(path);
      if (are_all) {
        enter(run, refiner, path, proofs[k][i]);
      } else {
        run.ledger.enter_failure({path, Failure::precision, 1});
      }
    }
  }
}

}  // namespace moivre

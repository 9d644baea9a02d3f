// SPDX-License-Identifier: MIT
// Certificates of ends, and groups of ends parted by them.
#include "certificates.h"

#include <algorithm>

#include "moivre/certify/distinct.h"

namespace moivre {
namespace {

CertifyOptions certify_options(double farthest = kFarthestRoot, int most_bits = kMostProofBits) {
  CertifyOptions options;
  options.accuracy = farthest;
  options.most_bits = most_bits;
  return options;
}

/// Those of the group that are proved to be different: simple roots by their certificates, multiple
/// ones that are known exactly by their places. Ends of which neither is known stay with the first.
std::vector<std::vector<std::uint64_t>> parted(const Run& run, Certifier& certifier,
                                               PathGroups::Group group) {
  std::vector<std::uint64_t> proved;
  std::vector<std::uint64_t> others;
  std::vector<Certificate> certificates;
  std::vector<std::vector<std::uint64_t>> parts;
  for (const std::uint64_t path : group) {
    const Root& root = run.table.roots().at(path);
    if (root.is_exact) {
      const auto same = std::find_if(parts.begin(), parts.end(), [&](const auto& part) {
        return run.table.roots().at(part.front()).point.x.point() == root.point.x.point();
      });
      (same == parts.end() ? parts.emplace_back() : *same).push_back(path);
      continue;
    }
    (root.certificate ? proved : others).push_back(path);
    if (root.certificate) certificates.push_back(*root.certificate);
  }
  if (proved.size() + parts.size() < 2) return {{group.begin(), group.end()}};
  const Distinctness told = tell_apart(certifier, certificates, run.setting.options.seed);
  const bool are_told = told.doubtful.empty();
  std::map<std::size_t, std::vector<std::uint64_t>> by_root;
  for (std::size_t k = 0; k < proved.size(); ++k) {
    by_root[are_told ? told.first_of[k] : 0].push_back(proved[k]);
  }
  for (auto& [first, part] : by_root) parts.push_back(std::move(part));
  parts.front().insert(parts.front().end(), others.begin(), others.end());
  std::sort(parts.front().begin(), parts.front().end());
  return parts;
}

/// As PathTable::groups(), but one path alone ends at a simple root.
PathGroups groups_beside_sets(const Run& run) {
  const auto& roots = run.table.roots();
  const auto is_simple = [&](std::uint64_t path) { return roots.at(path).point.simple; };
  const PathGroups together = run.table.groups();
  PathGroups groups;
  PathGroups sets;
  groups.reserve(together.size(), together.path_count());
  for (const PathGroups::Group group : together) {
    if (group.size() == 1 || std::none_of(group.begin(), group.end(), is_simple)) {
      groups.add(group);
      continue;
    }
    std::vector<std::uint64_t> beside(group.begin(), group.end());
    const auto on_set = std::stable_partition(beside.begin(), beside.end(), [&](auto path) {
      return is_simple(path) || !is_on_set(run, roots.at(path));
    });
    groups.add({beside.begin(), on_set});
    if (on_set != beside.end()) sets.add({on_set, beside.end()});
  }
  groups.add(sets);
  return groups;
}

}  // namespace

Prover::Prover(std::shared_ptr<const CertifyProgram> program, double farthest, int most_bits)
    : certifier_(program, certify_options(farthest, most_bits)),
      double_certifier_(program, certify_options(farthest, kDoubleBits)) {}

std::shared_ptr<const Certificate> Prover::prove(const Point& x) {
  auto certificate = std::make_shared<Certificate>();
  certifier_.certify(x, *certificate);
  if (certificate->verdict != Verdict::certified) return nullptr;
  return certificate;
}

std::shared_ptr<const Certificate> Prover::prove_in_double(const Point& x) {
  auto certificate = std::make_shared<Certificate>();
  double_certifier_.certify(x, *certificate);
  const bool is_settled =
      certificate->verdict == Verdict::certified && certificate->reality != Reality::unknown;
  return is_settled ? certificate : nullptr;
}

std::shared_ptr<const Certificate> Prover::prove_slowly(const Point& x, int bits) {
  auto certificate = std::make_shared<Certificate>(certifier_.certify_near(x, {}, bits));
  if (certificate->verdict != Verdict::certified) return nullptr;
  return certificate;
}

std::shared_ptr<const Certificate> Prover::sharpened(const Certificate& proof, int bits) {
  auto finer = std::make_shared<Certificate>(proof);
  return certifier_.sharpen(*finer, bits) ? finer : nullptr;
}

PathGroups groups_of(const Run& run) {
  PathGroups groups = groups_beside_sets(run);
  if (groups.size() == groups.path_count()) return groups;
  Certifier certifier(run.setting.certify_program, certify_options());
  PathGroups result;
  for (const PathGroups::Group group : groups) {
    if (group.size() == 1) {
      result.add(group);
      continue;
    }
    run.require_time();
    for (const auto& part : parted(run, certifier, group)) result.add(part);
  }
  return result;
}

namespace {

/// Copies are made only where some have to be sharpened.
std::uint64_t different_roots(const Setting& setting,
                              const std::vector<const Certificate*>& proofs) {
  const Distinctness told = compare(proofs, setting.options.seed);
  if (told.doubtful.empty()) return told.distinct_roots;
  std::vector<Certificate> certificates;
  certificates.reserve(proofs.size());
  for (const Certificate* proof : proofs) certificates.push_back(*proof);
  Certifier certifier(setting.certify_program, certify_options());
  return tell_apart(certifier, certificates, setting.options.seed).distinct_roots;
}

}  // namespace

std::uint64_t proved_roots(const Setting& setting,
                           const std::vector<std::shared_ptr<const Certificate>>& proofs) {
  std::vector<const Certificate*> certificates;
  certificates.reserve(proofs.size());
  for (const auto& proof : proofs) certificates.push_back(proof.get());
  return different_roots(setting, certificates);
}

std::uint64_t proved_roots(const Run& run) {
  std::vector<const Certificate*> certificates;
  certificates.reserve(run.table.roots().size());
  for (const auto& [path, root] : run.table.roots()) {
    if (root.certificate) certificates.push_back(root.certificate.get());
  }
  return different_roots(run.setting, certificates);
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// How do the roots stand to each other, and to the real numbers? Distinct, real, each with its
// conjugate.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bench.h"
#include "moivre/certify/distinct.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/near_points.h"

namespace moivre {
namespace {

bool is_proved(const Entry& entry) { return entry.certificate.holds_root() && !entry.is_refuted; }

/// Certificates of the entries, in their order; none where nothing is proved of one.
std::vector<Certificate> certificates_of(const Bench& bench) {
  std::vector<Certificate> certificates;
  for (const Entry& entry : bench.entries) {
    certificates.push_back(is_proved(entry) ? entry.certificate : Certificate{});
  }
  return certificates;
}

/// What lies where is proved by no certificate: the same point twice is the same claim twice,
/// overlapping discs are open.
void judge_unproved_pairs(Bench& bench) {
  const std::vector<Entry>& entries = bench.entries;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (is_proved(entries[k]) || entries[k].is_refuted) continue;
    bench.require_time();
    for (std::size_t other = 0; other < entries.size(); ++other) {
      if (other == k || entries[other].is_refuted) continue;
      if (other > k && !is_proved(entries[other])) continue;  // seen from the later one
      const double distance = max_distance(entries[k].x, entries[other].x);
      if (distance == 0) {
        bench.verdicts.refute(ClaimKind::distinct, "the same point as " + root_name(other + 1),
                              k + 1);
        break;
      }
      if (distance <= std::max(entries[k].reach, entries[other].reach)) {
        bench.verdicts.leave_open(ClaimKind::distinct,
                                  "not proved distinct from " + root_name(other + 1), k + 1);
        break;
      }
    }
  }
}

/// Two claims at one place may be of two roots that double does not tell apart: of the second one
/// another certificate is sought.
bool seek_others(Bench& bench, const Distinctness& d, std::vector<Certificate>& certificates) {
  bool is_found = false;
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    if (!certificates[k].holds_root() || d.first_of[k] == k) continue;
    const auto is_other = [&](const Certificate& c) {
      return std::none_of(certificates.begin(), certificates.end(), [&](const Certificate& known) {
        return known.holds_root() && relation(known, c) == Relation::same;
      });
    };
    // The nearer root may be the later claim's.
    for (const std::size_t claim : {k, d.first_of[k]}) {
      Certificate other = certificate_beside(bench, bench.entries[claim], is_other);
      if (!other.holds_root()) continue;
      certificates[claim] = std::move(other);
      is_found = true;
      break;
    }
  }
  return is_found;
}

Distinctness judge_distinct(Bench& bench) {
  std::vector<Certificate> certificates = certificates_of(bench);
  Distinctness d = tell_apart(bench.certifier, certificates);
  if (seek_others(bench, d, certificates)) d = tell_apart(bench.certifier, certificates);
  std::map<std::size_t, std::size_t> doubtful;
  for (const IndexPair& pair : d.doubtful) doubtful.emplace(pair.second, pair.first);
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    if (!certificates[k].holds_root()) continue;
    bench.entries[k].certificate = certificates[k];
    const auto doubt = doubtful.find(k);
    if (d.first_of[k] != k) {
      bench.verdicts.refute(ClaimKind::distinct, "the same root as " + root_name(d.first_of[k] + 1),
                            k + 1);
    } else if (doubt != doubtful.end()) {
      bench.verdicts.leave_open(ClaimKind::distinct,
                                "not proved distinct from " + root_name(doubt->second + 1), k + 1);
    } else {
      bench.verdicts.hold(ClaimKind::distinct);
    }
  }
  judge_unproved_pairs(bench);
  return d;
}

/// By the numbers alone: imaginary parts relative to the stated accuracy.
void judge_real_by_numbers(Bench& bench, const Entry& entry, bool real, std::size_t number) {
  double largest = 0;
  for (const Complex& xj : bench.claims.roots[number - 1].x) {
    largest = std::max(largest, std::abs(xj.imag()));
  }
  if (real && largest > entry.reach) {
    return bench.verdicts.refute(
        ClaimKind::real, "called real, with an imaginary part of " + rough(largest), number);
  }
  if (!real && largest == 0) {
    return bench.verdicts.refute(ClaimKind::real, "called not real, with no imaginary part",
                                 number);
  }
  bench.verdicts.leave_open(ClaimKind::real, "no certificate tells whether it is real", number);
}

void judge_real(Bench& bench, const Entry& entry, std::size_t number) {
  const RootClaim& root = bench.claims.roots[number - 1];
  if (!root.real || entry.is_refuted) return;
  const bool real = *root.real;
  const Reality proved = is_proved(entry) ? entry.certificate.reality : Reality::unknown;
  if (proved == Reality::unknown) return judge_real_by_numbers(bench, entry, real, number);
  bench.verdicts.judge(
      ClaimKind::real, real == (proved == Reality::real),
      real ? "called real, and proved not to be" : "called not real, and proved to be real",
      number);
}

Certificate conjugate(Certificate c) {
  for (Complex& xj : c.midpoint) xj = std::conj(xj);
  for (Point& part : c.finer) {
    for (Complex& xj : part) xj = std::conj(xj);
  }
  return c;
}

bool has_near(const std::vector<const Entry*>& entries, const Certificate& c) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry* entry) {
    return max_distance(entry->x, c.midpoint) <= entry->reach + c.radius(0);
  });
}

/// The conjugate of a root of a real system is a root of the same multiplicity.
void judge_conjugates(Bench& bench) {
  const bool claims_all = bench.is_list() || bench.claims.complete;
  if (!claims_all || !bench.stand_in.proves_roots || !is_real(bench.stand_in.system)) return;
  std::vector<Certificate> all = certificates_of(bench);
  std::vector<std::size_t> origin;
  const std::size_t listed = all.size();
  for (std::size_t k = 0; k < listed; ++k) {
    if (all[k].holds_root() && all[k].reality == Reality::not_real) {
      origin.push_back(k);
      all.push_back(conjugate(all[k]));
    }
  }
  const Distinctness d = compare(all);
  std::vector<bool> met(all.size(), false);
  const auto meet = [&](const std::vector<IndexPair>& pairs) {
    for (const IndexPair& pair : pairs) {
      if (pair.first < listed) met[pair.second] = true;
    }
  };
  meet(d.same);
  meet(d.doubtful);
  std::vector<const Entry*> unproved;
  for (const Entry& entry : bench.entries) {
    if (!is_proved(entry)) unproved.push_back(&entry);
  }
  for (std::size_t k = 0; k < origin.size(); ++k) {
    const bool is_listed = met[listed + k] || has_near(unproved, all[listed + k]);
    bench.verdicts.judge(ClaimKind::complete, is_listed,
                         "the conjugate is a root as well, and is missing", origin[k] + 1);
  }
}

void judge_counts(Bench& bench) {
  const CountClaim& counts = bench.claims.counts;
  const std::vector<RootClaim>& roots = bench.claims.roots;
  if (counts.complex) {
    bench.verdicts.judge(
        ClaimKind::complete, *counts.complex == roots.size(),
        counted(*counts.complex, "root") + " counted, " + std::to_string(roots.size()) + " listed");
  }
  if (counts.real) {
    const auto real = std::count_if(roots.begin(), roots.end(),
                                    [](const RootClaim& root) { return root.real == true; });
    bench.verdicts.judge(ClaimKind::real, *counts.real == static_cast<std::uint64_t>(real),
                         std::to_string(*counts.real) + " counted as real, " +
                             std::to_string(real) + " listed as real");
  }
}

}  // namespace

void judge_relations(Bench& bench) {
  const Distinctness d = judge_distinct(bench);
  RootTally& tally = bench.verdicts.judgement().roots;
  tally.listed = bench.entries.size();
  tally.certified = d.holding;
  tally.distinct = d.distinct_roots;
  for (std::size_t k = 0; k < bench.entries.size(); ++k) {
    const Entry& entry = bench.entries[k];
    judge_real(bench, entry, k + 1);
    tally.not_roots += entry.is_refuted ? 1 : 0;
    const bool is_said = entry.is_regular && bench.claims.roots[k].certified == true;
    tally.unproved += is_said && !is_proved(entry) && !entry.is_refuted ? 1 : 0;
    if (!is_proved(entry)) continue;
    tally.doubled += d.first_of[k] != k ? 1 : 0;
    if (d.first_of[k] != k) continue;
    tally.real += entry.certificate.reality == Reality::real ? 1 : 0;
    tally.not_real += entry.certificate.reality == Reality::not_real ? 1 : 0;
  }
  judge_conjugates(bench);
  judge_counts(bench);
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// Certificates for the roots of members, each on the exact system of its own.
#include "certified_members.h"

#include <algorithm>

#include "moivre/certify/certifier.h"
#include "moivre/certify/distinct.h"
#include "moivre/numeric/threads.h"

namespace moivre {
namespace {

void take(const Certificate& certificate, MemberRoot& root) {
  root.certified = certificate.verdict == Verdict::certified;
  if (!*root.certified) return;
  root.x = certificate.midpoint;
  root.accuracy = certificate.sizes.largest_error() / std::max(1.0, max_norm(root.x));
  if (certificate.reality != Reality::unknown) root.real = certificate.reality == Reality::real;
  if (root.real) {
    for (Complex& xj : root.x) xj.imag(0);
  }
}

void certify_member(const Family& family, const Point& p, MemberRoots& member) {
  Certifier certifier(make_certify_program(member_system(family, exact_values(p))));
  std::vector<Certificate> certificates;
  for (MemberRoot& root : member.roots) {
    certificates.push_back(certifier.certify(root.x));
    take(certificates.back(), root);
    member.complete = member.complete && *root.certified;
  }
  const Distinctness told = compare(certificates, family.seed);
  member.complete = member.complete && told.distinct_roots == member.roots.size();
}

}  // namespace

void certify_members(const Family& family, std::span<const Point> members, int threads,
                     const std::atomic<bool>& stop, std::vector<MemberRoots>& results) {
  std::atomic<std::size_t> next{0};
  on_threads(threads, [&] {
    for (std::size_t k = next++; k < results.size() && !stop; k = next++) {
      if (results[k].complete) certify_member(family, members[k], results[k]);
    }
  });
}

std::size_t certified_roots(const Family& family, int threads, const std::atomic<bool>& stop) {
  const System member = member_system(family, exact_values(family.generic));
  return compare(certify(member, family.roots, {}, threads, stop), family.seed).distinct_roots;
}

}  // namespace moivre

// SPDX-License-Identifier: MIT
// What do the parts of the judgement share? The system, the claims, certificates of the roots, and
// the notes.
#pragma once

#include <atomic>
#include <functional>

#include "moivre/algebra/local_multiplicity.h"
#include "moivre/certify/certifier.h"
#include "moivre/check/claims.h"
#include "stand_in.h"
#include "verdicts.h"

namespace moivre {

/// Ends a judgement; what was noted stands.
struct JudgementEnds {};

/// What is known of an entry of the result.
struct Entry {
  Point x;                  ///< as judged: on the patches, where there are any
  double reach = 0;         ///< a root is claimed within this of x, in every coordinate
  bool is_regular = true;   ///< as claimed
  bool is_refuted = false;  ///< no root is there
  bool is_farther = false;  ///< the root that is proved may be beyond reach
  Certificate certificate;  ///< undecided where none was found or looked for
};

struct Bench {
  const System& f;
  const Claims& claims;
  const StandIn& stand_in;
  Certifier& certifier;
  std::vector<Entry> entries;
  Verdicts& verdicts;
  const std::atomic<bool>& stop;

  /// Throws JudgementEnds where the judgement is to end.
  void require_time() const {
    if (stop.load(std::memory_order_relaxed)) throw JudgementEnds();
  }
  bool is_list() const { return claims.form == ClaimForm::solution_list; }
};

/// System, reduced system, start and sums (src/check/books.cpp). False: the unknowns are not those
/// of the system.
bool judge_system(const System& f, const Claims& claims, Verdicts& verdicts);
void judge_start(const System& f, const StandIn& stand_in, const Claims& claims, Verdicts& verdicts,
                 const std::atomic<bool>& stop);
void judge_paths(const Claims& claims, Verdicts& verdicts);

/// Coordinate planes on which every equation is zero (src/check/planes.cpp).
void judge_planes(const System& f, const Claims& claims, Verdicts& verdicts);

/// Existence and accuracy of each root (src/check/existence.cpp); fills the entries.
void judge_existence(Bench& bench);
/// Of a root that the entry may mean, found from points beside it; undecided where none is found
/// that is_wanted (src/check/existence.cpp).
Certificate certificate_beside(Bench& bench, const Entry& entry,
                               const std::function<bool(const Certificate&)>& is_wanted);
/// Multiplicities: of entries that are claimed to be singular (src/check/clusters.cpp).
void judge_clusters(Bench& bench);
/// Of the point as it is, or of the simplest fractions within `reach`; of dimension 0: neither is a
/// root, or nothing can be said (src/check/clusters.cpp).
LocalRing exact_ring(const System& f, const Point& x, double reach);
/// Residual and condition (src/check/figures.cpp).
void judge_figures(const Bench& bench);
/// The conditions of the file at each root (src/check/conditions.cpp).
void judge_conditions(const Bench& bench);
/// The bound that is said to be met (src/check/bound_claim.cpp); behind the bounds that were found.
void judge_bound(const Claims& claims, const StandIn& stand_in, Verdicts& verdicts,
                 const std::atomic<bool>& stop);
/// Digits beyond double (src/check/digits.cpp).
void judge_digits(Bench& bench);
/// Of the root that Newton's method finds from these digits; undecided where there are none.
Certificate certificate_at_digits(const Bench& bench, const RootClaim& root);
/// Distinct, real, conjugates (src/check/relations.cpp); counts the roots.
void judge_relations(Bench& bench);

/// Between which bounds |x* - x|_inf lies, x* the root of the certificate.
struct DistanceBounds {
  double least = 0, most = 0;
};
DistanceBounds distance(const Certificate& certificate, const Point& x);
/// As distance(), with the certificate sharpened until it is clear whether it is beyond `reach`.
DistanceBounds sharp_distance(Certifier& certifier, Certificate& certificate, const Point& x,
                              double reach);

}  // namespace moivre

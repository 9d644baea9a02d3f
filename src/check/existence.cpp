// SPDX-License-Identifier: MIT
// Is there a regular root, and as near as is stated? Certificates, and exact Taylor sums where
// there is none. A claim is false where that is proved.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench.h"
#include "moivre/numeric/random.h"
#include "moivre/numeric/threads.h"
#include "moivre/polynomial/exclusion.h"

namespace moivre {
namespace {

// A list of PHCpack states no accuracy: it takes points for solutions by tolerances of 1e-8.
constexpr double kListTolerance = 1e-8;
// Its err is the size of the last correction; the root is hardly farther away than some of these.
constexpr double kListCorrections = 10;
// Where a result knows no accuracy. Certificates look no farther either.
constexpr double kUnknownAccuracy = 1e-6;
// Another chart and its rounding change distances by no more than this, for roots that are
// normalized.
constexpr double kChart = 1e3;
constexpr double kChartRounding = 1e-13;
// Bounds of distances lose less than this share.
constexpr double kRoundedUp = 1 + 0x1p-40;
constexpr double kRoundedDown = 1 - 0x1p-40;
// Newton's method is begun at so many points, as far from x as it may be known to double.
constexpr std::uint64_t kTriesBeside = 16;
constexpr double kNeighbours = 0x1p-50;

/// max(1, |x|_inf), also where the square of a coordinate overflows.
double scale_of(const Point& x) {
  double scale = 1;
  for (const Complex& xj : x) scale = std::max(scale, std::abs(xj));
  return scale;
}

double reach_of(const Bench& bench, const RootClaim& root, const Point& x) {
  if (bench.is_list()) {
    return scale_of(x) * std::max(kListTolerance, kListCorrections * root.accuracy.value_or(0));
  }
  double accuracy = root.accuracy.value_or(kUnknownAccuracy);
  if (bench.stand_in.has_patches()) accuracy = std::max(kChart * accuracy, kChartRounding);
  // A stated distance may be that of the root to the last digit.
  return std::max(0.0, accuracy) * scale_of(x) * kRoundedUp * kRoundedUp;
}

bool is_finite(const Point& x) {
  return std::all_of(x.begin(), x.end(), [](const Complex& xj) { return moivre::is_finite(xj); });
}

/// Exact: m_j - x_j, the finer parts of the midpoint with it.
Coefficient offset(const Certificate& c, const Point& x, std::size_t j) {
  Coefficient d{Rational(c.midpoint[j].real()) - Rational(x[j].real()),
                Rational(c.midpoint[j].imag()) - Rational(x[j].imag())};
  for (const Point& part : c.finer) {
    d.re += Rational(part[j].real());
    d.im += Rational(part[j].imag());
  }
  return d;
}

std::string no_certificate() {
  const int bits = proves_beyond_double() ? kMostArbBits : kDoubleBits;
  return "no certificate was found in " + std::to_string(bits) +
         " bits, and none that there is no root";
}

bool is_excluded(const Bench& bench, const Entry& entry, const RootClaim& root) {
  if (has_no_root_within(bench.stand_in.system, entry.x, entry.reach, root.multiplicity)) {
    return true;
  }
  // The file's own equations say more than combinations of them.
  return !bench.stand_in.proves_roots && !bench.stand_in.has_patches() &&
         has_no_root_within(bench.f, root.x, entry.reach, root.multiplicity);
}

void accept(Bench& bench, const Entry& entry, const RootClaim& root, std::size_t number) {
  Verdicts& verdicts = bench.verdicts;
  const bool has_accuracy = !bench.is_list() && root.accuracy;
  if (!bench.stand_in.proves_roots) {
    if (has_no_root_within(bench.f, root.x, entry.reach)) {
      return verdicts.refute(ClaimKind::root,
                             "an equation of the file has no zero within " + rough(entry.reach),
                             number);
    }
    return verdicts.leave_open(ClaimKind::root,
                               "more equations than unknowns: a root of random combinations of "
                               "them is proved, which need not be one of the file",
                               number);
  }
  verdicts.hold(ClaimKind::root);
  if (!has_accuracy) return;
  if (bench.stand_in.has_patches()) {
    return verdicts.leave_open(ClaimKind::accuracy, "stated in normalized coordinates", number);
  }
  verdicts.hold(ClaimKind::accuracy);
}

/// The root found is farther away than is claimed.
void judge_farther(Bench& bench, Entry& entry, const RootClaim& root, std::size_t number,
                   const DistanceBounds& d) {
  entry.is_farther = true;
  const ClaimKind claim = bench.is_list() || !root.accuracy ? ClaimKind::root : ClaimKind::accuracy;
  const std::string nearest = "the nearest one found is " + rough(d.most) + " away";
  if (!is_excluded(bench, entry, root)) {
    return bench.verdicts.leave_open(
        claim, "nothing is proved within " + rough(entry.reach) + "; " + nearest, number);
  }
  bench.verdicts.refute(claim, "no root lies within " + rough(entry.reach) + "; " + nearest,
                        number);
  entry.is_refuted = claim == ClaimKind::root;
}

/// Of roots that double does not tell apart digits say which one is claimed.
Certificate certificate_by_digits(Bench& bench, const Entry& entry, const RootClaim& root) {
  Certificate certificate = certificate_at_digits(bench, root);
  const bool is_claimed =
      certificate.holds_root() &&
      sharp_distance(bench.certifier, certificate, entry.x, entry.reach).most <= entry.reach;
  return is_claimed ? std::move(certificate) : bench.certifier.certify(entry.x);
}

/// Of a root without digits the entry has its certificate.
void judge_regular(Bench& bench, Entry& entry, const RootClaim& root, std::size_t number) {
  Verdicts& verdicts = bench.verdicts;
  if (!root.x_digits.empty()) entry.certificate = certificate_by_digits(bench, entry, root);
  if (!entry.certificate.holds_root()) {
    // Between two roots that double does not tell apart J is singular.
    entry.certificate = certificate_beside(bench, entry, [](const Certificate&) { return true; });
  }
  if (entry.certificate.holds_root()) {
    const DistanceBounds d =
        sharp_distance(bench.certifier, entry.certificate, entry.x, entry.reach);
    if (d.most <= entry.reach) return accept(bench, entry, root, number);
    return judge_farther(bench, entry, root, number, d);
  }
  if (is_excluded(bench, entry, root)) {
    entry.is_refuted = true;
    return verdicts.refute(ClaimKind::root, "no root lies within " + rough(entry.reach), number);
  }
  verdicts.leave_open(ClaimKind::root, no_certificate(), number);
}

/// Certificates of so many entries from the first one on, where one is wanted at the point itself:
/// by all threads.
void certify_next(Bench& bench, std::size_t first, std::size_t count) {
  constexpr std::size_t kOfAThread = 32;
  std::vector<std::size_t> wanted;
  std::vector<Point> points;
  for (std::size_t k = first; k < std::min(first + count, bench.entries.size()); ++k) {
    const Entry& entry = bench.entries[k];
    const bool has_digits = !bench.claims.roots[k].x_digits.empty();
    if (!entry.is_regular || has_digits || !is_finite(entry.x)) continue;
    wanted.push_back(k);
    points.push_back(entry.x);
  }
  const auto most = static_cast<std::size_t>(thread_count(0));
  const std::size_t threads = std::min(most, 1 + points.size() / kOfAThread);
  auto certificates =
      certify(bench.stand_in.system, points, {}, static_cast<int>(threads), bench.stop);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    bench.entries[wanted[i]].certificate = std::move(certificates[i]);
  }
}

Entry entry_of(const Bench& bench, const RootClaim& root) {
  Entry entry;
  entry.x = on_patches(bench.stand_in, root.x);
  entry.reach = reach_of(bench, root, entry.x);
  entry.is_regular = bench.is_list() || (!root.singular.value_or(false) && root.multiplicity == 1);
  return entry;
}

void judge_certified(Bench& bench, const Entry& entry, const RootClaim& root, std::size_t number) {
  if (root.certified != true) return;
  if (!entry.is_regular) {
    return bench.verdicts.leave_proof_open(ClaimKind::certified,
                                           "a count of roots on a ball is not made here", number);
  }
  if (entry.is_refuted) {
    return bench.verdicts.refute(ClaimKind::certified,
                                 "no root lies where one is said to be certified", number);
  }
  if (!entry.certificate.holds_root()) {
    const bool is_multiple = exact_ring(bench.stand_in.system, entry.x, entry.reach).dimension > 1;
    if (!is_multiple) {
      return bench.verdicts.leave_proof_open(ClaimKind::certified, no_certificate(), number);
    }
    return bench.verdicts.refute(ClaimKind::certified,
                                 "a multiple root, known exactly, has no certificate", number);
  }
  if (entry.is_farther) {
    return bench.verdicts.leave_proof_open(
        ClaimKind::certified, "a root is proved, not within the accuracy that is stated", number);
  }
  bench.verdicts.hold(ClaimKind::certified);
}

}  // namespace

Certificate certificate_beside(Bench& bench, const Entry& entry,
                               const std::function<bool(const Certificate&)>& is_wanted) {
  for (std::uint64_t t = 0; t < kTriesBeside; ++t) {
    Point x = entry.x;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double step = std::max(entry.reach, kNeighbours * std::abs(x[j]));
      x[j] += step * random_phase(bench.claims.seed, RandomStream::check, t * x.size() + j);
    }
    Certificate c = bench.certifier.certify(x);
    if (!c.holds_root()) continue;
    const bool is_beyond =
        sharp_distance(bench.certifier, c, entry.x, entry.reach).least > entry.reach;
    if (!is_beyond && is_wanted(c)) return c;
  }
  return {};
}

DistanceBounds distance(const Certificate& certificate, const Point& x) {
  DistanceBounds d;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Coefficient part = offset(certificate, x, j);
    const double size = std::hypot(to_double(part.re), to_double(part.im));
    d.most = std::max(d.most, (size * kRoundedUp + certificate.error(j)) * kRoundedUp);
    d.least = std::max(d.least, (size * kRoundedDown - certificate.error(j)) * kRoundedDown);
  }
  return d;
}

DistanceBounds sharp_distance(Certifier& certifier, Certificate& certificate, const Point& x,
                              double reach) {
  DistanceBounds d = distance(certificate, x);
  for (int bits = kFirstArbBits; bits <= certifier.most_bits(); bits *= 2) {
    if (d.most <= reach || d.least > reach) break;
    if (bits <= certificate.bits || !certifier.sharpen(certificate, bits)) continue;
    d = distance(certificate, x);
  }
  return d;
}

void judge_existence(Bench& bench) {
  constexpr std::size_t kTogether = 4096;
  const std::vector<RootClaim>& roots = bench.claims.roots;
  for (const RootClaim& root : roots) bench.entries.push_back(entry_of(bench, root));
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (k % kTogether == 0) certify_next(bench, k, kTogether);
    bench.require_time();
    const RootClaim& root = roots[k];
    Entry& entry = bench.entries[k];
    if (root.accuracy.value_or(0) < 0) {
      bench.verdicts.refute(ClaimKind::accuracy, "a bound on a distance is not negative", k + 1);
    }
    if (!is_finite(entry.x)) {
      entry.is_refuted = true;
      bench.verdicts.refute(ClaimKind::root, "the zero vector is no point of projective space",
                            k + 1);
    } else if (entry.is_regular) {
      judge_regular(bench, entry, root, k + 1);
    }
    judge_certified(bench, entry, root, k + 1);
  }
}

}  // namespace moivre

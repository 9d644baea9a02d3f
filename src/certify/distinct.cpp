// SPDX-License-Identifier: MIT
// The sweep over projections, the exact comparison of a pair, and more bits where it stays in
// doubt.
#include "moivre/certify/distinct.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "moivre/numeric/random.h"
#include "moivre/numeric/rational.h"
#include "upward.h"

namespace moivre {
namespace {

struct Difference {
  Rational re, im;
  Rational norm() const { return re * re + im * im; }
};

/// m_a - m_b in coordinate j, exactly.
Difference difference(const Certificate& a, const Certificate& b, std::size_t j) {
  Difference d{Rational(a.midpoint[j].real()) - Rational(b.midpoint[j].real()),
               Rational(a.midpoint[j].imag()) - Rational(b.midpoint[j].imag())};
  for (const Point& part : a.finer) {
    d.re += Rational(part[j].real());
    d.im += Rational(part[j].imag());
  }
  for (const Point& part : b.finer) {
    d.re -= Rational(part[j].real());
    d.im -= Rational(part[j].imag());
  }
  return d;
}

/// m_a - m_b in coordinate j as double has it, and what may be missing: what certificates know
/// beyond double.
struct RoundedDifference {
  Complex d;
  double beyond = 0;
};

RoundedDifference rounded_difference(const Certificate& a, const Certificate& b, std::size_t j) {
  RoundedDifference result{a.midpoint[j] - b.midpoint[j]};
  for (const Certificate* c : {&a, &b}) {
    for (const Point& part : c->finer) result.beyond += size_bound(part[j]);
  }
  return result;
}

/// What double shows needs no fractions. `raised` covers the rounding of the difference.
bool are_apart_in_double(const Certificate& a, const Certificate& b) {
  for (std::size_t j = 0; j < a.midpoint.size(); ++j) {
    const auto [d, beyond] = rounded_difference(a, b, j);
    const double least = std::max(std::abs(d.real()), std::abs(d.imag()));
    if (least > raised(a.error(j) + b.error(j) + beyond)) return true;
  }
  return false;
}

/// The root of a lies in the ball of b.
bool lies_within_in_double(const Certificate& a, const Certificate& b) {
  for (std::size_t j = 0; j < a.midpoint.size(); ++j) {
    const auto [d, beyond] = rounded_difference(a, b, j);
    if (!(raised(size_bound(d) + a.error(j) + beyond) <= b.radius(j))) return false;
  }
  return true;
}

/// The root of a lies in the ball of b; norms: |m_a - m_b|_j^2.
bool lies_within(const Certificate& a, const Certificate& b, const std::vector<Rational>& norms) {
  for (std::size_t j = 0; j < norms.size(); ++j) {
    if (a.error(j) > b.radius(j)) return false;
    const Rational room = Rational(b.radius(j)) - Rational(a.error(j));
    if (norms[j] > room * room) return false;
  }
  return true;
}

/// An interval that the projection of a root lies in.
struct Shadow {
  double least, most;
};

/// Projects on a random direction, in which every coordinate of the certificates counts alike.
class Projection {
 public:
  Projection(std::span<const Certificate* const> certificates, std::uint64_t seed) {
    std::vector<double> sizes;
    for (const Certificate* c : certificates) {
      if (!c->holds_root()) continue;
      sizes.resize(c->midpoint.size());
      for (std::size_t j = 0; j < sizes.size(); ++j) {
        sizes[j] = std::max(sizes[j], modulus(c->midpoint[j]));
      }
    }
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      direction_.push_back(random_phase(seed, RandomStream::certify, j) /
                           (sizes[j] > 0 ? sizes[j] : 1));
    }
  }

  Shadow of(const Certificate& c) const {
    // The share of each term covers its rounding, that of the sum, and the parts of the midpoint
    // beyond double.
    const double share = 8 * kUnitRoundoff * static_cast<double>(direction_.size() + 8);
    double middle = 0;
    double reach = 0;
    for (std::size_t j = 0; j < direction_.size(); ++j) {
      const double weight = size_bound(direction_[j]);
      middle += conjugate_product(direction_[j], c.midpoint[j]).real();
      reach += raised(weight * (c.error(j) + share * size_bound(c.midpoint[j])));
    }
    return {middle - reach, middle + reach};
  }

 private:
  std::vector<Complex> direction_;
};

/// Lower ends of shadows and places of their certificates, ascending; of those that hold a root.
std::vector<std::pair<double, std::size_t>> lower_ends(
    std::span<const Certificate* const> certificates, const Projection& projection) {
  std::vector<std::pair<double, std::size_t>> result;
  result.reserve(certificates.size());
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    if (!certificates[k]->holds_root()) continue;
    result.emplace_back(projection.of(*certificates[k]).least, k);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t root_of(std::vector<std::size_t>& first_of, std::size_t k) {
  while (first_of[k] != k) k = first_of[k] = first_of[first_of[k]];
  return k;
}

void join(std::vector<std::size_t>& first_of, const IndexPair& pair) {
  const std::size_t a = root_of(first_of, pair.first);
  const std::size_t b = root_of(first_of, pair.second);
  first_of[std::max(a, b)] = std::min(a, b);
}

/// Drops doubts that chains of the same pairs settle, and counts the roots; what is in doubt counts
/// as one.
void settle(std::span<const Certificate* const> certificates, Distinctness& result) {
  for (std::size_t& first : result.first_of) first = root_of(result.first_of, first);
  std::erase_if(result.doubtful, [&](const IndexPair& pair) {
    return result.first_of[pair.first] == result.first_of[pair.second];
  });
  std::sort(result.same.begin(), result.same.end());
  std::sort(result.doubtful.begin(), result.doubtful.end());
  std::vector<std::size_t> first_of = result.first_of;
  for (const IndexPair& pair : result.doubtful) join(first_of, pair);
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    if (certificates[k]->holds_root() && first_of[k] == k) ++result.distinct_roots;
  }
}

}  // namespace

Relation relation(const Certificate& a, const Certificate& b) {
  if (are_apart_in_double(a, b)) return Relation::distinct;
  if (lies_within_in_double(a, b) || lies_within_in_double(b, a)) return Relation::same;
  std::vector<Rational> norms;
  for (std::size_t j = 0; j < a.midpoint.size(); ++j) {
    norms.push_back(difference(a, b, j).norm());
    const Rational reach = Rational(a.error(j)) + Rational(b.error(j));
    if (norms.back() > reach * reach) return Relation::distinct;
  }
  const bool is_same = lies_within(a, b, norms) || lies_within(b, a, norms);
  return is_same ? Relation::same : Relation::doubtful;
}

Distinctness compare(std::span<const Certificate> certificates, std::uint64_t seed) {
  std::vector<const Certificate*> all;
  all.reserve(certificates.size());
  for (const Certificate& c : certificates) all.push_back(&c);
  return compare(all, seed);
}

Distinctness compare(std::span<const Certificate* const> certificates, std::uint64_t seed) {
  Distinctness result;
  result.first_of.resize(certificates.size());
  std::iota(result.first_of.begin(), result.first_of.end(), std::size_t{0});
  const Projection projection(certificates, seed);
  // Few are active at a time: where they end is not kept of all.
  std::vector<std::pair<double, std::size_t>> active;
  for (const auto& [least, k] : lower_ends(certificates, projection)) {
    ++result.holding;
    std::erase_if(active, [least = least](const auto& end) { return end.first < least; });
    for (const auto& [most, other] : active) {
      const IndexPair pair = std::minmax(other, k);
      const Relation found = relation(*certificates[pair.first], *certificates[pair.second]);
      if (found == Relation::doubtful) result.doubtful.push_back(pair);
      if (found != Relation::same) continue;
      result.same.push_back(pair);
      join(result.first_of, pair);
    }
    active.emplace_back(projection.of(*certificates[k]).most, k);
  }
  settle(certificates, result);
  return result;
}

Distinctness tell_apart(Certifier& certifier, std::span<Certificate> certificates,
                        std::uint64_t seed) {
  Distinctness result = compare(certificates, seed);
  while (!result.doubtful.empty()) {
    std::set<std::size_t> in_doubt;
    for (const IndexPair& pair : result.doubtful) {
      in_doubt.insert(pair.first);
      in_doubt.insert(pair.second);
    }
    bool sharper = false;
    for (const std::size_t k : in_doubt) {
      const int bits = std::max(2 * certificates[k].bits, kFirstArbBits);
      if (bits > certifier.most_bits()) continue;
      sharper = certifier.sharpen(certificates[k], bits) || sharper;
    }
    if (!sharper) return result;
    result = compare(certificates, seed);
  }
  return result;
}

}  // namespace moivre
